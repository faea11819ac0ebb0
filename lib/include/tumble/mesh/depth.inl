#pragma once

#include "tumble/core/compiled.hpp"
#include "tumble/mesh/depth.hpp"

namespace tumble::detail {

TUMBLE_BODY std::vector<WrongDepth> find_wrong_depths(const LineHits& hits) {
  std::vector<WrongDepth> wrong;
  std::vector<LineHit> entered;  // where the body was entered and not left again
  for (std::size_t i = 0; i < hits.line_count(); ++i) {
    int depth = 0;
    double last = 0;  // height of the hit before
    entered.clear();
    for_each_height(hits.of_line(i), [&](std::span<const LineHit> height) {
      if (depth != 0 && depth != 1) wrong.back().length = height.front().z - last;
      last = height.back().z;
      for (const LineHit& hit : height) {
        depth += hit.direction;
        if (hit.direction > 0)
          entered.push_back(hit);
        else if (!entered.empty())
          entered.pop_back();
      }
      if (depth == 0 || depth == 1) return;
      const LineHit& before = entered.size() > 1 ? entered[entered.size() - 2] : height.back();
      wrong.push_back({depth, depth > 1 ? entered.back() : height.back(), before, i});
    });
  }
  return wrong;
}

TUMBLE_BODY bool cancel(std::span<const LineHit> height) {
  return std::all_of(height.begin(), height.end(), [&](const LineHit& hit) {
    int sum = 0;
    for (const LineHit& other : height) sum += other.face == hit.face ? other.direction : 0;
    return sum == 0;
  });
}

TUMBLE_BODY void measure_parts(const LineHits& hits, const Components& surface,
                               std::vector<PartDepth>& result) {
  std::vector<int> own(surface.parts.size(), 0);  // depth due to each part alone
  for (std::size_t i = 0; i < hits.line_count(); ++i) {
    int depth = 0;
    for_each_height(hits.of_line(i), [&](std::span<const LineHit> height) {
      const auto part = [](const LineHit& hit) { return static_cast<std::size_t>(hit.part); };
      const bool alone =
          !cancel(height) && std::all_of(height.begin(), height.end(), [&](const LineHit& hit) {
            return hit.part == height.front().part;
          });
      PartDepth& first = result[part(height.front())];
      const int around = depth - own[part(height.front())];
      if (alone) first.least_around = std::min(first.least_around, around);
      if (alone) first.most_around = std::max(first.most_around, around);
      for (const LineHit& hit : height) {
        depth += hit.direction;
        own[part(hit)] += hit.direction;
      }
      for (const LineHit& hit : height) {
        const int outward = surface.parts[part(hit)].volume < 0 ? -1 : 1;
        if (own[part(hit)] != 0 && own[part(hit)] != outward)
          result[part(hit)].crosses_itself = true;
      }
    });
    for (const LineHit& hit : hits.of_line(i)) own[static_cast<std::size_t>(hit.part)] = 0;
  }
}

}  // namespace tumble::detail
