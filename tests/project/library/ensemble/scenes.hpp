#pragma once
/// @file
/// Ensembles to try things on: bodies with any axes, in any motion.

#include <vector>

#include "project/harness/inputs.hpp"
#include "tumble/ensemble/advance.hpp"
#include "tumble/quaternion/exp_log.hpp"
#include "tumble/rotation/exp.hpp"

namespace tumble::test {

struct Bodies {
  std::vector<RigidBody<>> bodies;
  std::vector<RigidBodyState<>> states;

  std::size_t size() const { return bodies.size(); }
  Ensemble ensemble() const { return {bodies, states}; }
  /// One of them alone.
  Ensemble alone(std::size_t i) const { return {{&bodies[i], 1}, {&states[i], 1}}; }
};

/// The tensor of six points of mass m/6 at ±a, ±b, ±c on axes turned by the rotation vector w: as
/// unequal as the distances are.
inline RigidBody<> body_of_points(double m, const Vec3& distances, const Vec3& w) {
  const Vec3 squares = m / 3 * distances.cwiseAbs2();
  const Vec3 moments = (squares.sum() - squares.array()).matrix();
  const Mat3 R = exp_rotation<double>(w);
  const Mat3 I = R * moments.asDiagonal() * R.transpose();
  return {m, Mat3((I + I.transpose()) / 2)};
}

/// @param spin the largest component of ω [rad/s]
inline Bodies random_bodies(int n, double spin, std::uint64_t seed) {
  Random rng(seed);
  Bodies all;
  for (int i = 0; i < n; ++i) {
    const Vec3 distances = 1.2 * Vec3::Ones() + 0.7 * rng.vector(), axes = 3 * rng.vector();
    all.bodies.push_back(body_of_points(rng.uniform(0.5, 2), distances, axes));
    const Vec3 x = rng.vector(), turn = 3 * rng.vector(), v = rng.vector();
    const Vec3 omega = spin * rng.vector();
    all.states.push_back(
        state_of_motion<double>(all.bodies.back(), x, exp_quaternion<double>(turn), v, omega));
  }
  return all;
}

/// Whether two states are the same to the last bit.
inline bool same(const RigidBodyState<>& a, const RigidBodyState<>& b) {
  return pack(a) == pack(b);
}

/// The sets of instructions that there are here.
inline std::vector<simd::InstructionSet> instruction_sets() {
  std::vector<simd::InstructionSet> sets;
  for (int i = 0; i <= static_cast<int>(simd::best_instruction_set()); ++i)
    sets.push_back(static_cast<simd::InstructionSet>(i));
  return sets;
}

/// A spring without rest length from a point of the body to the origin, stronger at some times than
/// at others, and resistance: depends on everything there is. The one for packs, …
struct Tether {
  Vec3 p_body = {0.4, -0.2, 0.7};

  template <class P>
  TUMBLE_INLINE ensemble::PackWrench<P> operator()(double t, const ensemble::PackBody<P>& body,
                                                   const ensemble::PackKinematics<P>& now) const {
    const simd::Point<P> p{P{} + p_body.x(), P{} + p_body.y(), P{} + p_body.z()};
    const simd::Point<P> arm = rotate(now.q, p), place = now.x + arm;
    const simd::Point<P> force = P((-2 - std::cos(3 * t)) * body.mass) * place - 0.3 * now.v;
    return {force, cross(arm, force) - 0.2 * now.omega};
  }
  /// … and for one body.
  Wrench<> operator()(double t, const RigidBody<>& body, const Derived<>& now) const {
    const Vec3 arm = now.R * p_body;
    const Vec3 force = (-2 - std::cos(3 * t)) * body.mass() * (now.x + arm) - 0.3 * now.v;
    return {force, arm.cross(force) - 0.2 * now.omega};
  }
};

}  // namespace tumble::test
