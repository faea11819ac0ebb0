#pragma once
/// @file
/// The impulse of a contact with Coulomb friction, which never creates energy.
///
/// A contact is short, and not a moment: while the normal impulse p grows from 0, the velocity
/// follows u(p) = u + K j(p), and dj/dp is the normal with friction against the slip *as it is
/// then*. The slip may come to rest in between, stay there, or turn round; a law that looks at its
/// beginning alone misses that, and can create energy. The contact ends by Stronge's law: of the
/// work that the normal impulse does while the bodies come together, −W, the part e² W comes back.
/// So the energy changes by (1 − e²) of what W took, and by the work of friction, and neither is
/// ever positive. Without friction it is Newton's law, u'·n = −e u·n.
///
/// Where the slip keeps its direction, as in a plane, all is linear in p, and exact. Elsewhere,
/// with dp = |slip| dτ, the equations are smooth up to the moment at which the slip ends.
///
/// Sources: Keller, "Impact with friction", J. Applied Mechanics 53 (1986); Stronge, "Rigid body
/// collisions with friction", Proc. R. Soc. A 431 (1990); Mirtich, PhD thesis, Berkeley (1996),
/// §3.4.

#include "tumble/contact/impact.hpp"
#include "tumble/simd/double_double.hpp"

namespace tumble::contact::detail {

/// The contact's own axes as the columns of a rotation, the last one the normal.
Mat3 contact_axes(const Vec3& normal);

/// What an impulse makes of the velocity, and the energy that it brings, with twice the digits:
/// where K is nearly singular, both are what is left of much larger numbers.
struct Outcome {
  Outcome(const Impact& impact, const Vec3& impulse) {
    using T = simd::DoubleDouble;
    const Vector3<T> before = impact.u.cast<T>(), j = impulse.cast<T>();
    const Vector3<T> after = before + impact.K.cast<T>() * j;
    u = after.cast<double>();
    energy = double((before + after).dot(j)) / 2;
  }

  Vec3 u;         ///< [m/s]
  double energy;  ///< [J]
};

}  // namespace tumble::contact::detail

namespace tumble::contact {

/// @addtogroup contact
/// @{

/// The impulse of a contact with friction. Where K is nearly singular, an impulse may be so large
/// that its rounding would create energy: then it is shortened until it creates none.
/// @throws std::invalid_argument if the impact is none
ImpactResult collide_with_friction(const Impact& impact);

/// @}

}  // namespace tumble::contact

#ifndef TUMBLE_COMPILED
#include "tumble/contact/friction_impulse.inl"
#endif
