#pragma once
/// @file
/// A mesh on which lines are drawn again and again, each time near another place.

#include <array>
#include <optional>
#include <vector>

#include "tumble/mesh/line_hits.hpp"
#include "tumble/mesh/part_overlaps.hpp"
#include "tumble/mesh/triangle_columns.hpp"

namespace tumble::detail {

/// What is known of a mesh before the first place is looked at.
class SearchedMesh {
 public:
  /// @param box  around all vertices; like the mesh and its parts, it has to live as long as this
  /// @param blur how far rounding may have moved a coordinate of a vertex [m]
  SearchedMesh(const PolygonMesh& mesh, const Components& surface, const Eigen::AlignedBox3d& box,
               double blur)
      : mesh_(mesh),
        surface_(surface),
        box_(box),
        blur_(blur),
        parts_(boxed_parts(mesh, surface)) {}
  SearchedMesh(const SearchedMesh&) = delete;
  SearchedMesh& operator=(const SearchedMesh&) = delete;

  const PolygonMesh& mesh() const { return mesh_; }
  const Components& surface() const { return surface_; }
  const Eigen::AlignedBox3d& box() const { return box_; }
  LinesOnMesh lines(const View& view) const { return {mesh_, surface_, view, blur_}; }

  int part_of_face(int face) const { return surface_.of(mesh_.face(face)[0]); }
  const Eigen::AlignedBox3d& box_of_part(int part) const {
    return parts_[static_cast<std::size_t>(part)].box;
  }
  /// The triangles that may be over some of a rectangle of a view.
  std::vector<FaceTriangle> over(const View& view, const Rectangle& where) {
    constexpr int few = 3 * 2;  // places, along each axis: to sort the triangles costs more
    if (triangles_.empty()) triangles_ = face_triangles(mesh_);
    if (asked_++ < few) return those_over(mesh_, triangles_, view, where);
    auto& columns = columns_[static_cast<std::size_t>(view.axis)];
    if (!columns) columns.emplace(mesh_, triangles_, view, box_);
    return columns->over(where);
  }

 private:
  const PolygonMesh& mesh_;
  const Components& surface_;
  const Eigen::AlignedBox3d& box_;
  double blur_;
  std::vector<BoxedTriangle> parts_;
  // Made when places are looked at closely: a large crossing needs neither.
  std::vector<FaceTriangle> triangles_;
  int asked_ = 0;
  std::array<std::optional<TriangleColumns>, 3> columns_;
};

}  // namespace tumble::detail
