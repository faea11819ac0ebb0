#pragma once

#include "tumble/collide/sort_and_sweep.hpp"
#include "tumble/core/compiled.hpp"
#include "tumble/core/require.hpp"

namespace tumble::collide::detail {

TUMBLE_BODY void require_bounds(std::span<const Bounds> bounds) {
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    require(bounds[i].min().allFinite() && bounds[i].max().allFinite(), "bounds ", i,
            " are not finite");
    require(!bounds[i].isEmpty(), "bounds ", i, " end before they begin");
  }
}

TUMBLE_BODY std::int64_t overlaps_along(std::span<const Bounds> bounds, int axis) {
  std::vector<double> begins, ends;
  for (const Bounds& box : bounds) {
    begins.push_back(box.min()[axis]);
    ends.push_back(box.max()[axis]);
  }
  std::sort(begins.begin(), begins.end());
  std::sort(ends.begin(), ends.end());
  std::int64_t pairs = 0, begun = 0, ended = 0;
  const auto count = static_cast<std::int64_t>(bounds.size());
  for (; begun < count; ++begun) {
    const double begin = begins[static_cast<std::size_t>(begun)];
    while (ends[static_cast<std::size_t>(ended)] < begin) ++ended;
    pairs += begun - ended;
  }
  return pairs;
}

}  // namespace tumble::collide::detail

namespace tumble::collide {

TUMBLE_BODY std::vector<Pair> overlapping_pairs(std::span<const Bounds> bounds) {
  std::vector<Pair> pairs;
  sort_and_sweep(bounds, [&](int first, int second) { pairs.push_back({first, second}); });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace tumble::collide
