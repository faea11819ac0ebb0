#pragma once
/// @file
/// Point masses and inertia tensors to try the units of chapter 6 on.

#include <vector>

#include "05_momentum/contract.hpp"
#include "judge/spec/inputs.hpp"
#include "tumble/core/types.hpp"

namespace tumble::judge {

/// A point's or a vector's products: r rᵀ.
inline Mat3 outer(const Vec3& r) { return r * r.transpose(); }

/// Σ m over some points.
inline double mass_of(const std::vector<momentum::PointMass>& points) {
  double sum = 0;
  for (const auto& point : points) sum += point.mass;
  return sum;
}

/// Points with masses of 0.1 to 5 kg in a cube.
inline std::vector<momentum::PointMass> any_points(int n, double size = 3) {
  std::vector<momentum::PointMass> points;
  for (int i = 0; i < n; ++i) points.push_back({any_number(0.1, 5), any_vector(size)});
  return points;
}

/// The symmetric matrix with these values along the columns of a rotation, exactly symmetric.
inline Mat3 symmetric(const Vec3& values, const Mat3& axes) {
  const Mat3 M = axes * values.asDiagonal() * axes.transpose();
  return (M + M.transpose()) / 2;
}

/// Moments about the principal axes that some body has: sums of two of three positive numbers.
inline Vec3 any_moments() {
  const double x = any_number(0.2, 2), y = any_number(0.2, 2), z = any_number(0.2, 2);
  return {y + z, z + x, x + y};
}

/// The inertia tensor of any body about its centre of mass, in any axes.
inline Mat3 any_inertia() {
  const Vec3 moments = any_moments();
  return symmetric(moments, any_rotation());
}

}  // namespace tumble::judge
