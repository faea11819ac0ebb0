#pragma once
/// @file
/// The family of point sets that a solid is sampled with: points of the unit cube, one
/// after the other.
///
/// - GridPoints (grid_points.hpp): cell centres; smooth shapes about n^(−2/3), but blind along its
///   planes: n^(−1/3) for a flat face that is parallel to them
/// - RandomPoints (random_points.hpp): n^(−1/2), with an error estimate that can be trusted
/// - StratifiedPoints (stratified_points.hpp): n^(−2/3), without a bias, one random point a cell
/// - R3Points (low_discrepancy_points.hpp): n^(−2/3), any n; the one to take

#include <concepts>
#include <cstdint>

#include "tumble/core/types.hpp"

namespace tumble::sampling {

/// @addtogroup mass
/// @{

/// `count()` points in [0, 1)³, given out by `next()`. Copies start where the original is.
template <class P>
concept SamplePoints = std::copy_constructible<P> && requires(P points, const P& constant) {
  { constant.count() } -> std::same_as<std::int64_t>;
  { points.next() } -> std::same_as<Vec3>;
};

/// @}

}  // namespace tumble::sampling
