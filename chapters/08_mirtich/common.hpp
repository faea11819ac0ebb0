#pragma once
/// @file
/// What all parts of this chapter's program share: bodies, and the sum over triangles one by one.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "objects/mesh_edits.hpp"
#include "support/random.hpp"
#include "support/sketch.hpp"
#include "support/table.hpp"
#include "tumble/mass/mesh_mass_properties.hpp"
#include "tumble/mass/mirtich/mirtich.hpp"
#include "tumble/mass/mirtich/volume_integrals.hpp"
#include "tumble/mass/tetrahedron.hpp"
#include "tumble/mesh/reference_point.hpp"
#include "tumble/rotation.hpp"

namespace mirtich_chapter {

using namespace tumble;
using shapes::triangulated;
using support::error_number;
using support::error_or_rounding;
using support::number;
using support::Random;
using support::Table;
using support::Vec2;

constexpr double pi = std::numbers::pi, degree = pi / 180;

// ── Bodies ──

/// The box from 0 to 1 along each column of `edges`, of six quadrilaterals.
inline PolygonMesh skewed_box(const Mat3& edges, const Vec3& origin = Vec3::Zero()) {
  PolygonMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.vertices.push_back(origin + edges * Vec3(i & 1, i >> 1 & 1, i >> 2 & 1));
  for (const std::array<int, 4>& face : {std::array{0, 2, 3, 1},
                                         {4, 5, 7, 6},
                                         {0, 1, 5, 4},
                                         {2, 6, 7, 3},
                                         {0, 4, 6, 2},
                                         {1, 3, 7, 5}})
    mesh.add_face(face);
  return mesh;
}

inline PolygonMesh cube(double size = 1, const Vec3& origin = Vec3::Zero()) {
  return skewed_box(size * Mat3::Identity(), origin);
}

inline PolygonMesh moved(PolygonMesh mesh, const Vec3& d) {
  for (Vec3& x : mesh.vertices) x += d;
  return mesh;
}

constexpr double ring_radius = 1, tube_radius = 0.4;  // of the torus [m]

/// A torus around z, of 4 k² triangles.
inline PolygonMesh torus(int k) {
  const int n = 2 * k;
  PolygonMesh mesh;
  const auto index = [&](int i, int j) { return (i % n) * k + j % k; };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < k; ++j) {
      const double u = 2 * pi * i / n, v = 2 * pi * j / k;
      const double across = ring_radius + tube_radius * std::cos(v);
      mesh.vertices.emplace_back(across * std::cos(u), across * std::sin(u),
                                 tube_radius * std::sin(v));
      mesh.add_face({index(i, j), index(i + 1, j), index(i + 1, j + 1)});
      mesh.add_face({index(i, j), index(i + 1, j + 1), index(i, j + 1)});
    }
  return mesh;
}

// ── Integrals ──

/// One thread, and no instructions but those that every machine of the family has: the same bits
/// everywhere.
inline const simd::LoopOptions anywhere{1, simd::InstructionSet::baseline};

inline BoundedMassProperties computed(const PolygonMesh& mesh, Accuracy accuracy) {
  return unchecked_mass_properties(mesh, 1, accuracy, anywhere);
}

template <class T>
using Point = simd::Point<T>;

/// 6V by the corners alone, as in many programs.
template <class T>
T six_volume_of_corners(const Point<T>& a, const Point<T>& b, const Point<T>& c) {
  return simd::dot<simd::Fma::separate>(simd::cross(a, b), c);
}

/// 6V by edges, as in the library.
template <class T>
T six_volume_of_edges(const Point<T>& a, const Point<T>& b, const Point<T>& c) {
  return simd::six_volume<simd::Fma::separate>(a, b, c);
}

/// The sum over all tetrahedra with apex p, one after the other, in numbers of any kind.
/// @param six_volume 6V from three corners, seen from p
template <class T>
MassProperties one_by_one(const PolygonMesh& mesh, const Vec3& p,
                          T (*six_volume)(const Point<T>&, const Point<T>&, const Point<T>&)) {
  const auto from_p = [&](int v) -> Point<T> {
    const Vec3& x = mesh.vertex(v);
    return {T(x.x()) - T(p.x()), T(x.y()) - T(p.y()), T(x.z()) - T(p.z())};
  };
  Moments<T> sum;
  for_each_triangle(mesh, [&](int, const std::array<int, 3>& t) {
    const Point<T> a = from_p(t[0]), b = from_p(t[1]), c = from_p(t[2]);
    sum += detail::raw_moments<simd::Fma::separate>(six_volume(a, b, c), a, b, c);
  });
  Moments<simd::DoubleDouble> all;
  return mass_properties(detail::with_factors(all += sum), p, 1);
}

/// The plain loop of many programs, about a point of the body.
inline MassProperties plain_loop(const PolygonMesh& mesh) {
  return one_by_one<double>(mesh, detail::reference_point(mesh), six_volume_of_edges);
}

/// The truth: each operation in 32 digits.
inline MassProperties exact(const PolygonMesh& mesh) {
  return one_by_one<simd::DoubleDouble>(mesh, detail::reference_point(mesh), six_volume_of_edges);
}

inline double mass_error(const MassProperties& found, const MassProperties& truth) {
  return std::abs(found.mass / truth.mass - 1);
}

inline double inertia_error(const MassProperties& found, const MassProperties& truth) {
  return (found.inertia - truth.inertia).norm() / truth.inertia.norm();
}

}  // namespace mirtich_chapter
