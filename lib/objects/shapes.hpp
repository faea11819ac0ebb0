#pragma once
/// @file
/// Closed meshes of simple shapes, to try things on.

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "tumble/mesh/polygon_mesh.hpp"

namespace tumble::shapes {

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

/// Corners (0,0,0), (1,0,0), (0,1,0), (0,0,1).
inline PolygonMesh unit_tetrahedron() {
  PolygonMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.add_face({0, 2, 1});
  mesh.add_face({0, 1, 3});
  mesh.add_face({0, 3, 2});
  mesh.add_face({1, 2, 3});
  return mesh;
}

/// A straight prism from z = 0 to `height` over a polygon in the xy plane (counter-clockwise).
inline PolygonMesh prism(const std::vector<Eigen::Vector2d>& base, double height) {
  const int n = static_cast<int>(base.size());
  PolygonMesh mesh;
  for (const double z : {0.0, height})
    for (const Eigen::Vector2d& p : base) mesh.vertices.push_back({p.x(), p.y(), z});
  std::vector<int> bottom, top;
  for (int i = 0; i < n; ++i) {
    bottom.push_back(n - 1 - i);
    top.push_back(n + i);
    mesh.add_face({i, (i + 1) % n, n + (i + 1) % n, n + i});
  }
  mesh.add_face(bottom);
  mesh.add_face(top);
  return mesh;
}

/// A box with its middle in the origin, of six quads.
inline PolygonMesh box_mesh(const Vec3& size) {
  const double x = size.x() / 2, y = size.y() / 2;
  PolygonMesh mesh = prism({{-x, -y}, {x, -y}, {x, y}, {-x, y}}, size.z());
  for (Vec3& v : mesh.vertices) v.z() -= size.z() / 2;
  return mesh;
}

/// The cube [−h, h]³ of n × n squares a side, each of two right triangles: 12 n² in all, equal
/// ones.
inline PolygonMesh regular_cube(int n, double h) {
  PolygonMesh mesh;
  std::map<std::array<int, 3>, int> number;  // by place in the grid
  const auto at = [&](const std::array<int, 3>& place) {
    const auto [it, is_new] = number.try_emplace(place, static_cast<int>(mesh.vertices.size()));
    if (is_new)
      mesh.vertices.push_back((Vec3(place[0], place[1], place[2]) * (2 * h / n)).array() - h);
    return it->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const int side : {0, n})
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          const auto corner = [&](int di, int dj) {
            std::array<int, 3> place{};
            place[axis] = side;
            place[(axis + 1) % 3] = i + di;
            place[(axis + 2) % 3] = j + dj;
            return at(place);
          };
          const int a = corner(0, 0), c = corner(1, 1);
          const int b = side ? corner(1, 0) : corner(0, 1), d = side ? corner(0, 1) : corner(1, 0);
          mesh.add_face({a, b, c});
          mesh.add_face({a, c, d});
        }
  return mesh;
}

/// A torus around z of n × k quads that are not planar; R to the middle of the tube, r its radius.
inline PolygonMesh torus_mesh(int n, int k, double R, double r) {
  constexpr double pi = std::numbers::pi;
  PolygonMesh mesh;
  const auto index = [&](int i, int j) { return (i % n) * k + j % k; };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < k; ++j) {
      const double u = 2 * pi * i / n, v = 2 * pi * j / k, across = R + r * std::cos(v);
      mesh.vertices.push_back({across * std::cos(u), across * std::sin(u), r * std::sin(v)});
      mesh.add_face({index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)});
    }
  }
  return mesh;
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

}  // namespace tumble::shapes
