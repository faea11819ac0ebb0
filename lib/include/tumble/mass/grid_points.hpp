#pragma once
/// @file
/// The centres of n × n × n equal cells of the unit cube: ((i + ½)/n, (j + ½)/n, (k + ½)/n).

#include "tumble/core/require.hpp"
#include "tumble/mass/sample_points.hpp"

namespace tumble::sampling {

/// @addtogroup mass
/// @{

/// A regular grid of n³ points, x fastest.
class GridPoints {
 public:
  /// @param per_axis n
  /// @throws std::invalid_argument if n is not in 1 … 2 000 000 (n³ has to fit an integer)
  explicit GridPoints(int per_axis) : n_(per_axis) {
    require(n_ > 0 && n_ <= 2'000'000, "the number of grid points per axis is ", n_,
            ", not in 1 … 2000000");
  }

  std::int64_t count() const { return std::int64_t{n_} * n_ * n_; }

  Vec3 next() {
    Vec3 point = (Vec3(i_, j_, k_) + Vec3::Constant(0.5)) / n_;
    if (++i_ == n_) {
      i_ = 0;
      ++j_;
    }
    if (j_ == n_) {
      j_ = 0;
      ++k_;
    }
    return point;
  }

 private:
  int n_, i_ = 0, j_ = 0, k_ = 0;
};

/// @}

}  // namespace tumble::sampling
