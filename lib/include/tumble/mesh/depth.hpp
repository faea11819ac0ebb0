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

  /// The place in the world at a fraction of the piece.
  Vec3 place(double fraction) const {
    Vec3 p;
    p[here.view.world(0)] = here.line.x();
    p[here.view.world(1)] = here.line.y();
    p[here.view.axis] = here.z + fraction * length;
    return p;
  }
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
std::vector<WrongDepth> find_wrong_depths(const LineHits& hits);

/// Whether each of the faces at one height is met as often from both sides: beside a concave
/// polygon its fan of triangles covers nothing.
bool cancel(std::span<const LineHit> height);

/// For each part, how deep inside the others it lies, and whether it crosses itself: adds to
/// `result` what some lines say.
void measure_parts(const LineHits& hits, const Components& surface, std::vector<PartDepth>& result);

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/mesh/depth.inl"
#endif
