#pragma once
/// @file
/// How many digits of an integral over a mesh can be trusted, found while it is computed.
///
/// Source: first-order rounding analysis, Higham, "Accuracy and Stability of Numerical Algorithms"
/// (2nd ed. 2002), §3.1 and Lemma 3.1; for what is used of it see rounding_sums.hpp.

#include <cmath>
#include <limits>

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

/// What rounding may have done to integrals over a body at most.
struct IntegralErrors {
  double volume;  ///< to ∫ dV [m³]
  double first;   ///< to ∫ r dV: the length of the difference [m⁴]
  double second;  ///< to ∫ r rᵀ dV: its Frobenius norm [m⁵]
};

/// Half the trace of the inertia tensor, for density 1: what its errors are measured by [m⁵].
inline double inertia_size(const Moments<simd::DoubleDouble>& m) {
  const Vector3<simd::DoubleDouble> c = centre_from_reference(m);
  return double(m.xx + m.yy + m.zz - (c.x() * m.x + c.y() * m.y + c.z() * m.z));
}

/// error / (size − error): how wrong a computed `size` is, relative to the true one; ∞ if the true
/// one may be 0.
inline double relative_to_true(double error, double size) {
  if (error < size) return error / (size - error);
  return std::isnan(error + size) ? error + size : std::numeric_limits<double>::infinity();
}

/// The mass properties with their error bounds. A result is rounded twice, when it becomes a double
/// and when it is multiplied by the density: 2 ε of it.
/// @param errors of the moments m
BoundedMassProperties bounded(const Moments<simd::DoubleDouble>& m, const Vec3& reference,
                              double density, const IntegralErrors& errors);

}  // namespace detail

/// @}

}  // namespace tumble

#ifndef TUMBLE_COMPILED
#include "tumble/mass/error_bound.inl"
#endif
