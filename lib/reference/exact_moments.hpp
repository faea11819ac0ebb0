#pragma once
/// @file
/// The mass properties of a mesh with every operation in double-double, one after the other: about
/// 28 digits. Slow, plain, and made of other parts than what it is a judge of.

#include "tumble/mass/moments.hpp"
#include "tumble/mesh/reference_point.hpp"

namespace tumble::reference {

/// The moments of a closed mesh about a point, by the tetrahedra that its triangles make with it.
inline Moments<simd::DoubleDouble> exact_moments(const PolygonMesh& mesh, const Vec3& reference) {
  using T = simd::DoubleDouble;
  using V = Vector3<T>;
  Moments<T> m;
  for_each_triangle(mesh, [&](int, const std::array<int, 3>& t) {
    std::array<V, 3> r;
    for (std::size_t k = 0; k < 3; ++k) r[k] = mesh.vertex(t[k]).cast<T>() - reference.cast<T>();
    const V first = mesh.vertex(t[0]).cast<T>();
    const V e = mesh.vertex(t[1]).cast<T>() - first, f = mesh.vertex(t[2]).cast<T>() - first;
    const T v = r[0].dot(V(e.cross(f)));
    const V s = r[0] + r[1] + r[2];
    // 120/6V · ∫ x y dV = s_x s_y + Σ r_x r_y
    const auto second = [&](Eigen::Index i, Eigen::Index j) {
      return v * (s[i] * s[j] + r[0][i] * r[0][j] + r[1][i] * r[1][j] + r[2][i] * r[2][j]) / T(120);
    };
    m += Moments<T>{v / T(6),     v * s[0] / T(24), v * s[1] / T(24), v * s[2] / T(24),
                    second(0, 0), second(1, 1),     second(2, 2),     second(0, 1),
                    second(1, 2), second(2, 0)};
  });
  return m;
}

/// Mass properties of a closed mesh, each number the true one rounded to double.
inline MassProperties exact_mass_properties(const PolygonMesh& mesh, double density) {
  const Vec3 p = detail::reference_point(mesh);
  return tumble::mass_properties(exact_moments(mesh, p), p, density);
}

/// The true centre of mass, to 28 digits.
inline Vector3<simd::DoubleDouble> exact_centre(const PolygonMesh& mesh) {
  const Vec3 p = detail::reference_point(mesh);
  return detail::centre_from_reference(exact_moments(mesh, p)) + p.cast<simd::DoubleDouble>();
}

}  // namespace tumble::reference
