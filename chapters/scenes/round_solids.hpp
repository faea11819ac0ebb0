#pragma once
/// @file
/// Solids with round sides as polyhedra whose corners lie on them: to draw them, and to collide.

#include <cmath>
#include <numbers>
#include <vector>

#include "tumble/mass/solids/capsule.hpp"
#include "tumble/mass/solids/cone.hpp"
#include "tumble/mass/solids/cylinder.hpp"
#include "tumble/mass/solids/ellipsoid.hpp"
#include "tumble/mesh/polygon_mesh.hpp"

namespace tumble::scenes {

/// A polyhedron inside of a solid.
struct Polyhedron {
  PolygonMesh mesh;
  double missing;  ///< how far the solid reaches beyond it, at most [m]
};

namespace round_solids_detail {

/// A point of the outline of a solid of revolution about z.
struct OutlinePoint {
  double radius, z;  ///< [m]
};

/// How far an arc reaches beyond its chord.
inline double beyond_chord(double radius, double angle) {
  return radius * (1 - std::cos(angle / 2));
}

/// One corner on the axis, or `sides` around it.
inline std::vector<int> add_ring(PolygonMesh& mesh, const OutlinePoint& at, int sides) {
  std::vector<int> ring;
  for (int j = 0; j < (at.radius > 0 ? sides : 1); ++j) {
    const double angle = 2 * std::numbers::pi * j / sides;
    ring.push_back(static_cast<int>(mesh.vertices.size()));
    mesh.vertices.emplace_back(at.radius * std::cos(angle), at.radius * std::sin(angle), at.z);
  }
  return ring;
}

/// The band between two rings, of quads, or of triangles to a tip.
inline void join(PolygonMesh& mesh, const std::vector<int>& low, const std::vector<int>& high) {
  const std::size_t sides = std::max(low.size(), high.size());
  const auto at = [&](const std::vector<int>& ring, std::size_t j) {
    return ring[j % ring.size()];
  };
  for (std::size_t j = 0; j < sides; ++j)
    if (low.size() == 1)
      mesh.add_face({low[0], at(high, j + 1), at(high, j)});
    else if (high.size() == 1)
      mesh.add_face({at(low, j), at(low, j + 1), high[0]});
    else
      mesh.add_face({at(low, j), at(low, j + 1), at(high, j + 1), at(high, j)});
}

/// The outline turned about z, from the bottom to the top.
inline PolygonMesh turned(const std::vector<OutlinePoint>& outline, int sides) {
  PolygonMesh mesh;
  std::vector<int> below = add_ring(mesh, outline.front(), sides);
  if (below.size() > 1) mesh.add_face(std::vector<int>(below.rbegin(), below.rend()));
  for (std::size_t i = 1; i < outline.size(); ++i) {
    const std::vector<int> ring = add_ring(mesh, outline[i], sides);
    join(mesh, below, ring);
    below = ring;
  }
  if (below.size() > 1) mesh.add_face(below);
  return mesh;
}

}  // namespace round_solids_detail

/// @param sides around the axis, a multiple of 4
inline Polyhedron polyhedron_in(const Cylinder& solid, int sides) {
  using namespace round_solids_detail;
  const double r = solid.radius, h = solid.height;
  return {turned({{r, -h / 2}, {r, h / 2}}, sides), beyond_chord(r, 2 * std::numbers::pi / sides)};
}

inline Polyhedron polyhedron_in(const Cone& solid, int sides) {
  using namespace round_solids_detail;
  return {turned({{solid.radius, 0}, {0, solid.height}}, sides),
          beyond_chord(solid.radius, 2 * std::numbers::pi / sides)};
}

inline Polyhedron polyhedron_in(const Capsule& solid, int sides) {
  using namespace round_solids_detail;
  const int quarter = sides / 4;
  std::vector<OutlinePoint> outline;
  for (const int side : {-1, 1})
    for (int k = 0; k <= quarter; ++k) {
      const int from_axis = side < 0 ? k : quarter - k;
      const double angle = 2 * std::numbers::pi * from_axis / sides;
      outline.push_back({from_axis == 0 ? 0 : solid.radius * std::sin(angle),
                         side * (solid.height / 2 + solid.radius * std::cos(angle))});
      // Without a cylinder both hemispheres share their rim.
      if (solid.height == 0 && side < 0 && k == quarter) outline.pop_back();
    }
  // A point of the surface is no farther from its meridian's chord, which is no farther from a
  // face.
  return {turned(outline, sides), 2 * beyond_chord(solid.radius, 2 * std::numbers::pi / sides)};
}

inline Polyhedron polyhedron_in(const Ellipsoid& solid, int sides) {
  Polyhedron made = polyhedron_in(Capsule{1, 0}, sides);
  for (Vec3& corner : made.mesh.vertices) corner = corner.cwiseProduct(solid.radii);
  made.missing *= solid.radii.maxCoeff();
  return made;
}

}  // namespace tumble::scenes
