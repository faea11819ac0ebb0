#pragma once
/// @file
/// Which of many bodies can touch at all: those whose bounds overlap.
///
/// Sort the bounds along an axis by where they begin, and sweep: a box has to be compared only with
/// those that begin before it ends. The axis is the one along which the fewest intervals overlap,
/// which sorting alone tells. Source: Shamos & Hoey, "Geometric intersection problems", FOCS 1976;
/// Baraff, "Dynamic simulation of non-penetrating rigid bodies", PhD thesis, Cornell (1992), §6.

#include <algorithm>
#include <array>
#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "tumble/collide/bounds.hpp"

namespace tumble::collide {

/// @addtogroup collide
/// @{

/// The numbers of two bodies, the smaller one first.
struct Pair {
  int first, second;
  // clang-tidy 14 takes a number in it for a pointer.
  friend auto operator<=>(const Pair&, const Pair&) = default;  // NOLINT(modernize-use-nullptr)
};

/// What a search for pairs cost.
struct SweepCost {
  int axis = 0;                  ///< the axis that was swept along
  std::int64_t comparisons = 0;  ///< of two boxes: as many as intervals overlap along that axis
};

/// @}

}  // namespace tumble::collide

namespace tumble::collide::detail {

/// @throws std::invalid_argument if one is empty or not finite, naming it
void require_bounds(std::span<const Bounds> bounds);

/// How many pairs of intervals overlap: each begins before as many as have begun when it ends.
std::int64_t overlaps_along(std::span<const Bounds> bounds, int axis);

}  // namespace tumble::collide::detail

namespace tumble::collide {

/// @addtogroup collide
/// @{

/// Shows `visit(first, second)` each pair whose bounds overlap, once, the smaller number first. The
/// pairs come in the order of the sweep. Bounds that only touch overlap.
/// @throws std::invalid_argument if bounds are empty or not finite
template <class Visit>
SweepCost sort_and_sweep(std::span<const Bounds> bounds, const Visit& visit) {
  detail::require_bounds(bounds);
  const std::array<std::int64_t, 3> overlaps{detail::overlaps_along(bounds, 0),
                                             detail::overlaps_along(bounds, 1),
                                             detail::overlaps_along(bounds, 2)};
  SweepCost cost;
  cost.axis =
      static_cast<int>(std::min_element(overlaps.begin(), overlaps.end()) - overlaps.begin());
  std::vector<int> order(bounds.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
  const auto box = [&](int i) -> const Bounds& { return bounds[static_cast<std::size_t>(i)]; };
  std::sort(order.begin(), order.end(),
            [&](int i, int j) { return box(i).min()[cost.axis] < box(j).min()[cost.axis]; });
  for (auto i = order.begin(); i != order.end(); ++i)
    for (auto j = i + 1; j != order.end(); ++j) {
      if (box(*j).min()[cost.axis] > box(*i).max()[cost.axis]) break;
      ++cost.comparisons;
      if (box(*i).intersects(box(*j))) visit(std::min(*i, *j), std::max(*i, *j));
    }
  return cost;
}

/// The pairs whose bounds overlap, in ascending order. Bounds that only touch overlap.
/// @throws std::invalid_argument if bounds are empty or not finite
std::vector<Pair> overlapping_pairs(std::span<const Bounds> bounds);

/// @}

}  // namespace tumble::collide

#ifndef TUMBLE_COMPILED
#include "tumble/collide/sort_and_sweep.inl"
#endif
