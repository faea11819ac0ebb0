// What angular drag slows, for so long that its omega leaves the range of doubles.
#include <doctest/doctest.h>

#include <cmath>
#include <stdexcept>

#include "tumble/body.hpp"
#include "tumble/simulate.hpp"
#include "tumble/steady.hpp"

using namespace tumble;

namespace {

Trajectory slowed_turn(const Vec3& omega, double drag, double duration) {
  RigidBodyState<> start;
  start.L = omega;
  SteadyForces forces;
  forces.angular_drag = drag;
  return simulate(RigidBody<>(1, Mat3::Identity()), start, {.t1 = duration, .tolerance = 1e-9},
                  forces);
}

}  // namespace

TEST_CASE("angular drag: for any time, omega is omega0 exp(-kt), and the turn omega0/k at last") {
  const Vec3 omega(1, 2, 3);
  for (const double drag : {1e-3, 1., 1e7})
    for (const double decays : {10., 100., 400., 700., 1e4, 1e9, 1e12, 1e60}) {
      CAPTURE(drag);
      CAPTURE(decays);
      const Trajectory motion = slowed_turn(omega, drag, decays / drag);
      CHECK(motion.report().reached());
      CHECK(motion.report().steps < 1e5);
      const double left = std::exp(-decays), share = -std::expm1(-decays) / drag;
      CHECK((motion.end().L - left * omega).norm() <= 1e-6 * left * omega.norm());
      const Quat turned(Eigen::AngleAxisd(share * omega.norm(), omega.normalized()));
      CHECK(motion.end().q.angularDistance(turned) <= 1e-9);
      const double t = 0.3 * decays / drag;
      const Vec3 then = std::exp(-0.3 * decays) * omega;
      CHECK((motion.at(t).L - then).norm() <= 1e-6 * then.norm() + 1e-300);
    }
}

TEST_CASE("angular drag: a film run backwards starts from hardly anything") {
  for (const double omega : {1e-30, 1e-150, 1e-200, 1e-290}) {
    CAPTURE(omega);
    const double decays = -2 * std::log10(omega), e = std::exp(decays);
    const Trajectory motion = slowed_turn(Vec3(omega, 0, 0), 1, -decays);
    CHECK(std::abs(motion.end().L.x() / (omega * e) - 1) < 1e-6);
  }
}

TEST_CASE("angular drag: a slow spin about the vertical axis of what hangs, for long") {
  SteadyForces forces;
  forces.at_point = {{Vec3(0, 0, -1), Vec3(0, 0, -1)}};
  forces.angular_drag = 1e-9;
  RigidBodyState<> start;
  start.L = Vec3(0, 0, 1e-5);
  const Trajectory motion =
      simulate(RigidBody<>(1, Mat3::Identity()), start, {.t1 = 1e8, .tolerance = 1e-9}, forces);
  CHECK(motion.report().reached());
  CHECK(std::abs(motion.end().L.z() / (1e-5 * std::exp(-0.1)) - 1) < 1e-9);
  const double angle = -1e4 * std::expm1(-0.1);
  const Quat turned(std::cos(angle / 2), 0, 0, std::sin(angle / 2));
  CHECK(motion.end().q.angularDistance(turned) < 1e-9);
}

TEST_CASE("simulate: what leaves the range of doubles is refused, not answered") {
  RigidBodyState<> start;
  start.P = Vec3(1, 0, 0);
  start.L = Vec3(1, 0, 0);
  SteadyForces forces;
  forces.force = Vec3(1e300, 0, 0);
  forces.angular_drag = 1;
  CHECK_THROWS_AS(
      simulate(RigidBody<>(1, Mat3::Identity()), start, {.t1 = 1e10, .tolerance = 1e-9}, forces),
      std::runtime_error);
}
