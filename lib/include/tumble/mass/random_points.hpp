#pragma once
/// @file
/// Independent random points of the unit cube, the same on every platform (random_fraction.hpp).

#include "tumble/core/random_fraction.hpp"
#include "tumble/core/require.hpp"
#include "tumble/mass/sample_points.hpp"

namespace tumble::sampling {

/// @addtogroup mass
/// @{

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
    const double x = detail::random_fraction(engine_), y = detail::random_fraction(engine_);
    return {x, y, detail::random_fraction(engine_)};
  }

 private:
  std::int64_t count_;
  std::mt19937_64 engine_;
};

/// @}

}  // namespace tumble::sampling
