#pragma once
/// @file
/// Signed tetrahedra in plain doubles, for the page.

#include "common.hpp"

namespace mirtich_chapter {

/// ∫ 1, ∫ r and ∫ r rᵀ over a body.
struct Integrals {
  double one = 0;
  Vec3 r = Vec3::Zero();
  Mat3 rr = Mat3::Zero();
};

/// Six times the volume of the tetrahedron from the origin to a triangle, with its sign.
inline double six_volumes(const Vec3& a, const Vec3& b, const Vec3& c) {
  return a.dot((b - a).cross(c - a));
}

/// The factors 1/6, 1/24 and 1/120 are left out.
inline void add_tetrahedron(Integrals& sum, const Vec3& a, const Vec3& b, const Vec3& c) {
  const double D = six_volumes(a, b, c);
  const Vec3 s = a + b + c;
  sum.one += D;
  sum.r += D * s;
  sum.rr += D * (s * s.transpose() + a * a.transpose() + b * b.transpose() + c * c.transpose());
}

/// @param p the reference point: the apex of all tetrahedra
inline Integrals integrals(const PolygonMesh& mesh, const Vec3& p) {
  Integrals sum;
  for (int f = 0; f < mesh.face_count(); ++f) {
    const auto corners = mesh.face(f);
    for (std::size_t k = 2; k < corners.size(); ++k)  // the fan from its first corner
      add_tetrahedron(sum, mesh.vertex(corners[0]) - p, mesh.vertex(corners[k - 1]) - p,
                      mesh.vertex(corners[k]) - p);
  }
  return {sum.one / 6, sum.r / 24, sum.rr / 120};
}

}  // namespace mirtich_chapter
