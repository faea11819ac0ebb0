#pragma once

#include "tumble/mesh/check_faces.hpp"

#include <algorithm>
#include <sstream>

#include "tumble/core/compiled.hpp"
#include "tumble/core/rounding.hpp"
#include "tumble/mesh/orientation.hpp"

namespace tumble::detail {

TUMBLE_BODY std::vector<MeshDefect> find_bad_indices(const PolygonMesh& mesh) {
  std::vector<MeshDefect> findings;
  MeshDefectsOfOneKind bad(MeshDefectKind::index_out_of_range);
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
  int all_exist = 1;  // no way out of the loop: then the compiler makes packs of it
  for (const int v : mesh.corners) all_exist &= exists(v);
  if (all_exist) return findings;
  for (int f = 0; f < mesh.face_count(); ++f)
    for (const int v : mesh.face(f))
      if (!exists(v))
        bad.add(f, {-1, -1}, [&] {
          return "face #" + std::to_string(f + 1) + " has vertex #" + std::to_string(v + 1LL) +
                 (vertex_count == 0
                      ? ", but the mesh has no vertices"
                      : ", but the mesh has vertices #1 to #" + std::to_string(vertex_count));
        });
  bad.append_to(findings);
  return findings;
}

TUMBLE_BODY std::vector<MeshDefect> find_not_finite(const PolygonMesh& mesh) {
  MeshDefectsOfOneKind bad(MeshDefectKind::not_finite);
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    // x − x is 0 for a finite x, NaN otherwise
    const Vec3& p = mesh.vertices[i];
    if ((p.x() - p.x()) + (p.y() - p.y()) + (p.z() - p.z()) == 0) continue;
    const int v = static_cast<int>(i);
    bad.add(-1, {v, v}, [&] { return describe_vertex(mesh, v) + " is not at a finite position"; });
  }
  std::vector<MeshDefect> findings;
  bad.append_to(findings);
  return findings;
}

TUMBLE_BODY bool has_no_area(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 u = b - a, v = c - a, n = u.cross(v);
  // Rounding moves no component of n by more than 8 ε |u| |v|: only below it the exact
  // test is needed.
  const double bound = 8 * unit_roundoff * u.lpNorm<1>() * v.lpNorm<1>();
  return !(n.lpNorm<1>() > bound) && collinear(a, b, c);
}

TUMBLE_BODY bool has_no_area(const PolygonMesh& mesh, std::span<const int> face) {
  for (std::size_t k = 2; k < face.size(); ++k)
    if (!has_no_area(mesh.vertex(face[0]), mesh.vertex(face[k - 1]), mesh.vertex(face[k])))
      return false;
  return true;
}

TUMBLE_BODY int repeated_vertex(std::span<const int> face) {
  if (face.size() == 3) {  // most are: without memory of their own
    if (face[1] == face[2]) return face[1];
    return face[0] == face[1] || face[0] == face[2] ? face[0] : -1;
  }
  std::vector<int> sorted(face.begin(), face.end());
  std::sort(sorted.begin(), sorted.end());
  const auto repeated = std::adjacent_find(sorted.begin(), sorted.end());
  return repeated == sorted.end() ? -1 : *repeated;
}

TUMBLE_BODY const char* degeneracy(const PolygonMesh& mesh, std::span<const int> face) {
  if (face.size() < 3) return "has fewer than 3 corners";
  if (repeated_vertex(face) >= 0) return "has the same vertex at two corners";
  return has_no_area(mesh, face) ? "has an area of exactly 0" : nullptr;
}

TUMBLE_BODY bool has_short_faces(const PolygonMesh& mesh) {
  int any = 0;
  for (std::size_t f = 1; f < mesh.first_corner.size(); ++f)
    any |= mesh.first_corner[f] - mesh.first_corner[f - 1] < 3;
  return any;
}

TUMBLE_BODY std::string described_corners(const PolygonMesh& mesh, std::span<const int> face) {
  if (const int twice = repeated_vertex(face); face.size() >= 3 && twice >= 0)
    return ": " + describe_vertex(mesh, twice);
  std::string text;
  for (std::size_t k = 0; k < face.size() && k < 3; ++k)
    text += (k == 0 ? ": " : ", ") + describe_vertex(mesh, face[k]);
  return text;
}

TUMBLE_BODY std::vector<MeshDefect> find_degenerate_faces(const PolygonMesh& mesh) {
  MeshDefectsOfOneKind bad(MeshDefectKind::degenerate_face);
  for (int f = 0; f < mesh.face_count(); ++f) {
    const char* what = degeneracy(mesh, mesh.face(f));
    if (what == nullptr) continue;
    bad.add(f, {-1, -1}, [&] {
      const std::string text = "face #" + std::to_string(f + 1) + " " + what;
      return text + described_corners(mesh, mesh.face(f));
    });
  }
  std::vector<MeshDefect> findings;
  bad.append_to(findings);
  return findings;
}

TUMBLE_BODY Planarity planarity(const PolygonMesh& mesh, std::span<const int> face) {
  const Vec3& first = mesh.vertex(face[0]);
  Vec3 area = Vec3::Zero(), mean = Vec3::Zero();  // from the first corner
  Planarity result{0, 0, 0};
  for (std::size_t k = 1; k < face.size(); ++k) {
    const Vec3 r = mesh.vertex(face[k]) - first;
    result.size = std::max(result.size, r.norm());
    mean += r / static_cast<double>(face.size());
    if (k > 1) area += (mesh.vertex(face[k - 1]) - first).cross(r);
  }
  const Vec3 n = area.normalized();
  for (const int v : face)
    result.distance = std::max(result.distance, std::abs(n.dot(mesh.vertex(v) - first - mean)));
  // Each corner, itself rounded to ε |x|, and each product move the area by a few ε |x| size: the
  // normal of a thin face is turned.
  const double x = result.size + first.lpNorm<1>();
  const double turned =
      8 * unit_roundoff * static_cast<double>(face.size()) * x * result.size / area.norm();
  result.rounding = turned * result.size;
  return result;
}

TUMBLE_BODY std::vector<MeshDefect> find_nonplanar_faces(const PolygonMesh& mesh) {
  MeshDefectsOfOneKind bad(MeshDefectKind::nonplanar_face);
  const std::size_t faces = mesh.first_corner.size() - 1;
  if (mesh.corners.size() == 3 * faces && !has_short_faces(mesh)) return {};  // all triangles
  for (int f = 0; f < mesh.face_count(); ++f) {
    const std::span<const int> face = mesh.face(f);
    if (face.size() < 4) continue;
    const Planarity found = planarity(mesh, face);
    if (!(found.distance > 1e-6 * found.size + found.rounding)) continue;
    bad.add(f, {-1, -1}, [&] {
      std::ostringstream text;
      text.precision(3);
      text << "face #" << f + 1 << " is not plane: its " << face.size() << " corners are up to "
           << found.distance << " m (" << 100 * found.distance / found.size
           << " % of its size) from a plane; it counts as triangles from its first corner";
      return text.str();
    });
  }
  std::vector<MeshDefect> findings;
  bad.append_to(findings);
  return findings;
}

}  // namespace tumble::detail
