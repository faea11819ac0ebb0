#pragma once
/// @file
/// Tetrahedra whose volume is known exactly, however thin they are.

#include <array>

#include "common.hpp"

namespace mirtich_chapter {

__extension__ typedef __int128 Whole;

/// A tetrahedron whose corners have whole coordinates (in a unit of 2⁻⁴⁰ m), and so a volume that
/// is known exactly: a sixth of the determinant of its edges.
struct LatticeTetrahedron {
  PolygonMesh mesh;
  simd::DoubleDouble volume;
};

inline Whole determinant(const Mat3& edges) {
  const auto at = [&](int i, int j) { return static_cast<Whole>(edges(i, j)); };
  Whole sum = 0;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    sum += at(i, 0) * (at(j, 1) * at(k, 2) - at(k, 1) * at(j, 2));
  }
  return sum;
}

/// @param R     how it lies
/// @param sizes of the box that it fills before it is turned [m], at most 1
inline LatticeTetrahedron lattice_tetrahedron(const Mat3& R, const Vec3& sizes) {
  const std::array<Vec3, 4> shape{Vec3(-0.5, -0.3, -0.2), Vec3(0.5, -0.4, 0.1),
                                  Vec3(0.1, 0.5, -0.3), Vec3(-0.2, 0.1, 0.5)};
  PolygonMesh mesh;
  for (const Vec3& corner : shape) {
    const Vec3 x = R * sizes.cwiseProduct(corner) * 0x1p40;
    mesh.vertices.push_back(x.unaryExpr([](double number) { return std::round(number); }));
  }
  Mat3 edges;
  for (int k = 0; k < 3; ++k) edges.col(k) = mesh.vertex(k + 1) - mesh.vertex(0);
  const Whole volume = determinant(edges);
  const double hi = static_cast<double>(volume);
  const double lo = static_cast<double>(volume - static_cast<Whole>(hi));
  for (Vec3& x : mesh.vertices) x *= 0x1p-40;
  for (const std::array<int, 3>& face : {std::array{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}})
    mesh.add_face(face);
  return {mesh, simd::DoubleDouble(hi * 0x1p-120, lo * 0x1p-120) / 6};
}

}  // namespace mirtich_chapter
