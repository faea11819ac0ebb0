#pragma once
/// @file
/// What turns a body under steady forces, in its principal axes:
///
///     J ω̇ = J ω × ω + Σ aᵣ × Rᵀ dᵣ − k ω
///
/// with at most three directions dᵣ in the world, however many forces there are.

#include <array>

#include "tumble/body/rigid_body.hpp"
#include "tumble/body/state.hpp"
#include "tumble/body/steady_forces.hpp"
#include "tumble/core/rounding.hpp"
#include "tumble/free_body/polhode.hpp"
#include "tumble/mass/principal_axes.hpp"

namespace tumble::steady {

/// @addtogroup steady
/// @{

/// How a body is turned and turns, in principal axes.
struct TurningState {
  Quat q;      ///< principal axes → world
  Vec3 omega;  ///< [rad/s], principal axes
};

/// The turning of a body under steady forces.
class SteadyTorque {
 public:
  SteadyTorque(const RigidBody<>& body, const SteadyForces& forces)
      : SteadyTorque(forces, principal_axes(body.I_body())) {}

  /// @param axes principal axes of the body, in any order
  SteadyTorque(const SteadyForces& forces, const PrincipalAxes& axes)
      : axes_(axes), drag_(forces.angular_drag / axes_.moments.array()) {
    for (const SteadyForces::AtPoint& f : forces.at_point)
      add(f.force, axes_.R.transpose() * f.p_body);
    // An arm along its force's only direction, or none, turns nothing.
    if (rank_ == 1 && arms_[0].isZero(0)) rank_ = 0;
  }

  int rank() const { return rank_; }  ///< how many directions, 0 … 3
  const Vec3& direction(int r) const { return directions_[index(r)]; }  ///< dᵣ, unit, world
  const Vec3& arm(int r) const { return arms_[index(r)]; }  ///< aᵣ [N m], principal axes
  const Vec3& drag() const { return drag_; }                ///< k/J [1/s]
  const PrincipalAxes& axes() const { return axes_; }

  /// Nothing turns the body: no torque, no drag.
  bool is_free() const { return rank_ == 0 && drag_.isZero(0); }

  /// Nothing turns the body as long as it turns like this: its forces pull along the principal axis
  /// that it spins about, as those on a sleeping top.
  bool is_idle(const TurningState& s) const {
    const Vec3& w = s.omega;
    bool idle = drag_.isZero(0) && axes_.moments.cwiseProduct(w).cross(w).isZero(0);
    for (int r = 0; r < rank_; ++r) {
      const Vec3 u = s.q.conjugate() * directions_[index(r)];
      idle = idle && arms_[index(r)].cross(u).isZero(0) && u.cross(w).isZero(0);
    }
    return idle;
  }

  /// @param q of any length but zero
  TurningState turning(const Quat& q, const Vec3& L) const {
    const detail::Vec3dd L_principal = detail::principal_momentum(axes_, q, L);
    const Vec3 rounded(L_principal[0].hi, L_principal[1].hi, L_principal[2].hi);
    return {q.normalized() * frame(), rounded.cwiseQuotient(axes_.moments)};
  }
  /// The body's own axes → world.
  Quat orientation(const TurningState& s) const { return s.q.normalized() * frame().conjugate(); }
  /// L in the world [kg m²/s].
  Vec3 L(const TurningState& s) const {
    return s.q.normalized() * Vec3(axes_.moments.cwiseProduct(s.omega));
  }

 private:
  static std::size_t index(int r) { return static_cast<std::size_t>(r); }

  Quat frame() const { return from_matrix(axes_.R); }

  /// Shares a force at p among the directions, a new one for what none of them has.
  void add(const Vec3& force, const Vec3& p) {
    Vec3 rest = force;
    for (int r = 0; r < rank_; ++r) {
      const double share = directions_[index(r)].dot(force);
      arms_[index(r)] += share * p;
      rest -= share * directions_[index(r)];
    }
    if (rank_ == 3 || rest.norm() <= 8 * detail::unit_roundoff * force.norm()) return;
    directions_[index(rank_)] = rest.normalized();
    arms_[index(rank_++)] = rest.norm() * p;
  }

  PrincipalAxes axes_;
  Vec3 drag_;
  int rank_ = 0;
  std::array<Vec3, 3> directions_, arms_;
};

/// @}

}  // namespace tumble::steady
