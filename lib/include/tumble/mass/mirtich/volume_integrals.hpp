#pragma once
/// @file
/// Mirtich's third level: integrals over a volume become sums over its faces (divergence theorem).
///
/// ∫ f dV = Σ_faces n_x ∬ F dA with ∂F/∂x = f; e.g. ∫ dV = Σ n_x ∬ x dA, ∫ x² dV = ⅓ Σ n_x ∬ x³ dA.
/// Source: Mirtich, JGT 1(2), 1996: §4.2 (theorem 2).
///
/// Where the original fails this does not: faces without area bring 0 (not NaN), the plane is that
/// of all corners (Newell), and a face that is not plane is taken as the fan of triangles from its
/// first corner, so that neighbours meet without gaps.

#include <algorithm>
#include <array>
#include <vector>

#include "tumble/core/rounding.hpp"
#include "tumble/mass/mirtich/face_integrals.hpp"
#include "tumble/mass/moments.hpp"
#include "tumble/mesh/polygon_mesh.hpp"

namespace tumble::mirtich {

/// @addtogroup mass
/// @{

/// The vector area of a polygon: its area times its normal, from all its corners (Newell) [m²].
inline Vec3 vector_area(std::span<const Vec3> corners) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 2; k < corners.size(); ++k)
    sum += (corners[k - 1] - corners[0]).cross(corners[k] - corners[0]);
  return sum / 2;
}

/// The plane through the first corner, across the vector area of all.
/// @param area vector_area(corners), not zero
inline Plane plane_of(std::span<const Vec3> corners, const Vec3& area) {
  const Vec3 n = area.normalized();
  return {n, -n.dot(corners.front())};
}

/// Whether the corners are as near to the plane as rounding alone would leave them.
///
/// n · x + w has about 8 roundings (3 in the sum, 3 in w, 2 in n) of at most eps |x|₁ each. A
/// height below that changes the volume less than its own rounding does.
inline bool is_planar(std::span<const Vec3> corners, const Plane& plane) {
  return std::all_of(corners.begin(), corners.end(), [&](const Vec3& x) {
    return !(std::abs(plane.n.dot(x) + plane.w) > 8 * detail::unit_roundoff * x.lpNorm<1>());
  });
}

/// What one plane face brings to the volume's integrals of 1, r and r rᵀ.
inline Moments<double> plane_face_moments(std::span<const Vec3> corners, const Plane& plane) {
  const int C = projection_axis(plane.n), A = (C + 1) % 3, B = (C + 2) % 3;
  const FaceIntegrals f = face_integrals(projection_integrals(corners, C), plane, C);
  const Vec3& n = plane.n;
  const double x_dA = A == 0 ? f.a : B == 0 ? f.b : f.c;
  Vec3 first, square, mixed;
  first[A] = n[A] * f.aa / 2;
  first[B] = n[B] * f.bb / 2;
  first[C] = n[C] * f.cc / 2;
  square[A] = n[A] * f.aaa / 3;
  square[B] = n[B] * f.bbb / 3;
  square[C] = n[C] * f.ccc / 3;
  mixed[A] = n[A] * f.aab / 2;
  mixed[B] = n[B] * f.bbc / 2;
  mixed[C] = n[C] * f.cca / 2;
  return {n[0] * x_dA, first[0],  first[1], first[2], square[0],
          square[1],   square[2], mixed[0], mixed[1], mixed[2]};
}

/// What a face brings: as one polygon if it is planar, else as its fan of triangles.
inline Moments<double> face_moments(std::span<const Vec3> corners) {
  Moments<double> sum;
  const Vec3 area = vector_area(corners);
  if (corners.size() > 3) {
    const bool planar = !area.isZero(0) && is_planar(corners, plane_of(corners, area));
    if (!planar) {
      for (std::size_t k = 2; k < corners.size(); ++k)
        sum += face_moments(std::array<Vec3, 3>{corners[0], corners[k - 1], corners[k]});
      return sum;
    }
  }
  if (!area.isZero(0)) sum += plane_face_moments(corners, plane_of(corners, area));
  return sum;
}

/// The integrals over the volume that a mesh encloses.
/// @param mesh      closed, faces counter-clockwise seen from outside; nothing is checked
/// @param reference the point they are about; near the body nothing cancels [m]
inline Moments<simd::DoubleDouble> volume_integrals(const PolygonMesh& mesh,
                                                    const Vec3& reference) {
  detail::BlockedMoments sum;
  std::vector<Vec3> corners;
  for (int f = 0; f < mesh.face_count(); ++f) {
    corners.clear();
    for (const int v : mesh.face(f)) corners.emplace_back(mesh.vertex(v) - reference);
    sum.add(face_moments(corners));
  }
  return sum.total();
}

/// @}

}  // namespace tumble::mirtich
