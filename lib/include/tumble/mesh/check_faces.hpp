#pragma once
/// @file
/// The faces one by one: do their vertices exist, are they numbers, is there an area?

#include <span>
#include <string>
#include <vector>

#include "tumble/mesh/mesh_defect.hpp"

namespace tumble::detail {

/// Finds corners that name no vertex. Nothing else may be asked of a mesh that has any.
std::vector<MeshDefect> find_bad_indices(const PolygonMesh& mesh);

/// Finds vertices, used or not, with a coordinate that is NaN or infinite.
std::vector<MeshDefect> find_not_finite(const PolygonMesh& mesh);

/// Whether a triangle has an area of exactly 0.
bool has_no_area(const Vec3& a, const Vec3& b, const Vec3& c);

/// Whether all triangles of a face have an area of exactly 0.
bool has_no_area(const PolygonMesh& mesh, std::span<const int> face);

/// The vertex that a face has at two corners; −1 if there is none.
int repeated_vertex(std::span<const int> face);

/// What is degenerate about a face, in words; null when nothing is.
const char* degeneracy(const PolygonMesh& mesh, std::span<const int> face);

/// Whether a face has less than three corners.
bool has_short_faces(const PolygonMesh& mesh);

/// ": vertex #4 at (…)", the vertex that is there twice, or else the first three.
std::string described_corners(const PolygonMesh& mesh, std::span<const int> face);

/// Finds faces without area.
std::vector<MeshDefect> find_degenerate_faces(const PolygonMesh& mesh);

/// How a polygon lies to a plane.
struct Planarity {
  double distance;  ///< of a corner from the plane, at most [m]
  double size;      ///< of a corner from the first one, at most [m]
  double rounding;  ///< what rounding, of the corners too, may have done to `distance` [m]
};

/// Measures against the plane through the mean of the corners, across their vector area (Newell).
Planarity planarity(const PolygonMesh& mesh, std::span<const int> face);

/// Finds polygons that are not plane by more than a millionth of their size: what a file with seven
/// digits makes of a plane one is not told.
std::vector<MeshDefect> find_nonplanar_faces(const PolygonMesh& mesh);

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/mesh/check_faces.inl"
#endif
