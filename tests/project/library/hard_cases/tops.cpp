// Lagrange's top, upright: above the critical spin it sleeps, below it falls.
#include <doctest/doctest.h>

#include "tumble/simulate/simulate.hpp"
#include "turning.hpp"

using namespace tumble;

namespace {

const Vec3 moments(1, 1, 0.5);
const ForceAtBodyPoint weight{Vec3(0, 0, -5), Vec3(0, 0, 1)};
const double critical = std::sqrt(4 * moments[0] * 5) / moments[2];  // [rad/s]

/// The start, leaning by `tilt`, with so much of the critical spin.
RigidBodyState<> leaning(double part, double tilt) {
  const Quat q(std::cos(tilt / 2), std::sin(tilt / 2), 0, 0);
  return {Vec3::Zero(), q, Vec3::Zero(), q * Vec3(0, 0, moments[2] * part * critical)};
}

double lean(const Quat& q) {
  const Vec3 axis = q * Vec3(0, 0, 1);
  return std::atan2(std::hypot(axis.x(), axis.y()), axis.z());
}

}  // namespace

TEST_CASE("tops: asked for 1e-9, asleep or falling, from any tilt") {
  const RigidBody<> body = test::body_with(moments);
  for (const double part : {2.0, 1.1, 1.0, 0.9, 0.5})
    for (const double tilt : {0.0, 1e-15, 1e-12, 1e-9, 1e-6, 1e-3}) {
      CAPTURE(part);
      CAPTURE(tilt);
      const RigidBodyState<> start = leaning(part, tilt);
      const auto truth =
          reference::turned({moments, start.q, start.L, weight.force, weight.p_body}, 10);
      const Trajectory motion = simulate(body, start, {0, 10, 1e-9}, weight);
      CHECK(motion.report().reached());
      CHECK(angle_between(motion.end().q, truth.q) <= 1e-9);
      if (part > 1) CHECK(lean(motion.end().q) <= 3 * tilt + 1e-9);  // asleep
    }
}

TEST_CASE("tops: exactly upright it stays so, also where it could fall") {
  for (const double part : {2.0, 0.9, 0.5}) {
    CAPTURE(part);
    const Trajectory motion =
        simulate(test::body_with(moments), leaning(part, 0), {0, 100, 1e-9}, weight);
    CHECK(motion.report().reached());
    CHECK(lean(motion.end().q) == 0);
    CHECK(motion.report().runs == 0);
    CHECK(angle_between(motion.end().q, exp_quaternion(Vec3(0, 0, 100 * part * critical))) <=
          1e-12);
  }
}

TEST_CASE("tops: balanced exactly and without spin, it stays, whatever the order of its moments") {
  for (const Vec3& unequal : {Vec3(1.3, 1.05, 0.88), Vec3(1.05, 1.3, 0.88), Vec3(0.88, 1.05, 1.3)})
    for (const double drag : {0.0, 0.01}) {
      CAPTURE(unequal.transpose());
      CAPTURE(drag);
      const Trajectory motion =
          simulate(test::body_with(unequal), {}, {0, 30, 1e-6}, weight, BodyDrag{0, drag});
      CHECK(motion.report().reached());
      CHECK(angle_between(motion.end().q, Quat::Identity()) == 0);
    }
}

TEST_CASE("tops: balanced exactly in axes that have to be turned, it says how far it falls") {
  const Mat3 R = Quat(0.9, 0.1, 0.3, -0.2).normalized().toRotationMatrix();
  const Mat3 I = R * Vec3(1.3, 1.05, 0.88).asDiagonal() * R.transpose();
  const RigidBody<> body(1, Mat3((I + I.transpose()) / 2));
  for (const double t : {1.0, 5.0, 10.0, 15.0, 20.0}) {
    CAPTURE(t);
    const Trajectory motion = simulate(body, {}, {0, t, 1e-6}, weight);
    CHECK(angle_between(motion.end().q, Quat::Identity()) <= motion.report().error_estimate);
    if (t < 8) CHECK(motion.report().reached());
  }
}

TEST_CASE("tops: let go all but upright, the fall makes more of rounding than of the tilt") {
  const Vec3 unequal(1, 1.02, 0.5);  // no closed form
  for (const double tilt : {1e-9, 1e-6, 1e-3})
    for (const double t : {2.0, 4.0, 6.0}) {
      CAPTURE(tilt);
      CAPTURE(t);
      const Quat q(1, 0.8 * tilt, -0.6 * tilt, 0.3 * tilt);
      const RigidBodyState<> start{Vec3::Zero(), q, Vec3::Zero(), Vec3::Zero()};
      const auto truth =
          reference::turned({unequal, start.q, start.L, weight.force, weight.p_body}, t);
      const RigidBody<> body = test::body_with(unequal);
      const Trajectory motion = simulate(body, start, {0, t, 1e-10}, weight);
      const double stated = motion.report().error_estimate;
      CHECK(angle_between(motion.end().q, truth.q) <= stated);
      const Vec3 L = truth.q.normalized() * Vec3(unequal.cwiseProduct(truth.omega));
      const double size = std::max(L.norm(), detail::least_sizes(body, t).angular_momentum);
      CHECK((motion.end().L - L).norm() <= stated * size);
    }
}
