#pragma once
/// @file
/// Which triangles of a mesh lie over a small piece of a view? A grid over the view knows, so that
/// to look closely at a place costs nothing for the rest of the mesh.

#include <vector>

#include "tumble/mesh/near_lines.hpp"
#include "tumble/mesh/polygon_mesh.hpp"
#include "tumble/mesh/view.hpp"
#include "tumble/mesh/xy_grid.hpp"

namespace tumble::detail {

/// All triangles of a mesh.
std::vector<FaceTriangle> face_triangles(const PolygonMesh& mesh);

/// Those that may be over some of a rectangle of a view, looked for one by one.
/// @param triangles of the mesh
std::vector<FaceTriangle> those_over(const PolygonMesh& mesh,
                                     const std::vector<FaceTriangle>& triangles, const View& view,
                                     const Rectangle& where);

/// The triangles of a mesh, sorted into the columns of a grid over a view.
class TriangleColumns {
 public:
  /// @param triangles of the mesh; they have to live as long as this
  /// @param box       around the mesh
  TriangleColumns(const PolygonMesh& mesh, const std::vector<FaceTriangle>& triangles,
                  const View& view, const Eigen::AlignedBox3d& box);

  /// Those that may be over some of a rectangle of the view, in the order of the mesh.
  std::vector<FaceTriangle> over(const Rectangle& where) const;

 private:
  static constexpr int wide = 64;  ///< columns: what is over more is looked at every time

  Rectangle rectangle(std::size_t i) const;
  /// The numbers of those in the columns of a rectangle, in any order, some more than once.
  std::vector<int> candidates(const Rectangle& where) const;
  CellRange columns_of(const Rectangle& r) const;
  static bool is_wide(const CellRange& columns) {
    return (columns.x1 - columns.x0 + 1.0) * (columns.y1 - columns.y0 + 1.0) > wide;
  }

  const PolygonMesh& mesh_;
  const std::vector<FaceTriangle>& triangles_;
  View view_;
  XyGrid grid_;
  std::vector<int> wide_;
  XyBins bins_;
};

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/mesh/triangle_columns.inl"
#endif
