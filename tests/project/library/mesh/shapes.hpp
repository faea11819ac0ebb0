#pragma once
/// @file
/// Meshes to try things on, and slow but correct measures of them.

#include <cmath>
#include <map>

#include "objects/mesh_edits.hpp"
#include "objects/shapes.hpp"
#include "tumble/mesh/polygon_mesh.hpp"

namespace tumble::test {

using namespace shapes;

/// Volume enclosed [m³], in long double, from the first vertex.
inline double volume(const PolygonMesh& mesh) {
  using Vec = Vector3<long double>;
  long double sum = 0;
  const Vec o = mesh.vertices.front().cast<long double>();
  for_each_triangle(mesh, [&](int, const std::array<int, 3>& t) {
    const Vec a = mesh.vertex(t[0]).cast<long double>() - o;
    const Vec b = mesh.vertex(t[1]).cast<long double>() - o;
    const Vec c = mesh.vertex(t[2]).cast<long double>() - o;
    sum += a.dot(b.cross(c));
  });
  return static_cast<double>(sum / 6);
}

/// What a file with so many decimals gives.
inline PolygonMesh with_decimals(PolygonMesh mesh, int places) {
  if (places > 15) return mesh;
  const double power = std::pow(10, places);
  for (Vec3& p : mesh.vertices)
    for (double& x : p) x = std::round(x * power) / power;
  return mesh;
}

/// V − E + F of the vertices in use: 2 per sphere-like part, 2 less per handle.
inline int euler_characteristic(const PolygonMesh& mesh) {
  std::map<int, int> used;
  for (const int v : mesh.corners) ++used[v];
  // In a closed mesh each edge is two directed ones, one a corner.
  return static_cast<int>(used.size()) - static_cast<int>(mesh.corners.size()) / 2 +
         mesh.face_count();
}

}  // namespace tumble::test
