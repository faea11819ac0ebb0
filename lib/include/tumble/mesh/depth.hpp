#pragma once
/// @file
/// Does the surface of a closed mesh bound a body? Going along any line the depth, 0 outside, must
/// go 0, 1, 0, 1, …, 0: a part that looks inwards makes it −1; parts that overlap, or lie inside
/// another with the same orientation, make it 2, and every integral would count them twice.
///
/// The lines are some thousand along each axis, and one through each part: whatever is wrong with a
/// whole part is found for certain, a crossing only when a line meets it.

#include <algorithm>
#include <climits>
#include <cstdlib>
#include <span>
#include <vector>

#include "tumble/mesh/line_hits.hpp"

namespace tumble::detail {

/// A piece of a line where the depth is neither 0 nor 1.
struct WrongDepth {
  int depth;         ///< what it is there
  LineHit here;      ///< the crossing after which it is so
  LineHit before;    ///< the crossing where the body was entered before; `here` again if it was not
  std::size_t line;  ///< number of the line
  double length = 0;  ///< of the piece [m]

  /// How often it counts that should not, or should and does not.
  int excess() const { return std::abs(depth - std::clamp(depth, 0, 1)); }
};

/// What the lines say about one part.
struct PartDepth {
  int least_around = INT_MAX;  ///< the depth due to the other parts, where a line meets this one
  int most_around = INT_MIN;
  bool crosses_itself = false;

  bool crosses_another() const { return least_around < most_around; }
};

/// Calls `visit(hits at one height)`, from below, for the hits of one line. Heights that
/// rounding may have exchanged are one height: where parts touch, the order of leaving and
/// entering means nothing.
template <class Visit>
void for_each_height(std::span<const LineHit> hits, Visit&& visit) {
  for (std::size_t i = 0, j = 0; i < hits.size(); i = j) {
    double top = hits[i].z + hits[i].error;
    for (j = i + 1; j < hits.size() && hits[j].z - hits[j].error <= top; ++j)
      top = std::max(top, hits[j].z + hits[j].error);
    visit(hits.subspan(i, j - i));
  }
}

/// All pieces of the lines where the depth is wrong, up to the next height.
inline std::vector<WrongDepth> find_wrong_depths(const LineHits& hits) {
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

/// Whether each of the faces at one height is met as often from both sides: beside a concave
/// polygon its fan of triangles covers nothing.
inline bool cancel(std::span<const LineHit> height) {
  return std::all_of(height.begin(), height.end(), [&](const LineHit& hit) {
    int sum = 0;
    for (const LineHit& other : height) sum += other.face == hit.face ? other.direction : 0;
    return sum == 0;
  });
}

/// For each part, how deep inside the others it lies, and whether it crosses itself: adds to
/// `result` what some lines say.
inline void measure_parts(const LineHits& hits, const Components& surface,
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
