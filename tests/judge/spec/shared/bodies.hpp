#pragma once
/// @file
/// Bodies and states that the specs of chapters 9 and 10 try.

#include <cmath>

#include "09_rigid_body/contract.hpp"
#include "judge/spec/spec.hpp"
#include "tumble/body/rigid_body.hpp"

namespace bodies {

using namespace tumble::judge;
using rigid_body::Body, rigid_body::Derived, rigid_body::PackedState, rigid_body::Quaternion,
    rigid_body::State;
using rigid_body::Wrench, rigid_body::WrenchAt;
using tumble::Mat3, tumble::Vec3;

/// Moments about the principal axes that some body has: sums of two of three positive numbers.
inline Vec3 any_moments() {
  const double a = any_number(0.2, 2), b = any_number(0.2, 2), c = any_number(0.2, 2);
  return {b + c, c + a, a + b};
}

/// The body with these principal moments about the columns of `axes`.
inline Body body_with(double mass, const Vec3& moments, const Mat3& axes) {
  const Mat3 I = axes * moments.asDiagonal() * axes.transpose();
  const tumble::RigidBody<> body(mass, (I + I.transpose()) / 2);
  return {body.mass(), body.I_body(), body.I_body_inv()};
}

/// The body with these principal moments about its body axes.
inline Body upright_body(double mass, const Vec3& moments) {
  return body_with(mass, moments, Mat3::Identity());
}

/// Any body, in any body axes.
inline Body any_body() {
  const double mass = any_number(0.5, 5);
  const Vec3 moments = any_moments();
  return body_with(mass, moments, any_rotation());
}

/// The largest of the sizes of v and ω, and of the 1 that R is as large as.
inline double size_of_motion(const Body& body, const State& state) {
  return std::fmax(1,
                   std::fmax(state.P.norm() / body.mass, body.I_body_inv.norm() * state.L.norm()));
}

/// What rounding may do to a number of R, v and ω. A number of R takes up to 22 roundings, so that
/// R as a matrix is off by up to 3 · 22 eps; ω goes through R twice and through the tensor once, by
/// 10 more each: some 160 eps on either side.
inline double rounding(const Body& body, const State& state) {
  return 320 * eps * size_of_motion(body, state);
}

/// A state whose quaternion has any length, with numbers of the given size.
inline State any_state(double size = 3) {
  const Vec3 x = any_vector(size);
  const Quaternion q = any_quaternion(size);
  const Vec3 P = any_vector(size), L = any_vector(size);
  return {x, q, P, L};
}

// ── Wrenches ──
// A judge looks at old questions again when it searches for a name: a wrench must hold all that it
// needs by value.

/// A wrench that gives every mistake away: it depends on the time and on every number of the state,
/// and is not linear. Each of its numbers is at most 1 + |q|.
inline WrenchAt any_wrench() {
  const double a = any_number(0.5, 1), b = any_number(0.5, 1);
  return [a, b](double t, const State& s) {
    Wrench wrench;
    for (int i = 0; i < 3; ++i) {
      const int next = (i + 1) % 3;
      wrench.force[i] = a * std::sin(2 * t + s.x[next] + i) + b * std::cos(s.P[next]) * s.q[i + 1];
      wrench.torque[i] = b * std::cos(3 * t - s.L[next] + i) + a * std::sin(s.L[i]) * s.q[i];
    }
    return wrench;
  };
}

/// The same wrench at any time and in any state.
inline WrenchAt constant_wrench(const Vec3& force, const Vec3& torque) {
  return [force, torque](double, const State&) -> Wrench { return {force, torque}; };
}

inline WrenchAt no_wrench() { return constant_wrench(Vec3::Zero(), Vec3::Zero()); }

}  // namespace bodies
