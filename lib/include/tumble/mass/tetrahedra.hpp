#pragma once
/// @file
/// Mass properties of a closed mesh as a sum of signed tetrahedra, one on each triangle
/// of its faces.
///
/// With the corners a, b, c about a reference point, 6V = ((b − a) × (c − a)) · a and s = a + b +
/// c: ∫ r dV = 6V/24 s,  ∫ r rᵀ dV = 6V/120 (s sᵀ + a aᵀ + b bᵀ + c cᵀ). Source: e.g. Blow &
/// Binstock, "How to find the inertia tensor (or other mass properties) of a 3D solid body
/// represented by a triangle mesh" (2004). Edges before the cross product, a reference point in the
/// middle and blocked sums are what keeps the digits.

#include "tumble/mass/error_bound.hpp"

namespace tumble {

/// 6V of the tetrahedron on the triangle a, b, c with its apex in the origin: positive if they go
/// round counter-clockwise seen from outside [m³].
template <class T>
T six_volume(const Vector3<T>& a, const Vector3<T>& b, const Vector3<T>& c) {
  const T ex = b.x() - a.x(), ey = b.y() - a.y(), ez = b.z() - a.z();
  const T fx = c.x() - a.x(), fy = c.y() - a.y(), fz = c.z() - a.z();
  return (ey * fz - ez * fy) * a.x() + (ez * fx - ex * fz) * a.y() + (ex * fy - ey * fx) * a.z();
}

/// The moments of a signed tetrahedron without their factors: 6 ∫ dV, 24 ∫ r dV, 120 ∫ r rᵀ dV.
/// @param v its 6V; the corners a, b, c and the apex as in six_volume()
template <class T>
Moments<T> raw_moments(const T& v, const Vector3<T>& a, const Vector3<T>& b, const Vector3<T>& c) {
  const T ax = a.x(), ay = a.y(), az = a.z(), bx = b.x(), by = b.y(), bz = b.z(), cx = c.x(),
          cy = c.y(), cz = c.z();
  const T sx = ax + bx + cx, sy = ay + by + cy, sz = az + bz + cz;
  return {v,
          v * sx,
          v * sy,
          v * sz,
          v * (sx * sx + ax * ax + bx * bx + cx * cx),
          v * (sy * sy + ay * ay + by * by + cy * cy),
          v * (sz * sz + az * az + bz * bz + cz * cz),
          v * (sx * sy + ax * ay + bx * by + cx * cy),
          v * (sy * sz + ay * az + by * bz + cy * cz),
          v * (sz * sx + az * ax + bz * bx + cz * cx)};
}

/// The moments from sums of raw_moments().
inline Moments<DoubleDouble> with_factors(Moments<DoubleDouble> m) {
  const auto divide = [](DoubleDouble& x, double factor) { x = x / DoubleDouble(factor); };
  divide(m.one, 6);
  for (DoubleDouble* first : {&m.x, &m.y, &m.z}) divide(*first, 24);
  for (DoubleDouble* second : {&m.xx, &m.yy, &m.zz, &m.xy, &m.yz, &m.zx}) divide(*second, 120);
  return m;
}

/// The sum of what `term(a, b, c)` gives for every triangle: plain within some 100 faces, the
/// rest in double-double.
template <class Term>
Moments<DoubleDouble> sum_over_triangles(const PolygonMesh& mesh, Term&& term) {
  constexpr int block = 128;
  Moments<DoubleDouble> total;
  for (int first = 0; first < mesh.face_count(); first += block) {
    const int end = std::min(first + block, mesh.face_count());
    Moments<double> sum;
    for (int f = first; f < end; ++f) {
      const std::span<const int> face = mesh.face(f);
      for (std::size_t k = 2; k < face.size(); ++k)
        sum += term(mesh.vertex(face[0]), mesh.vertex(face[k - 1]), mesh.vertex(face[k]));
    }
    total += sum;
  }
  return total;
}

/// Mass properties of a closed mesh, fast: everything in double, about 1e-15 for ordinary shapes.
/// Thin shapes that lie askew lose digits: the bounds say how many (the error is below them on
/// every mesh tried). Nothing is checked: see mesh_mass_properties().
/// @param mesh    closed, faces counter-clockwise seen from outside
/// @param density [kg/m³]
inline BoundedMassProperties fast_tetrahedra(const PolygonMesh& mesh, double density) {
  const Vec3 p = reference_point(mesh);
  RoundingSums rounding;
  const Moments<DoubleDouble> sum =
      sum_over_triangles(mesh, [&](const Vec3& first, const Vec3& second, const Vec3& third) {
        const Vec3 a = first - p, b = second - p, c = third - p;
        rounding.add(a, b - a, c - a);
        return raw_moments<double>(six_volume<double>(a, b, c), a, b, c);
      });
  return bounded(with_factors(sum), p, density, 0x1p-53, rounding);
}

}  // namespace tumble
