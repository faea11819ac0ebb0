#pragma once
/// @file
/// How many digits of an integral over a mesh can be trusted, found while it is computed.
///
/// The signed tetrahedron at a reference point over a triangle with corner a and edges e, f has a
/// rounding error of a few eps |e|₁ |f|₁ |a|₁ in 6 V; in 24 ∫ r dV it is r times that, and in
/// 120 ∫ r rᵀ dV r² times, with r = |a|₁ + |e|₁ + |f|₁ beyond its farthest corner. The bounds are
/// the sums over the mesh. Source: first-order rounding analysis, Higham, "Accuracy and Stability
/// of Numerical Algorithms" (2nd ed. 2002), §3.1; the factor 4 in front is twice the largest seen.

#include <cmath>
#include <limits>

#include "tumble/core/rounding.hpp"
#include "tumble/mass/moments.hpp"

namespace tumble {

/// @addtogroup mass
/// @{

/// Mass properties and how wrong rounding can have made them. The shape of the mesh itself is taken
/// as exact. A relative error of 1e-15 means that 15 digits hold, 1 or more that none does.
struct BoundedMassProperties : MassProperties {
  /// What rounding took from `centre` [m]: the true centre of mass is centre + centre_rest. Far
  /// from the origin a double cannot hold more digits than `centre` has.
  Vec3 centre_rest = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
  double mass_error_bound = std::numeric_limits<double>::quiet_NaN();     ///< relative
  double centre_error_bound = std::numeric_limits<double>::quiet_NaN();   ///< of centre + rest [m]
  double inertia_error_bound = std::numeric_limits<double>::quiet_NaN();  ///< relative, of the norm
};

namespace detail {

/// The sums over all triangles that bound the rounding errors, without eps and constant factors.
template <class T>
struct RoundingSums {
  T volume{};   ///< Σ |e|₁ |f|₁ |a|₁, for 6 V [m³]
  T first{};    ///< Σ |e|₁ |f|₁ |a|₁ r, for 24 ∫ r dV [m⁴]
  T inertia{};  ///< Σ |e|₁ |f|₁ |a|₁ r², for 120 ∫ r rᵀ dV [m⁵]

  /// A triangle with a corner `a1` away from the reference point and edges `e1` and `f1` from it,
  /// all in the 1-norm.
  TUMBLE_INLINE void add(const T& a1, const T& e1, const T& f1) {
    const T r = a1 + e1 + f1, product = e1 * f1 * a1;
    volume += product;
    first += product * r;
    inertia += product * (r * r);
  }

  RoundingSums& operator+=(const RoundingSums& other) {
    volume += other.volume;
    first += other.first;
    inertia += other.inertia;
    return *this;
  }
};

/// Half the trace of the inertia tensor, for density 1: what its errors are measured by [m⁵].
inline double inertia_size(const Moments<simd::DoubleDouble>& m) {
  return double(m.xx + m.yy + m.zz - (m.x * m.x + m.y * m.y + m.z * m.z) / m.one);
}

/// The mass properties with their error bounds: the rounding of the result (2 eps), and a few units
/// u of the arithmetic times the sums.
/// @param u 2⁻⁵³ when all was done in double, 2⁻¹⁰⁴ for pairs of doubles
inline BoundedMassProperties bounded(const Moments<simd::DoubleDouble>& m, const Vec3& reference,
                                     double density, double u, const RoundingSums<double>& sums) {
  const double volume = std::abs(double(m.one));
  BoundedMassProperties body{mass_properties(m, reference, density)};
  const Vector3<simd::DoubleDouble> offset = centre_from_reference(m);
  const Vector3<simd::DoubleDouble> rest =
      offset + reference.cast<simd::DoubleDouble>() - body.centre.cast<simd::DoubleDouble>();
  body.centre_rest = to_double(rest);
  // What rounding may have done to ∫ dV, ∫ r dV and ∫ r rᵀ dV; and then to ∫ r dV / V and to
  // ∫ r rᵀ dV − c ∫ rᵀ dV.
  const double zeroth = 4 * u * sums.volume / 6, first = 4 * u * sums.first / 24,
               second = 4 * u * sums.inertia / 120;
  const double c = to_double(offset).lpNorm<1>();
  body.mass_error_bound = 2 * unit_roundoff + zeroth / volume;
  body.centre_error_bound = 8 * unit_roundoff * unit_roundoff * (c + reference.lpNorm<1>()) +
                            (first + c * zeroth) / volume;
  body.inertia_error_bound =
      2 * unit_roundoff + (second + 2 * c * first + c * c * zeroth) / std::abs(inertia_size(m));
  return body;
}

}  // namespace detail

/// @}

}  // namespace tumble
