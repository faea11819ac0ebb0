#pragma once
/// @file
/// Meshes to try things on, and a slow but correct oracle for their mass properties.

#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "tumble/mesh/polygon_mesh.hpp"

namespace tumble::test {

/// The box [low, high] of six quads.
inline PolygonMesh box(const Vec3& low, const Vec3& high) {
  PolygonMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.vertices.emplace_back((i & 1 ? high : low).x(), (i & 2 ? high : low).y(),
                               (i & 4 ? high : low).z());
  mesh.add_face({0, 2, 3, 1});
  mesh.add_face({4, 5, 7, 6});
  mesh.add_face({0, 1, 5, 4});
  mesh.add_face({2, 6, 7, 3});
  mesh.add_face({0, 4, 6, 2});
  mesh.add_face({1, 3, 7, 5});
  return mesh;
}

inline PolygonMesh cube() { return box(Vec3::Zero(), Vec3::Ones()); }

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

/// The mesh with face `which` turned round.
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

/// A sphere of radius 1: the icosahedron's triangles cut in four, `level` times; 20 ·
/// 4^level of them.
inline PolygonMesh sphere(int level) {
  PolygonMesh mesh;
  const double g = std::numbers::phi;
  for (const double s : {-1.0, 1.0})
    for (const double t : {-g, g})
      for (int k = 0; k < 3; ++k) {
        Vec3 p = Vec3::Zero();
        p[k] = s, p[(k + 1) % 3] = t;
        mesh.vertices.push_back(p.normalized());
      }
  // Faces: all triples at the shortest distance from each other, outwards.
  const double edge = 2 / std::sqrt(1 + g * g);
  const auto near = [&](int a, int b) {
    return (mesh.vertex(a) - mesh.vertex(b)).norm() < 1.1 * edge;
  };
  for (int a = 0; a < 12; ++a)
    for (int b = a + 1; b < 12; ++b)
      for (int c = b + 1; c < 12; ++c) {
        if (!near(a, b) || !near(b, c) || !near(c, a)) continue;
        const bool outwards = mesh.vertex(a).dot(mesh.vertex(b).cross(mesh.vertex(c))) > 0;
        mesh.add_face({a, outwards ? b : c, outwards ? c : b});
      }
  for (; level > 0; --level) {
    PolygonMesh finer;
    finer.vertices = mesh.vertices;
    std::map<std::pair<int, int>, int> middle;
    const auto between = [&](int a, int b) {
      const auto [place, is_new] =
          middle.try_emplace(std::minmax(a, b), static_cast<int>(finer.vertices.size()));
      if (is_new) finer.vertices.push_back((mesh.vertex(a) + mesh.vertex(b)).normalized());
      return place->second;
    };
    for (int f = 0; f < mesh.face_count(); ++f) {
      const int a = mesh.face(f)[0], b = mesh.face(f)[1], c = mesh.face(f)[2];
      const int ab = between(a, b), bc = between(b, c), ca = between(c, a);
      finer.add_face({a, ab, ca});
      finer.add_face({ab, b, bc});
      finer.add_face({ca, bc, c});
      finer.add_face({ab, bc, ca});
    }
    mesh = finer;
  }
  return mesh;
}

/// A torus round z, radii 1 and 0.4, of 2 m n triangles.
inline PolygonMesh torus(int m, int n) {
  PolygonMesh mesh;
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j) {
      const double u = 2 * std::numbers::pi * i / m, v = 2 * std::numbers::pi * j / n;
      const double r = 1 + 0.4 * std::cos(v);
      mesh.vertices.emplace_back(r * std::cos(u), r * std::sin(u), 0.4 * std::sin(v));
    }
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j) {
      const int a = i * n + j, b = (i + 1) % m * n + j;
      const int c = (i + 1) % m * n + (j + 1) % n, d = i * n + (j + 1) % n;
      mesh.add_face({a, b, c});
      mesh.add_face({a, c, d});
    }
  return mesh;
}

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

/// V − E + F of the vertices in use: 2 per sphere-like part, 2 less per handle.
inline int euler_characteristic(const PolygonMesh& mesh) {
  std::map<int, int> used;
  for (const int v : mesh.corners) ++used[v];
  // In a closed mesh each edge is two directed ones, one a corner.
  return static_cast<int>(used.size()) - static_cast<int>(mesh.corners.size()) / 2 +
         mesh.face_count();
}

}  // namespace tumble::test
