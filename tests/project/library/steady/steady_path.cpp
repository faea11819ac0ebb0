#include "tumble/steady/steady_path.hpp"

#include <doctest/doctest.h>

#include "project/harness/inputs.hpp"
#include "tumble/body/forces.hpp"

using namespace tumble;
using namespace tumble::detail;
using test::eps;

TEST_CASE("phi1 and phi2: their series near 0, their definition elsewhere, no step between") {
  for (const double y : {-30.0, -2.0, -1.0000001, -0.9999999, -0.1, -1e-9, 0.0, 1e-300, 0.5, 3.0}) {
    CAPTURE(y);
    const long double x = y, e = std::expm1(x);
    const long double one = y == 0 ? 1 : e / x;
    const long double two = std::abs(y) < 1e-3 ? 0.5L + x / 6 + x * x / 24 : (e - x) / (x * x);
    CHECK(std::abs(phi1(y) / static_cast<double>(one) - 1) < 4 * eps);
    CHECK(std::abs(phi2(y) / static_cast<double>(two) - 1) < 8 * eps);
  }
}

TEST_CASE("SteadyPath: falls, is dragged, and obeys its equation of motion") {
  const RigidBody<> body(2, Mat3::Identity());
  const RigidBodyState<> start{Vec3(1, 2, 3), Quat(1, 0, 0, 0), Vec3(4, 0, 2), Vec3::Zero()};
  const Weight weight;
  const steady::SteadyPath fall(body, start, steady_forces(body, weight));
  CHECK((fall.x(3) - (start.x + 1.5 * start.P + 4.5 * weight.g)).norm() < 16 * eps * 50);
  const SteadyForces forces = steady_forces(body, weight, BodyDrag{0.5, 0});
  const steady::SteadyPath path(body, start, forces);
  for (const double t : {0.0, 1e-9, 0.3, 5.0, 1000.0}) {
    CAPTURE(t);
    // x' = P/m and P' = F − k P/m, integrated once: P + k (x − x₀) − F t is constant.
    const Vec3 constant = path.P(t) + 0.5 * (path.x(t) - start.x) - t * forces.force;
    CHECK((constant - start.P).norm() < 16 * eps * (50 + t * 20));
  }
  CHECK((path.P(1e6) / 2 - forces.force / 0.5).norm() < 1e-12);  // the final speed
}
