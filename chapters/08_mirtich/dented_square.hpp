#pragma once
/// @file
/// A square of side 4 with a dent from the right: to be walked round on paper.

#include <utility>

#include "common.hpp"

namespace mirtich_chapter {

/// Counter-clockwise.
inline const std::vector<Vec2> dented_square{{0, 0}, {4, 0}, {2, 2}, {4, 4}, {0, 4}};

inline std::pair<Vec2, Vec2> edge_of_dented_square(std::size_t k) {
  return {dented_square[k], dented_square[(k + 1) % dented_square.size()]};
}

inline std::string corner_text(const Vec2& p) {
  return "(" + number(p.x()) + ", " + number(p.y()) + ")";
}

inline std::string edge_text(const Vec2& p, const Vec2& q) {
  return corner_text(p) + " → " + corner_text(q);
}

}  // namespace mirtich_chapter
