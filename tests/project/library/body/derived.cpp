#include "tumble/body/derived.hpp"

#include <doctest/doctest.h>

#include "project/harness/relative_error.hpp"
#include "project/library/body/random_state.hpp"
#include "tumble/quaternion/exp_log.hpp"
#include "tumble/rotation/exp.hpp"

using namespace tumble;
using test::body, test::eps, test::random_state;

TEST_CASE("derived: a worked number, a quarter turn swaps the moments that L meets") {
  // Turned by 90° about z the body's y axis (I = 2) lies along −x of the world.
  const Quat quarter = exp_quaternion(Vec3(0, 0, std::numbers::pi / 2));
  const Derived<> now = derived(body, {Vec3(1, 2, 3), quarter, Vec3(4, 0, 0), Vec3(6, 0, 0)});
  CHECK((now.v - Vec3(2, 0, 0)).norm() == 0);
  CHECK((now.omega - Vec3(3, 0, 0)).norm() <= 8 * eps);
  CHECK((now.x - Vec3(1, 2, 3)).norm() == 0);
}

TEST_CASE("derived: ω = I⁻¹ L with the world's tensor I = R I_body Rᵀ") {
  test::Random rng(121);
  for (int i = 0; i < 100; ++i) {
    const RigidBodyState<> state = random_state(rng);
    const Derived<> now = derived(body, state);
    const Mat3 I = now.R * body.I_body() * now.R.transpose();
    CHECK((I * now.omega - state.L).norm() <= 32 * eps * state.L.norm());
    CHECK((angular_momentum(body, now.R, now.omega) - state.L).norm() <= 32 * eps * state.L.norm());
  }
}

TEST_CASE("derived: a quaternion that has drifted in length is the same motion") {
  test::Random rng(122);
  const RigidBodyState<> state = random_state(rng);
  RigidBodyState<> drifted = state;
  drifted.q.coeffs() *= 1.01;
  CHECK((derived(body, drifted).omega - derived(body, state).omega).norm() <= 32 * eps);
}

TEST_CASE("state_of_motion: has the velocities it was asked for") {
  test::Random rng(123);
  for (int i = 0; i < 100; ++i) {
    const Vec3 x = rng.vector(), v = rng.vector(), omega = rng.vector();
    const Quat q = exp_quaternion<double>(3 * rng.vector());
    const Derived<> now = derived(body, state_of_motion(body, x, q, v, omega));
    CHECK((now.v - v).norm() <= 2 * eps * v.norm());
    CHECK((now.omega - omega).norm() <= 64 * eps * omega.norm());
  }
}

TEST_CASE("point_velocity: is the derivative of point_position") {
  test::Random rng(124);
  constexpr double h = 1e-5;  // central difference: h² |ω|³ / 6 and eps/h
  for (int i = 0; i < 50; ++i) {
    const Derived<> now = derived(body, random_state(rng));
    const Vec3 p_body = rng.vector();
    const auto moved = [&](double t) {
      Derived<> later = now;
      later.x += t * now.v;
      later.R = exp_rotation<double>(t * now.omega) * now.R;
      return point_position(later, p_body);
    };
    const Vec3 slope = (moved(h) - moved(-h)) / (2 * h);
    CHECK((point_velocity(now, p_body) - slope).norm() <= h * h * 10 + 16 * eps / h);
  }
}

TEST_CASE("kinetic_energy: is the sum of ½ m v² over the points of the body") {
  // Four pairs of points that have exactly this mass and these moments about the centre.
  test::Random rng(125);
  const Vec3 moments(1, 2, 2.5);
  const Vec3 second = (moments.sum() / 2 - moments.array()).matrix();  // ∫ x², ∫ y², ∫ z²
  const RigidBodyState<> state = random_state(rng);
  const Derived<> now = derived(body, state);
  const double m = body.mass() / 6;
  double energy = 0;
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) {
      const Vec3 p_body = side * std::sqrt(second[axis] / (2 * m)) * Vec3::Unit(axis);
      energy += m / 2 * point_velocity(now, p_body).squaredNorm();
    }
  CHECK(test::relative_error(kinetic_energy(body, state), energy) <= 64 * eps);
}
