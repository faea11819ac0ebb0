#pragma once
/// @file
/// The path of a body's centre under steady forces, for all times at once:
///
///     m ẍ = F − k ẋ:   v = v₀ e^(−z) + (F/m) t φ₁(−z),   x = x₀ + v₀ t φ₁(−z) + (F/m) t² φ₂(−z),
///     z = k t/m,   φ₁(y) = (e^y − 1)/y,   φ₂(y) = (e^y − 1 − y)/y²
///
/// Source: Hochbruck & Ostermann, "Exponential integrators", Acta Numerica 19 (2010), §2.1, for φ.

#include <cmath>

#include "tumble/body/state.hpp"
#include "tumble/body/steady_forces.hpp"

namespace tumble::detail {

/// (e^y − 1)/y, 1 at y = 0.
inline double phi1(double y) { return y == 0 ? 1 : std::expm1(y) / y; }

/// (e^y − 1 − y)/y², ½ at y = 0.
double phi2(double y);

}  // namespace tumble::detail

namespace tumble::steady {

/// @addtogroup steady
/// @{

/// Where the centre of mass is, and its momentum.
class SteadyPath {
 public:
  SteadyPath(const RigidBody<>& body, const RigidBodyState<>& start, const SteadyForces& forces)
      : x_(start.x),
        P_(start.P),
        force_(forces.force),
        mass_(body.mass()),
        rate_(forces.linear_drag / body.mass()) {}

  /// [m]
  Vec3 x(double t) const {
    const double y = -rate_ * t;
    return x_ + (t * detail::phi1(y) / mass_) * P_ + (t * t * detail::phi2(y) / mass_) * force_;
  }
  /// [kg m/s]
  Vec3 P(double t) const {
    const double y = -rate_ * t;
    return std::exp(y) * P_ + (t * detail::phi1(y)) * force_;
  }

  /// What rounding leaves uncertain of x and P until t ≥ 0, a part of their largest sizes.
  /// Backwards in time drag pushes: then the terms grow as e^(z), and may leave little when they
  /// are added.
  double error_bound(double t) const;

 private:
  Vec3 x_, P_, force_;
  double mass_, rate_;
};

/// @}

}  // namespace tumble::steady

#ifndef TUMBLE_COMPILED
#include "tumble/steady/steady_path.inl"
#endif
