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
