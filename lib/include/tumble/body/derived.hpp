#pragma once
/// @file
/// What follows from the state: the matrix R, the velocity v and the angular velocity ω, and with
/// them where any point of the body is and how fast.
///
/// v = P/m,  ω = R I_body⁻¹ Rᵀ L.   Source: Baraff, "Rigid Body Simulation I"
/// (1997), §2.5–2.10, §4.

#include "tumble/body/rigid_body.hpp"
#include "tumble/body/state.hpp"
#include "tumble/core/types.hpp"
#include "tumble/quaternion/convert.hpp"

namespace tumble {

/// @addtogroup body
/// @{

/// The motion of a body at one moment, in world coordinates: all that a force may depend on.
template <class T = double>
struct Derived {
  Vector3<T> x;      ///< centre of mass [m]
  Matrix3<T> R;      ///< orientation, body → world
  Vector3<T> v;      ///< velocity of the centre of mass [m/s]
  Vector3<T> omega;  ///< angular velocity [rad/s]
};

/// ω = R I_body⁻¹ Rᵀ L [rad/s], without forming the world's inverse tensor.
template <class T>
Vector3<T> angular_velocity(const RigidBody<T>& body, const Matrix3<T>& R, const Vector3<T>& L) {
  const Vector3<T> L_body = R.transpose() * L;
  const Vector3<T> omega_body = body.I_body_inv() * L_body;
  return R * omega_body;
}

/// L = R I_body Rᵀ ω [kg m²/s].
template <class T>
Vector3<T> angular_momentum(const RigidBody<T>& body, const Matrix3<T>& R,
                            const Vector3<T>& omega) {
  const Vector3<T> omega_body = R.transpose() * omega;
  const Vector3<T> L_body = body.I_body() * omega_body;
  return R * L_body;
}

/// The derived quantities of a state.
template <class T>
Derived<T> derived(const RigidBody<T>& body, const RigidBodyState<T>& state) {
  const Matrix3<T> R = to_matrix(state.q);
  return {state.x, R, state.P / body.mass(), angular_velocity(body, R, state.L)};
}

/// The state of a body at x, turned by q, moving with v [m/s] and ω [rad/s] (world coordinates).
template <class T>
RigidBodyState<T> state_of_motion(const RigidBody<T>& body, const Vector3<T>& x,
                                  const Quaternion<T>& q, const Vector3<T>& v,
                                  const Vector3<T>& omega) {
  return {x, q, body.mass() * v, angular_momentum(body, to_matrix(q), omega)};
}

/// Where the point p_body of the body is in the world [m]: x + R p_body.
template <class T>
Vector3<T> point_position(const Derived<T>& now, const Vector3<T>& p_body) {
  return now.x + now.R * p_body;
}

/// The velocity of the point p_body of the body [m/s]: v + ω × R p_body.
template <class T>
Vector3<T> point_velocity(const Derived<T>& now, const Vector3<T>& p_body) {
  return now.v + now.omega.cross(now.R * p_body);
}

/// ½ P·v + ½ L·ω [J].
template <class T>
T kinetic_energy(const RigidBody<T>& body, const RigidBodyState<T>& state) {
  const Derived<T> now = derived(body, state);
  return (state.P.dot(now.v) + state.L.dot(now.omega)) / T(2);
}

/// @}

}  // namespace tumble
