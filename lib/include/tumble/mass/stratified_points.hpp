#pragma once
/// @file
/// One random point in each of n × n × n equal cells of the unit cube ("jittered").
///
/// A mean over N = n³ of them is as right on average as one over random points, and scatters less:
/// a cell that is wholly inside or outside adds no chance, only the about N^(2/3) cells on the
/// surface do. The error of a volume falls with N^(−2/3). Source: Haber, "A modified Monte-Carlo
/// quadrature", Math. Comp. 20 (1966).

#include "tumble/core/random_fraction.hpp"
#include "tumble/core/require.hpp"
#include "tumble/mass/sample_points.hpp"

namespace tumble::sampling {

/// @addtogroup mass
/// @{

/// n³ points, one somewhere in each cell of a regular grid, x fastest.
class StratifiedPoints {
 public:
  /// @param per_axis n
  /// @param seed     the same seed gives the same points
  /// @throws std::invalid_argument if n is not in 1 … 2 000 000 (n³ has to fit an integer)
  explicit StratifiedPoints(int per_axis, std::uint64_t seed = 1) : n_(per_axis), engine_(seed) {
    require(n_ > 0 && n_ <= 2'000'000, "the number of stratified points per axis is ", n_,
            ", not in 1 … 2000000");
  }

  std::int64_t count() const { return std::int64_t{n_} * n_ * n_; }

  Vec3 next() {
    const double x = detail::random_fraction_of_part(engine_, i_, n_);
    const double y = detail::random_fraction_of_part(engine_, j_, n_);
    const double z = detail::random_fraction_of_part(engine_, k_, n_);
    if (++i_ == n_) {
      i_ = 0;
      ++j_;
    }
    if (j_ == n_) {
      j_ = 0;
      ++k_;
    }
    return {x, y, z};
  }

 private:
  int n_, i_ = 0, j_ = 0, k_ = 0;
  std::mt19937_64 engine_;
};

/// @}

}  // namespace tumble::sampling
