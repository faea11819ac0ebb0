#pragma once
/// @file
/// Meshes to ask about: lattice bodies, whose edges and vertices can be met exactly, and what can
/// be done to them.

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "06_point_sampling/contract.hpp"
#include "judge/spec/inputs.hpp"
#include "tumble/core/types.hpp"

namespace tumble::judge {

using point_sampling::Mesh;
using Triangle = std::array<int, 3>;

inline const Vec3& vertex(const Mesh& mesh, int v) {
  return mesh.vertices[static_cast<std::size_t>(v)];
}

// ── What can be done to meshes ──

/// All parts in one mesh.
inline Mesh joined(const std::vector<Mesh>& parts) {
  Mesh all;
  for (const Mesh& part : parts) {
    const int first = static_cast<int>(all.vertices.size());
    all.vertices.insert(all.vertices.end(), part.vertices.begin(), part.vertices.end());
    for (const auto& [i, j, k] : part.triangles)
      all.triangles.push_back({first + i, first + j, first + k});
  }
  return all;
}

/// The same surface around what was outside: the wall of a cavity.
inline Mesh inside_out(Mesh mesh) {
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

/// x → A x + shift; a reflection keeps its outside outside.
inline Mesh mapped(Mesh mesh, const Mat3& A, const Vec3& shift = Vec3::Zero()) {
  for (Vec3& v : mesh.vertices) v = A * v + shift;
  return A.determinant() < 0 ? inside_out(std::move(mesh)) : mesh;
}

inline int any_index(std::size_t n) {
  return std::min(static_cast<int>(any_number(0, static_cast<double>(n))), static_cast<int>(n) - 1);
}

/// The order 0 … n − 1, shuffled.
inline std::vector<int> any_order(std::size_t n) {
  std::vector<int> order(n);
  for (std::size_t i = 0; i < n; ++i) order[i] = static_cast<int>(i);
  for (std::size_t i = n; i > 1; --i)
    std::swap(order[i - 1], order[static_cast<std::size_t>(any_index(i))]);
  return order;
}

/// The same surface, with vertices, triangles and the corners of each triangle in any order.
inline Mesh shuffled(const Mesh& mesh) {
  const std::vector<int> places = any_order(mesh.vertices.size());
  Mesh result = mesh;
  for (std::size_t v = 0; v < places.size(); ++v)
    result.vertices[static_cast<std::size_t>(places[v])] = mesh.vertices[v];
  for (Triangle& t : result.triangles) {
    for (int& v : t) v = places[static_cast<std::size_t>(v)];
    std::rotate(t.begin(), t.begin() + any_index(3), t.end());
  }
  const Mesh ordered = result;
  const std::vector<int> order = any_order(mesh.triangles.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    result.triangles[i] = ordered.triangles[static_cast<std::size_t>(order[i])];
  return result;
}

/// The axes exchanged and mirrored in one of the 48 ways: lattice points stay lattice points.
inline Mat3 any_lattice_symmetry() {
  const std::vector<int> order = any_order(3);
  Mat3 A = Mat3::Zero();
  for (int i = 0; i < 3; ++i)
    A(i, order[static_cast<std::size_t>(i)]) = any_number(-1, 1) < 0 ? -1 : 1;
  return A;
}

/// The mesh and its images under the cyclic exchange of the axes and under x → −x: six in all, one
/// for each half-axis, so that from the origin it looks the same along each of them.
inline Mesh six_times(const Mesh& mesh) {
  Mat3 cycle = Mat3::Zero();
  cycle(1, 0) = cycle(2, 1) = cycle(0, 2) = 1;
  std::vector<Mesh> images;
  Mat3 A = Mat3::Identity();
  for (int n = 0; n < 3; ++n, A = cycle * A) {
    images.push_back(mapped(mesh, A));
    images.push_back(mapped(mesh, -A));
  }
  return joined(images);
}

// ── Bodies ──

inline Mesh tetrahedron(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Mesh mesh{{a, b, c, d}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  return (b - a).dot((c - a).cross(d - a)) > 0 ? mesh : inside_out(mesh);
}

inline Mesh octahedron(double radius, const Vec3& centre = Vec3::Zero()) {
  Mesh mesh;
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {1., -1.})
      mesh.vertices.push_back(centre + sign * radius * Vec3::Unit(axis));
  for (const int x : {0, 1})
    for (const int y : {2, 3})
      for (const int z : {4, 5})
        mesh.triangles.push_back((x + y + z) % 2 == 0 ? Triangle{x, y, z} : Triangle{x, z, y});
  return mesh;
}

using Cell = std::array<int, 3>;

/// The surface of a body made of unit cubes, in lattice points. Cubes have to meet in faces.
inline Mesh cubes(const std::set<Cell>& cells) {
  Mesh mesh;
  std::map<Cell, int> numbers;
  const auto number = [&](const Cell& point) {
    const auto [place, is_new] = numbers.insert({point, static_cast<int>(mesh.vertices.size())});
    if (is_new) mesh.vertices.emplace_back(point[0], point[1], point[2]);
    return place->second;
  };
  for (const Cell& cell : cells) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const int side : {0, 1}) {
        Cell neighbour = cell;
        neighbour[axis] += 2 * side - 1;
        if (cells.contains(neighbour)) continue;
        const auto corner = [&](int u, int v) {
          Cell point = cell;
          point[axis] += side;
          point[(axis + 1) % 3] += u;
          point[(axis + 2) % 3] += v;
          return number(point);
        };
        // Counter-clockwise, seen against the axis.
        std::array<int, 4> face{corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)};
        if (side == 0) std::swap(face[1], face[3]);
        mesh.triangles.push_back({face[0], face[1], face[2]});
        mesh.triangles.push_back({face[0], face[2], face[3]});
      }
    }
  }
  return mesh;
}

/// A block of a × b × c unit cubes without some of them.
inline std::set<Cell> block_without(const Cell& size, const std::set<Cell>& holes) {
  std::set<Cell> cells;
  for (int i = 0; i < size[0]; ++i)
    for (int j = 0; j < size[1]; ++j)
      for (int k = 0; k < size[2]; ++k)
        if (!holes.contains({i, j, k})) cells.insert({i, j, k});
  return cells;
}

/// A box with the corners low and high, its faces cut along one diagonal.
inline Mesh box(const Vec3& low, const Vec3& high) {
  return mapped(cubes({{0, 0, 0}}), (high - low).asDiagonal(), low);
}

/// Lattice bodies, most of them not convex.
inline std::vector<Mesh> lattice_bodies() {
  const Mesh cube = cubes({{0, 0, 0}});
  const Mesh room = cubes(block_without({3, 3, 3}, {{1, 1, 1}}));
  const Mat3 half = Mat3::Identity() / 2;
  return {cube,
          octahedron(2),
          tetrahedron({0, 0, 0}, {3, 1, 0}, {1, 3, 0}, {1, 1, 3}),
          cubes(block_without({2, 2, 1}, {{1, 1, 0}})),                        // an L
          cubes(block_without({3, 2, 1}, {{1, 1, 0}})),                        // a U
          cubes(block_without({3, 3, 1}, {{1, 1, 0}})),                        // a frame
          cubes(block_without({3, 1, 3}, {{1, 0, 2}, {2, 0, 1}, {2, 0, 2}})),  // stairs
          room,
          joined({room, mapped(cube, half, Vec3::Constant(1.25))}),  // a thing in a closed room
          joined({cube, mapped(cube, Mat3::Identity(), {2, 0, 0})}),
          joined({octahedron(1), octahedron(1, {2.5, 0, 0}), octahedron(1, {0, 0, 2.5})})};
}

/// One of them, seen in one of the 48 ways.
inline Mesh any_lattice_body() {
  const std::vector<Mesh> all = lattice_bodies();
  const auto which = static_cast<std::size_t>(any_index(all.size()));
  return shuffled(mapped(all[which], any_lattice_symmetry()));
}

// ── Distances ──

inline double distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 edge = b - a;
  const double along = std::clamp((p - a).dot(edge) / edge.squaredNorm(), 0., 1.);
  return (p - a - along * edge).norm();
}

inline double distance_to_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 normal = (b - a).cross(c - a);
  const auto is_left = [&](const Vec3& from, const Vec3& to) {
    return normal.dot((to - from).cross(p - from)) >= 0;
  };
  if (is_left(a, b) && is_left(b, c) && is_left(c, a))
    return std::abs((p - a).dot(normal)) / normal.norm();
  return std::min(
      {distance_to_segment(p, a, b), distance_to_segment(p, b, c), distance_to_segment(p, c, a)});
}

inline double distance_to_triangle(const Mesh& mesh, const Triangle& t, const Vec3& p) {
  return distance_to_triangle(p, vertex(mesh, t[0]), vertex(mesh, t[1]), vertex(mesh, t[2]));
}

inline double distance_to_surface(const Mesh& mesh, const Vec3& p) {
  double least = std::numeric_limits<double>::infinity();
  for (const Triangle& t : mesh.triangles)
    least = std::min(least, distance_to_triangle(mesh, t, p));
  return least;
}

inline Eigen::AlignedBox3d bounds_of(const Mesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Vec3& v : mesh.vertices) box.extend(v);
  return box;
}

/// The mesh's largest extent [m].
inline double extent(const Mesh& mesh) { return bounds_of(mesh).sizes().maxCoeff(); }

/// A place in the mesh's box, or a little beyond, that is clear of the surface.
inline Vec3 any_place_near(const Mesh& mesh) {
  const Eigen::AlignedBox3d box = bounds_of(mesh);
  Vec3 p;
  do {
    p = box.center() + 0.6 * any_vector().cwiseProduct(box.sizes());
  } while (distance_to_surface(mesh, p) < 0.01 * extent(mesh));
  return p;
}

}  // namespace tumble::judge
