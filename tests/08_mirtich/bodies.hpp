#pragma once
/// @file
/// Polyhedra that the specs of this chapter try.

#include <cstddef>
#include <vector>

#include "08_mirtich/contract.hpp"
#include "08_mirtich/shapes.hpp"
#include "objects/mesh_edits.hpp"
#include "objects/shapes.hpp"
#include "reference/exact_moments.hpp"

namespace tumble::judge {

using ::mirtich::Polyhedron;

inline Polyhedron polyhedron_of(const PolygonMesh& mesh) {
  Polyhedron body{mesh.vertices, {}};
  for (int f = 0; f < mesh.face_count(); ++f)
    body.faces.emplace_back(mesh.face(f).begin(), mesh.face(f).end());
  return body;
}

inline PolygonMesh mesh_of(const Polyhedron& body) {
  PolygonMesh mesh;
  mesh.vertices = body.vertices;
  for (const std::vector<int>& face : body.faces) mesh.add_face(face);
  return mesh;
}

/// A straight prism over a star of n corners, turned in any way, its foot around `middle`.
inline PolygonMesh any_prism(int n, const Vec3& middle, double size = 1) {
  std::vector<Eigen::Vector2d> base;
  for (const Vec3& x : any_star(n, size)) base.emplace_back(x.head<2>());
  const double height = size * any_number(0.3, 1);
  return shapes::mapped(shapes::prism(base, height), any_rotation(), middle);
}

/// A tetrahedron with any four corners that are not nearly in one plane.
inline PolygonMesh any_tetrahedron(double size = 1) {
  Mat3 edges;
  do edges << any_vector(size), any_vector(size), any_vector(size);
  while (edges.determinant() < 0.2 * size * size * size);
  return shapes::mapped(shapes::unit_tetrahedron(), edges, any_vector(size));
}

/// How many corners all faces have together.
inline double corner_count(const Polyhedron& body) {
  std::size_t n = 0;
  for (const std::vector<int>& face : body.faces) n += face.size();
  return static_cast<double>(n);
}

inline double farthest(const Polyhedron& body) { return farthest(body.vertices); }

}  // namespace tumble::judge
