// A point of the body hangs on a spring with a strong damper: the part along the spring is over in
// microseconds, and the body swings about its anchor for seconds.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "project/harness/refusal.hpp"
#include "tumble/simulate/simulate.hpp"

using namespace tumble;

namespace {

struct DampedScene {
  double mass, damping, stiffness, rest_length, span, tolerance;

  Trajectory simulated(double part_of_tolerance) const {
    const RigidBody<> body(mass, Mat3(Vec3(1, 2, 2.5).asDiagonal()));
    RigidBodyState<> start;
    start.x = Vec3(0.3, -0.6, 0.2);
    start.q = Quat(0.5, -0.3, 0.7, 0.4).normalized();
    start.P = Vec3(0.8, 0, 0);
    start.L = Vec3(-0.5, 0.9, 0.4);
    const SpringToWorld spring{Vec3(0.1, 0.2, 0.3), Vec3(0, 0, 1), stiffness, rest_length, damping};
    return simulate(body, start, {0, span, part_of_tolerance * tolerance}, spring);
  }
};

/// The largest difference of x, P, L and of the orientation.
double difference_of(const Trajectory& a, const Trajectory& b, double span) {
  double most = 0, x = 0, P = 0, L = 0;
  constexpr int moments = 97;  // most of them inside steps
  for (int i = 0; i <= moments; ++i) {
    const RigidBodyState<> state = b.at(span * i / moments);
    x = std::max(x, state.x.norm());
    P = std::max(P, state.P.norm());
    L = std::max(L, state.L.norm());
  }
  for (int i = 0; i <= moments; ++i) {
    const RigidBodyState<> one = a.at(span * i / moments), other = b.at(span * i / moments);
    most = std::max({most, (one.x - other.x).norm() / x, (one.P - other.P).norm() / P,
                     (one.L - other.L).norm() / L, 2 * (one.q.conjugate() * other.q).vec().norm()});
  }
  return most;
}

}  // namespace

// x in metres, and P in what the force could make of it, once had one size in common: the Jacobian
// was one of other places, and Newton's method did not converge.
TEST_CASE("stiff scenes: a strong damper, at every moment") {
  for (const DampedScene& scene :
       {DampedScene{1, 2e5, 11382, 0, 3, 2e-5}, DampedScene{3, 2e5, 615'038, 0.5, 9, 1e-3},
        DampedScene{0.5, 614'198, 1.5, 0.5, 0.52, 1e-4}, DampedScene{1, 8e6, 173, 0, 3, 1e-4},
        DampedScene{2, 6e7, 28'000, 0.5, 1, 1e-3}}) {
    CAPTURE(scene.damping);
    const Trajectory motion = scene.simulated(1), finer = scene.simulated(1e-3);
    CHECK(motion.report().method == "Radau IIA 5");
    CHECK(motion.report().reached());
    // Two runs may be a little closer to each other than to the truth: by 1.2 at most here.
    CHECK(difference_of(motion, finer, scene.span) <=
          1.5 * (motion.report().error_estimate + finer.report().error_estimate));
  }
}

TEST_CASE("stiff scenes: where forces have no values any more, at() says so, and ends") {
  bool broken = false;
  const auto braked = [&](double, const RigidBody<>&, const Derived<>& now) -> Wrench<> {
    return {-1e6 * now.v - (broken ? std::sqrt(-1) : 1e4) * now.x, -10 * now.omega};
  };
  RigidBodyState<> start;
  start.x = Vec3(1, 0, 0);
  const Trajectory motion =
      simulate(RigidBody<>(1, Mat3::Identity()), start, {0, 500, 1e-6}, braked);
  REQUIRE(motion.report().method == "Radau IIA 5");
  const double inside = 123.456;
  CHECK(motion.at(inside).x.allFinite());
  broken = true;
  CHECK(test::mentions(test::message_of<std::runtime_error>([&] { motion.at(inside); }),
                       "no step is short enough"));
}
