#pragma once
/// @file
/// How many digits of an integral over a mesh can be trusted, found while it is computed.
///
/// The signed tetrahedron at a reference point over a triangle with corner a and edges e, f has a
/// rounding error of a few eps |e|₁ |f|₁ |a|₁ in 6 V, and r² times that in 120 ∫ r rᵀ dV, with
/// r = |a|₁ + |e|₁ + |f|₁ beyond its farthest corner. The bounds are the sums over the mesh.
/// Source: first-order rounding analysis, Higham, "Accuracy and Stability of Numerical Algorithms"
/// (2nd ed. 2002), §3.1; the factor 4 in front is twice the largest that was seen.

#include <cmath>
#include <limits>

#include "tumble/mass/moments.hpp"
#include "tumble/mesh/polygon_mesh.hpp"

namespace tumble {

/// Mass properties and how wrong rounding can have made them, relative: 1e-15 means that 15 digits
/// hold, 1 or more that none does. The shape of the mesh itself is taken as exact.
struct BoundedMassProperties : MassProperties {
  double mass_error_bound = std::numeric_limits<double>::quiet_NaN();     ///< of the mass
  double inertia_error_bound = std::numeric_limits<double>::quiet_NaN();  ///< of the inertia's norm
};

/// A point in the middle of a mesh, for integrals to be taken about: the centre of the box around
/// the faces' first corners. Vertices that no face uses do not count.
inline Vec3 reference_point(const PolygonMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (int f = 0; f < mesh.face_count(); ++f)
    if (!mesh.face(f).empty()) box.extend(mesh.vertex(mesh.face(f).front()));
  return box.isEmpty() ? Vec3(0, 0, 0) : Vec3(box.center());
}

/// The sums over all triangles that bound the rounding errors, without eps and constant factors.
struct RoundingSums {
  double volume = 0;   ///< Σ |e|₁ |f|₁ |a|₁, for 6 V [m³]
  double inertia = 0;  ///< Σ |e|₁ |f|₁ |a|₁ r², for 120 ∫ r rᵀ dV [m⁵]

  /// A triangle with corner a (from the reference point) and edges e and f from it.
  void add(const Vec3& a, const Vec3& e, const Vec3& f) {
    const double a1 = a.lpNorm<1>(), e1 = e.lpNorm<1>(), f1 = f.lpNorm<1>(), r = a1 + e1 + f1;
    volume += e1 * f1 * a1;
    inertia += e1 * f1 * a1 * (r * r);
  }
};

/// Half the trace of the inertia tensor, for density 1: what its errors are measured by [m⁵].
inline double inertia_size(const Moments<DoubleDouble>& m) {
  return double(m.xx + m.yy + m.zz - (m.x * m.x + m.y * m.y + m.z * m.z) / m.one);
}

/// The mass properties with their error bounds: eps for the rounding of the result, and a few units
/// u of the arithmetic times the sums.
/// @param u       2⁻⁵³ when all was done in double, 2⁻¹⁰⁴ for double-double
/// @param weights what rounding in the corners adds to the error of 120 ∫ r rᵀ dV [m⁵]
inline BoundedMassProperties bounded(const Moments<DoubleDouble>& m, const Vec3& reference,
                                     double density, double u, const RoundingSums& sums,
                                     double weights = 0) {
  constexpr double eps = 0x1p-53;
  return {mass_properties(m, reference, density),
          2 * eps + 4 * u * sums.volume / (6 * std::abs(double(m.one))),
          2 * eps + (4 * u * sums.inertia + weights) / (120 * std::abs(inertia_size(m)))};
}

}  // namespace tumble
