#pragma once
/// @file
/// A mug far from the origin, and what is left of its digits as text.

#include "common.hpp"
#include "objects/mug.hpp"

namespace mirtich_chapter {

/// Directions along no axis.
inline const std::vector<Vec3> ways_off{Vec3(2, -3, 6) / 7, Vec3(-6, 2, 3) / 7, Vec3(4, 7, -4) / 9,
                                        Vec3(-1, -4, -8) / 9, Vec3(6, 6, 7) / 11};

/// The mug, moved by `distance` in one of them.
inline PolygonMesh mug_at(double distance, const Vec3& way = ways_off.front()) {
  return moved(objects::mug(1), distance * way);
}

/// An error, as long as anything is left, and where it is more than rounding in many terms.
inline std::string while_any(double error) {
  if (error >= 1) return "nothing left";
  return error < 1e-13 ? "< 1e-13" : error_number(error);
}

}  // namespace mirtich_chapter
