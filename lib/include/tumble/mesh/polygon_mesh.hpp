#pragma once
/// @file
/// A surface made of polygons that share vertices.

#include <array>
#include <initializer_list>
#include <span>
#include <vector>

#include "tumble/core/types.hpp"

namespace tumble {

/// @addtogroup mesh
/// @{

/// Vertices and the polygons between them. Seen from outside, the corners of a face go round
/// counter-clockwise. Faces keep the polygon they were given as: nothing is triangulated.
struct PolygonMesh {
  std::vector<Vec3> vertices;  ///< positions [m]
  std::vector<int> corners;    ///< vertex indices, face after face
  /// Face f owns corners[first_corner[f]] … corners[first_corner[f + 1] − 1].
  std::vector<int> first_corner = {0};

  int face_count() const { return static_cast<int>(first_corner.size()) - 1; }

  /// The vertex indices of face f, in order.
  std::span<const int> face(int f) const {
    const auto i = static_cast<std::size_t>(f);
    const auto begin = static_cast<std::size_t>(first_corner[i]);
    const auto end = static_cast<std::size_t>(first_corner[i + 1]);
    return std::span<const int>(corners).subspan(begin, end - begin);
  }

  const Vec3& vertex(int v) const { return vertices[static_cast<std::size_t>(v)]; }

  void add_face(std::span<const int> face_corners) {
    corners.insert(corners.end(), face_corners.begin(), face_corners.end());
    first_corner.push_back(static_cast<int>(corners.size()));
  }
  void add_face(std::initializer_list<int> face_corners) {
    add_face(std::span<const int>(face_corners.begin(), face_corners.size()));
  }
};

/// Calls `visit(f, std::array{a, b, c})` for the triangles of each face f, in a fan from its
/// first corner. For a planar face this is the face; for one that is not planar it is what
/// the face means.
template <class Visit>
void for_each_triangle(const PolygonMesh& mesh, Visit&& visit) {
  for (int f = 0; f < mesh.face_count(); ++f) {
    const std::span<const int> face = mesh.face(f);
    for (std::size_t k = 2; k < face.size(); ++k)
      visit(f, std::array<int, 3>{face[0], face[k - 1], face[k]});
  }
}

/// The smallest box along the axes that holds all vertices [m]; empty for a mesh without vertices.
Eigen::AlignedBox3d bounds(const PolygonMesh& mesh);

/// @}

}  // namespace tumble

#ifndef TUMBLE_COMPILED
#include "tumble/mesh/polygon_mesh.inl"
#endif
