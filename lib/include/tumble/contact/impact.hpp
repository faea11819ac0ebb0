#pragma once
/// @file
/// What a contact is before it hits, and what is left after it.

#include <cmath>

#include "tumble/core/require.hpp"
#include "tumble/core/types.hpp"

namespace tumble::contact {

/// @addtogroup contact
/// @{

/// A point at which two bodies, or a body and the world, come together.
struct Impact {
  Mat3 K;       ///< how the velocity responds to an impulse [1/kg]: contact_matrix() of both, added
  Vec3 u;       ///< velocity of the first body's point less that of the second one's [m/s]
  Vec3 normal;  ///< unit, out of the second body: u·normal < 0 comes together
  double e = 0;   ///< coefficient of restitution, 0 … 1
  double mu = 0;  ///< coefficient of friction, ≥ 0

  /// @throws std::invalid_argument if one of them is no such thing
  void require_valid() const {
    require(K.allFinite() && u.allFinite(), "impact: K or u is not finite");
    require(std::abs(normal.norm() - 1) < 1e-9, "impact: the normal (", normal.transpose(),
            ") does not have length 1");
    require(normal.dot(K * normal) > 0,
            "impact: both bodies have infinite mass: nK n = ", normal.dot(K * normal));
    require(e >= 0 && e <= 1, "impact: restitution e = ", e, " is not in 0 … 1");
    require(mu >= 0 && std::isfinite(mu), "impact: friction mu = ", mu, " is not finite and ≥ 0");
  }
};

/// How a contact with friction went.
enum class Slip {
  none,    ///< no impulse: the bodies part
  kept,    ///< it slid to the end
  stuck,   ///< it came to rest and stayed
  turned,  ///< it came to rest and slid on in another direction
};

/// What a contact leaves.
struct ImpactResult {
  Vec3 impulse = Vec3::Zero();  ///< on the first body [N s]; the second one gets its negative
  Vec3 u = Vec3::Zero();        ///< the velocity after it [m/s]
  double energy = 0;            ///< gained by both together [J]: never more than 0
  Slip slip = Slip::none;
  /// At its start the slip pulled the bodies together faster than their push could part them
  /// (Painlevé's paradox): no finite force can explain this contact, an impulse can.
  bool jammed = false;
};

/// The energy that an impulse brings [J]: ½ (u + u')·j.
inline double energy_of(const Vec3& before, const Vec3& after, const Vec3& impulse) {
  return (before + after).dot(impulse) / 2;
}

/// The impulse of a contact without friction: u'·n = −e u·n.
/// Source: Baraff, "Rigid Body Simulation II" (1997), §8.
/// @throws std::invalid_argument if the impact is none
ImpactResult collide(const Impact& impact);

/// @}

}  // namespace tumble::contact

#ifndef TUMBLE_COMPILED
#include "tumble/contact/impact.inl"
#endif
