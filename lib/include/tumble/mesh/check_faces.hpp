#pragma once
/// @file
/// The faces one by one: do their vertices exist, are they numbers, is there an area?

#include <algorithm>
#include <span>
#include <sstream>
#include <vector>

#include "tumble/mesh/finding.hpp"
#include "tumble/mesh/orientation.hpp"

namespace tumble {

/// Finds corners that name no vertex. Nothing else may be asked of a mesh that has any.
inline std::vector<Finding> find_bad_indices(const PolygonMesh& mesh) {
  std::vector<Finding> findings;
  FindingsOfOneKind bad(FindingKind::index_out_of_range);
  const int vertex_count = static_cast<int>(mesh.vertices.size());
  // The table of faces itself: from 0 to the end, never back.
  const std::vector<int>& first = mesh.first_corner;
  if (first.empty() || first.front() != 0 ||
      first.back() != static_cast<int>(mesh.corners.size()) ||
      !std::is_sorted(first.begin(), first.end())) {
    bad.add(-1, {-1, -1}, [&] {
      return "first_corner must rise from 0 to the number of corners, " +
             std::to_string(mesh.corners.size());
    });
    bad.append_to(findings);
    return findings;
  }
  const auto exists = [=](int v) { return v >= 0 && v < vertex_count; };
  if (std::all_of(mesh.corners.begin(), mesh.corners.end(), exists)) return findings;
  for (int f = 0; f < mesh.face_count(); ++f)
    for (const int v : mesh.face(f))
      if (!exists(v))
        bad.add(f, {-1, -1}, [&] {
          return "face #" + std::to_string(f + 1) + " has vertex #" + std::to_string(v + 1LL) +
                 ", but the mesh has vertices #1 to #" + std::to_string(vertex_count);
        });
  bad.append_to(findings);
  return findings;
}

/// Finds vertices, used or not, with a coordinate that is NaN or infinite.
inline std::vector<Finding> find_not_finite(const PolygonMesh& mesh) {
  FindingsOfOneKind bad(FindingKind::not_finite);
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    // x − x is 0 for a finite x, NaN otherwise
    const Vec3& p = mesh.vertices[i];
    if ((p.x() - p.x()) + (p.y() - p.y()) + (p.z() - p.z()) == 0) continue;
    const int v = static_cast<int>(i);
    bad.add(-1, {v, v}, [&] { return describe_vertex(mesh, v) + " is not at a finite position"; });
  }
  std::vector<Finding> findings;
  bad.append_to(findings);
  return findings;
}

/// Whether a triangle has an area of exactly 0.
inline bool has_no_area(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 u = b - a, v = c - a, n = u.cross(v);
  // Rounding moves no component of n by more than 8 ε |u| |v|: only below it the exact
  // test is needed.
  constexpr double eps = 0x1p-53;
  const double bound = 8 * eps * u.lpNorm<1>() * v.lpNorm<1>();
  return !(n.lpNorm<1>() > bound) && collinear(a, b, c);
}

/// What is degenerate about a face, in words; null when nothing is.
inline const char* degeneracy(const PolygonMesh& mesh, std::span<const int> face) {
  if (face.size() < 3) return "has fewer than 3 corners";
  if (face.size() == 3) {
    if (face[0] == face[1] || face[1] == face[2] || face[2] == face[0])
      return "has the same vertex at two corners";
    return has_no_area(mesh.vertex(face[0]), mesh.vertex(face[1]), mesh.vertex(face[2]))
               ? "has an area of exactly 0"
               : nullptr;
  }
  std::vector<int> sorted(face.begin(), face.end());
  std::sort(sorted.begin(), sorted.end());
  if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
    return "has the same vertex at two corners";
  for (std::size_t k = 2; k < face.size(); ++k)
    if (!has_no_area(mesh.vertex(face[0]), mesh.vertex(face[k - 1]), mesh.vertex(face[k])))
      return nullptr;
  return "has an area of exactly 0";
}

/// Finds faces without area.
inline std::vector<Finding> find_degenerate_faces(const PolygonMesh& mesh) {
  FindingsOfOneKind bad(FindingKind::degenerate_face);
  for (int f = 0; f < mesh.face_count(); ++f) {
    const char* what = degeneracy(mesh, mesh.face(f));
    if (what == nullptr) continue;
    bad.add(f, {-1, -1}, [&] {
      std::string text = "face #" + std::to_string(f + 1) + " " + what;
      for (std::size_t k = 0; k < mesh.face(f).size() && k < 3; ++k)
        text += (k == 0 ? ": " : ", ") + describe_vertex(mesh, mesh.face(f)[k]);
      return text;
    });
  }
  std::vector<Finding> findings;
  bad.append_to(findings);
  return findings;
}

}  // namespace tumble
