#pragma once
/// @file
/// The random inputs of a spec. Those of one test case depend on the seed, the unit and the case
/// alone, so that one case can be run again by itself.

#include <Eigen/Geometry>

#include "judge/spec/session.hpp"
#include "support/random.hpp"
#include "tumble/core/rounding.hpp"
#include "tumble/core/types.hpp"

namespace tumble::judge {

/// Tolerances are written as k·eps, k the number of roundings.
inline constexpr double eps = detail::unit_roundoff;

/// The random numbers of the test case that runs.
inline support::Random& inputs() { return Session::current().random(); }

/// A number, uniform in [low, high).
inline double any_number(double low, double high) { return inputs().uniform(low, high); }

/// A vector, uniform in the cube [−size, size)³.
inline Vec3 any_vector(double size = 1) { return size * inputs().vector(); }

/// A unit vector, uniform over the directions.
inline Vec3 any_direction() { return inputs().direction(); }

/// A quaternion (w, x, y, z), every coefficient uniform in [−size, size).
inline Eigen::Vector4d any_quaternion(double size = 2) {
  const double w = inputs().uniform(-size, size);
  const Vec3 v = size * inputs().vector();
  return {w, v.x(), v.y(), v.z()};
}

/// A unit quaternion (w, x, y, z), uniform over the rotations.
inline Eigen::Vector4d any_unit_quaternion() {
  Eigen::Vector4d q = any_quaternion(1);
  while (q.squaredNorm() > 1 || q.squaredNorm() < 1e-4) q = any_quaternion(1);
  return q.normalized();
}

/// A rotation matrix, uniform over the rotations up to rounding.
inline Mat3 any_rotation() {
  const Eigen::Vector4d q = any_unit_quaternion();
  return Quat(q[0], q[1], q[2], q[3]).toRotationMatrix();
}

}  // namespace tumble::judge
