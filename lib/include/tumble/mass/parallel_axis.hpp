#pragma once
/// @file
/// The inertia about another point than the centre of mass: I_p = I + m (dᵀd 1 − d dᵀ).
///
/// Source: Huygens and Steiner; e.g. Goldstein, "Classical Mechanics" (3rd ed. 2002), eq. 5.21.

#include "tumble/mass/mass_properties.hpp"

namespace tumble {

/// @addtogroup mass
/// @{

/// The inertia of a point mass at d about the origin: m (dᵀd 1 − d dᵀ) [kg m²].
/// @param mass [kg]
/// @param d    its position [m]
inline Mat3 point_inertia(double mass, const Vec3& d) {
  return mass * (d.squaredNorm() * Mat3::Identity() - d * d.transpose());
}

/// The inertia about the point that is d away from the centre of mass [kg m²].
/// @param I    inertia about the centre of mass [kg m²]
/// @param mass [kg]
/// @param d    from the centre of mass to the point, or back: the sign does not matter [m]
inline Mat3 parallel_axis(const Mat3& I, double mass, const Vec3& d) {
  return I + point_inertia(mass, d);
}

/// The inverse: from the inertia about a point to the one about the centre of mass [kg m²].
/// Digits cancel where m d² is much larger than the result.
inline Mat3 inertia_about_centre(const Mat3& I_point, double mass, const Vec3& d) {
  return I_point - point_inertia(mass, d);
}

/// The inertia of a body about any point [kg m²].
/// @param point in the coordinates that the body's centre is given in [m]
inline Mat3 inertia_about(const MassProperties& body, const Vec3& point) {
  return parallel_axis(body.inertia, body.mass, body.centre - point);
}

/// @}

}  // namespace tumble
