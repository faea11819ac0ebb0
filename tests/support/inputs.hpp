#pragma once
/// @file
/// The inputs that a law is tried on: the same on every platform, and always the awkward ones too.

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

#include "tumble/core/types.hpp"

namespace tumble::test {

/// Unit roundoff of double, 2⁻⁵³: tolerances are written as k·eps, k the number of roundings.
inline constexpr double eps = 0x1p-53;

/// Seeded random numbers, the same everywhere (std::*_distribution are not portable).
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  /// Uniform in [low, high).
  double uniform(double low = -1, double high = 1) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }
  /// Uniform in the cube [−1, 1)³.
  Vec3 vector() {
    const double x = uniform(), y = uniform(), z = uniform();
    return {x, y, z};
  }
  /// A direction, uniform on the sphere.
  Vec3 direction() {
    Vec3 v = vector();
    while (v.squaredNorm() > 1 || v.squaredNorm() < 1e-4) v = vector();
    return v.normalized();
  }
  /// A unit quaternion, uniform on the sphere of them.
  Quat rotation() {
    Eigen::Vector4d c(2, 0, 0, 0);
    while (c.squaredNorm() > 1 || c.squaredNorm() < 1e-4) {
      const double w = uniform();
      c << w, vector();
    }
    return Quat(c[0], c[1], c[2], c[3]).normalized();
  }

 private:
  std::mt19937_64 engine_;
};

/// Rotation vectors θ u to try a law of rotations on: zero, tiny, random, near π and at π.
inline std::vector<Vec3> rotation_vectors(std::uint64_t seed = 1, int random = 200) {
  constexpr double pi = std::numbers::pi;
  std::vector<Vec3> list{Vec3::Zero()};
  Random rng(seed);
  for (const Vec3& axis :
       {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY()), Vec3(Vec3::UnitZ()), rng.direction()}) {
    for (const double angle :
         {1e-300, 1e-16, 1e-8, 1e-4, pi / 2, pi - 1e-4, pi - 1e-8, pi - 1e-15, pi})
      list.push_back(angle * axis);
  }
  for (int i = 0; i < random; ++i) list.push_back(rng.uniform(0, pi) * rng.direction());
  return list;
}

}  // namespace tumble::test
