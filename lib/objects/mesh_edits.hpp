#pragma once
/// @file
/// A mesh with one thing changed: to compare two forms of one body, or to make a defect.

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "tumble/mesh/polygon_mesh.hpp"

namespace tumble::shapes {

/// The same surface of triangles.
inline PolygonMesh triangulated(const PolygonMesh& mesh) {
  PolygonMesh result;
  result.vertices = mesh.vertices;
  for_each_triangle(mesh, [&](int, const std::array<int, 3>& t) { result.add_face(t); });
  return result;
}

/// The same faces, seen from the other side.
inline PolygonMesh inside_out(const PolygonMesh& mesh) {
  PolygonMesh result;
  result.vertices = mesh.vertices;
  for (int f = 0; f < mesh.face_count(); ++f) {
    const std::span<const int> face = mesh.face(f);
    result.add_face(std::vector<int>(face.rbegin(), face.rend()));
  }
  return result;
}

/// Both meshes in one.
inline PolygonMesh together(PolygonMesh a, const PolygonMesh& b) {
  const int shift = static_cast<int>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (int f = 0; f < b.face_count(); ++f) {
    std::vector<int> face(b.face(f).begin(), b.face(f).end());
    for (int& v : face) v += shift;
    a.add_face(face);
  }
  return a;
}

/// The mesh, each vertex p at scale p + shift.
inline PolygonMesh moved(PolygonMesh mesh, double scale, const Vec3& shift) {
  for (Vec3& p : mesh.vertices) p = scale * p + shift;
  return mesh;
}

/// The mesh without face `skip`.
inline PolygonMesh without_face(const PolygonMesh& mesh, int skip) {
  PolygonMesh result;
  result.vertices = mesh.vertices;
  for (int f = 0; f < mesh.face_count(); ++f)
    if (f != skip) result.add_face(mesh.face(f));
  return result;
}

/// The mesh with face `which` seen from the other side.
inline PolygonMesh with_face_flipped(PolygonMesh mesh, int which) {
  const auto first = mesh.corners.begin() + mesh.first_corner[static_cast<std::size_t>(which)];
  const auto last = mesh.corners.begin() + mesh.first_corner[static_cast<std::size_t>(which) + 1];
  std::reverse(first, last);
  return mesh;
}

/// The mesh with face `which` a second time, as its last face.
inline PolygonMesh with_face_twice(PolygonMesh mesh, int which) {
  const std::vector<int> face(mesh.face(which).begin(), mesh.face(which).end());
  mesh.add_face(face);
  return mesh;
}

/// The same surface where each face has its own corners, as in an STL file.
inline PolygonMesh soup(const PolygonMesh& mesh) {
  PolygonMesh result;
  for (int f = 0; f < mesh.face_count(); ++f) {
    std::vector<int> face;
    for (const int v : mesh.face(f)) {
      face.push_back(static_cast<int>(result.vertices.size()));
      result.vertices.push_back(mesh.vertex(v));
    }
    result.add_face(face);
  }
  return result;
}

/// Every vertex x at A x + d.
inline PolygonMesh mapped(PolygonMesh mesh, const Mat3& A, const Vec3& d = Vec3::Zero()) {
  for (Vec3& x : mesh.vertices) x = A * x + d;
  return mesh;
}

}  // namespace tumble::shapes
