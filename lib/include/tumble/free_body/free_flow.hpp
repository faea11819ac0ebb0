#pragma once
/// @file
/// The turning of one body without torque, for any state: what does not depend on the state is
/// computed once.

#include <variant>

#include "tumble/free_body/free_asymmetric_top.hpp"
#include "tumble/free_body/free_symmetric_top.hpp"
#include "tumble/free_body/uniform_rotation.hpp"

namespace tumble::detail {

/// A closed form of the orientation over time.
using FreeRotation = std::variant<UniformRotation, FreeSymmetricTop, FreeAsymmetricTop>;

/// Body → world at time t.
inline Quat orientation_at(const FreeRotation& rotation, double t) {
  return std::visit([t](const auto& form) { return form.at(t); }, rotation);
}

/// The free turning of a body.
class FreeFlow {
 public:
  explicit FreeFlow(const RigidBody<>& body) : FreeFlow(principal_axes(body.I_body())) {}
  explicit FreeFlow(const PrincipalAxes& axes) : axes_(axes), top_(nearest_symmetric_top(axes)) {
    const Vec3& A = axes_.moments;
    if (A[0] == A[1] || A[1] == A[2]) kind_ = A[0] == A[2] ? Model::ball : Model::symmetric_top;
  }

  /// The turning from a state on.
  FreeRotation from(const Quat& q, const Vec3& L) const {
    if (kind_ == Model::ball) return UniformRotation(q, L / axes_.moments[0]);
    if (kind_ == Model::symmetric_top) return FreeSymmetricTop(top_, q, L);
    if (const auto polhode = elliptic::polhode_of(axes_, q, L))
      return FreeAsymmetricTop(*polhode, q);
    return UniformRotation(q, omega(q.normalized(), L));
  }

  /// The orientation a time t after q, for a turning that is asked for once.
  Quat advance(const Quat& q, const Vec3& L, double t) const {
    if (kind_ == Model::symmetric_top) return FreeSymmetricTop(top_, q, L).at(t);
    return orientation_at(from(q, L), t);
  }

 private:
  /// World coordinates [rad/s].
  Vec3 omega(const Quat& q, const Vec3& L) const {
    const Mat3 R = to_matrix(q) * axes_.R;
    return R * Vec3((R.transpose() * L).cwiseQuotient(axes_.moments));
  }

  PrincipalAxes axes_;
  SymmetricMoments top_;
  Model kind_ = Model::full_body;
};

}  // namespace tumble::detail
