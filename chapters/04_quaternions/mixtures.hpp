#pragma once
/// @file
/// Mixtures of two orientations: of nine numbers, of four, and of three angles. Nothing here needs
/// more than a page that draws its own figures has.

#include <cmath>
#include <numbers>

#include "tumble/quaternion/convert.hpp"
#include "tumble/rotation/euler_angles.hpp"

namespace quaternions_chapter {

using namespace tumble;

inline constexpr double pi = std::numbers::pi, degree = pi / 180;

inline Mat3 mix_nine(const Mat3& a, const Mat3& b, double t) { return (1 - t) * a + t * b; }

inline Quat mix_four(const Quat& a, const Quat& b, double t) {
  const double side = a.dot(b) < 0 ? -1 : 1;
  return Quat(Eigen::Vector4d((1 - t) * a.coeffs() + t * side * b.coeffs()));
}

/// Each angle the short way round.
inline Mat3 mix_angles(const Mat3& a, const Mat3& b, double t) {
  const Vec3 from = matrix_to_euler_angles(a, EulerSequence::zyx);
  Vec3 way = matrix_to_euler_angles(b, EulerSequence::zyx) - from;
  for (double& angle : way) angle = std::remainder(angle, 2 * pi);
  return euler_angles_to_matrix(from + t * way, EulerSequence::zyx);
}

}  // namespace quaternions_chapter
