#pragma once
/// @file
/// A direction to look along: lines parallel to any axis are vertical lines of coordinates that
/// change places in a circle.

#include "tumble/mesh/xy_grid.hpp"

namespace tumble::detail {

/// Coordinates whose third one is x, y or z of the world.
struct View {
  int axis = 2;  ///< the one that the lines run along: 0, 1, 2

  /// Which coordinate of the world is coordinate k of the view.
  int world(int k) const { return (axis + 1 + k) % 3; }
  /// Its name: across() the lines there are two, 0 and 1.
  char name(int k) const { return "xyz"[world(k)]; }

  Vec3 point(const Vec3& p) const { return {p[world(0)], p[world(1)], p[axis]}; }
  Eigen::AlignedBox3d box(const Eigen::AlignedBox3d& box) const {
    return {point(box.min()), point(box.max())};
  }
};

}  // namespace tumble::detail
