#pragma once
/// @file
/// Surfaces that stand there twice, once each way round, as files for drawing have them.
///
/// If both copies are cut into the same triangles, nothing is left: the surface is flat. If they
/// are cut along other diagonals, as quads are whose fans begin at other corners, what rounding has
/// done to the corners is left between them: a volume of 10⁻¹⁶ of the body's, known to all digits.
/// A foil may be as thin, but few of its edges have more than two faces. Of a doubled polygon of n
/// corners, however it is cut, more than a third of the edges are its own, and have four.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <sstream>
#include <vector>

#include "tumble/core/rounding.hpp"
#include "tumble/mesh/check_edges.hpp"
#include "tumble/mesh/coordinate_rounding.hpp"
#include "tumble/mesh/weld.hpp"

namespace tumble::detail {

/// The largest of all coordinates that faces use [m].
inline double largest_coordinate(const PolygonMesh& mesh) {
  double largest = 0;
  for (const int v : mesh.corners)
    largest = std::max(largest, mesh.vertex(v).lpNorm<Eigen::Infinity>());
  return largest;
}

/// The area of all faces [m²].
inline double area_of_faces(const PolygonMesh& mesh) {
  double area = 0;
  for_each_triangle(mesh, [&](int, const std::array<int, 3>& t) {
    const Vec3& a = mesh.vertex(t[0]);
    area += (mesh.vertex(t[1]) - a).cross(mesh.vertex(t[2]) - a).norm() / 2;
  });
  return area;
}

/// Whether more than a third of all edges have four faces or more, equal positions being one
/// vertex.
inline bool most_edges_are_shared_by_four(const PolygonMesh& mesh) {
  const std::vector<EdgeUse> uses = edge_uses(weld(mesh));
  std::size_t shared = 0;
  for (std::size_t i = 0, j = 0; i < uses.size(); i = j) {
    while (j < uses.size() && uses[i].same_edge(uses[j])) ++j;
    if (j - i >= 4) shared += j - i;
  }
  return 3 * shared > uses.size();
}

/// Finds that the faces of a closed surface are all there twice, once each way round.
/// @param volume   that it encloses [m³]
/// @param rounding of the coordinates, as they were written [m], if it is known
inline std::optional<MeshDefect> find_doubled_surface(const PolygonMesh& mesh, double volume,
                                                      std::optional<double> rounding) {
  constexpr double coarsest = 5e-3;  // of what coordinate_rounding() gives
  const double largest = largest_coordinate(mesh), area = area_of_faces(mesh);
  // Each corner moves by up to √3 roundings, and each copy has half of the area.
  const auto is_rounding = [&](double by) { return !(std::abs(volume) > 2 * by * area); };
  if (!is_rounding(coarsest * largest)) return {};
  const double written =
      std::max(rounding ? *rounding : coordinate_rounding(mesh), unit_roundoff * largest);
  if (!is_rounding(written) || !most_edges_are_shared_by_four(mesh)) return {};
  std::ostringstream text;
  text.precision(3);
  text << "the faces are all there twice, once each way round. They enclose " << volume
       << " m³, no more than rounding to " << written
       << " m may make of nothing: take one face of each two away";
  return MeshDefect{.kind = MeshDefectKind::flat, .face = 0, .message = text.str()};
}

}  // namespace tumble::detail
