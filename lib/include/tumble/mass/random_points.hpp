#pragma once
/// @file
/// Independent random points of the unit cube, the same on every platform.
///
/// Each coordinate is the upper 53 bits of a 64-bit Mersenne Twister, times 2⁻⁵³: standard
/// libraries differ in std::uniform_real_distribution, not in the generator. Source: Matsumoto &
/// Nishimura, "Mersenne Twister", ACM TOMACS 8(1), 1998.

#include <random>

#include "tumble/core/require.hpp"
#include "tumble/mass/sample_points.hpp"

namespace tumble {

/// n independent points, uniform in [0, 1)³.
class RandomPoints {
 public:
  /// @param seed the same seed gives the same points
  /// @throws std::invalid_argument if count ≤ 0
  explicit RandomPoints(std::int64_t count, std::uint64_t seed = 1) : count_(count), engine_(seed) {
    require(count > 0, "the number of random points is ", count, ", not positive");
  }

  std::int64_t count() const { return count_; }

  Vec3 next() {
    const double x = coordinate(), y = coordinate(), z = coordinate();
    return {x, y, z};
  }

 private:
  double coordinate() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  std::int64_t count_;
  std::mt19937_64 engine_;
};

}  // namespace tumble
