#pragma once
/// @file
/// The random numbers of programs, specs and tests.

#include <cstdint>
#include <random>

#include "tumble/core/random_fraction.hpp"
#include "tumble/core/types.hpp"

namespace tumble::support {

/// Seeded random numbers, the same everywhere (std::*_distribution are not portable).
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  /// Uniform in [low, high).
  double uniform(double low = -1, double high = 1) {
    return low + (high - low) * detail::random_fraction(engine_);
  }
  /// Uniform in the cube [low, high)³. The three numbers are drawn one after the other, whatever
  /// order a compiler gives to arguments.
  Vec3 vector(double low, double high) {
    const double x = uniform(low, high), y = uniform(low, high);
    return {x, y, uniform(low, high)};
  }
  /// Uniform in the cube [−size, size)³.
  Vec3 vector(double size = 1) { return vector(-size, size); }
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

}  // namespace tumble::support
