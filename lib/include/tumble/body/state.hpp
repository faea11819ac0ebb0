#pragma once
/// @file
/// The state of a rigid body: thirteen numbers (x, q, P, L).
///
/// Momenta are stored rather than velocities: P and L stay constant where nothing pushes, ω does
/// not. Source: Baraff, "Rigid Body Simulation I" (1997), §2.9 and §4 (there with R instead of q).

#include "tumble/core/types.hpp"
#include "tumble/quaternion/convert.hpp"

namespace tumble {

/// @addtogroup body
/// @{

/// Where a body is, how it is turned, and its momenta, all in world coordinates.
template <class T = double>
struct RigidBodyState {
  Vector3<T> x = Vector3<T>::Zero();                        ///< centre of mass [m]
  Quaternion<T> q = Quaternion<T>(T(1), T(0), T(0), T(0));  ///< orientation, body → world
  Vector3<T> P = Vector3<T>::Zero();                        ///< linear momentum [kg m/s]
  Vector3<T> L = Vector3<T>::Zero();  ///< angular momentum about the centre [kg m²/s]
};

namespace detail {

/// How many numbers a packed state has.
inline constexpr int rigid_body_state_size = 13;

}  // namespace detail

/// x, q as (w, x, y, z), P, L, one after the other.
template <class T>
using PackedState = Eigen::Matrix<T, detail::rigid_body_state_size, 1>;

template <class T>
PackedState<T> pack(const RigidBodyState<T>& state) {
  PackedState<T> y;
  y << state.x, coefficients(state.q), state.P, state.L;
  return y;
}

/// The inverse of pack(). The quaternion is taken as it is, not normalised.
template <class T>
RigidBodyState<T> unpack(const PackedState<T>& y) {
  return {y.template head<3>(), Quaternion<T>(y[3], y[4], y[5], y[6]), y.template segment<3>(7),
          y.template tail<3>()};
}

/// @}

}  // namespace tumble
