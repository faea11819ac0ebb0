#pragma once
/// @file
/// The same equation of motion with R in place of q: eighteen numbers (x, R, P, L), for comparison.
/// All nine numbers of R drift, and only an orthonormalisation brings them back.
///
/// d/dt (x, R, P, L) = (P/m, [ω]× R, F, τ).   Source: Baraff, "Rigid Body Simulation I"
/// (1997), eq. 2-22.

#include <tuple>

#include "tumble/body/derived.hpp"
#include "tumble/body/forces.hpp"
#include "tumble/rotation/rotation_dot.hpp"

namespace tumble::rotation {

/// @addtogroup body
/// @{

/// The state of a body with its orientation as a matrix, in world coordinates.
template <class T = double>
struct MatrixState {
  Vector3<T> x = Vector3<T>::Zero();      ///< centre of mass [m]
  Matrix3<T> R = Matrix3<T>::Identity();  ///< orientation, body → world; its columns are the axes
  Vector3<T> P = Vector3<T>::Zero();      ///< linear momentum [kg m/s]
  Vector3<T> L = Vector3<T>::Zero();      ///< angular momentum about the centre [kg m²/s]
};

/// x, R column by column, P, L.
template <class T>
using PackedMatrixState = Eigen::Matrix<T, 18, 1>;

template <class T>
PackedMatrixState<T> pack(const MatrixState<T>& state) {
  PackedMatrixState<T> y;
  y << state.x, state.R.reshaped(), state.P, state.L;
  return y;
}

/// The inverse of pack(); R is taken as it is.
template <class T>
MatrixState<T> unpack(const PackedMatrixState<T>& y) {
  return {y.template head<3>(), y.template segment<9>(3).template reshaped<Eigen::ColMajor>(3, 3),
          y.template segment<3>(12), y.template tail<3>()};
}

/// A body and the forces on it as a right-hand side on the eighteen numbers.
template <class T, BodyForce<T>... Forces>
class MatrixStateRhs {
 public:
  /// @throws std::invalid_argument if a force refuses what it was made of
  explicit MatrixStateRhs(const RigidBody<T>& body, const Forces&... forces)
      : body_(body), forces_(detail::valid_forces(forces...)) {}

  /// dy/dt of the packed state y at time t [s]. R enters as it is, drift and all.
  PackedMatrixState<T> operator()(T t, const PackedMatrixState<T>& y) const {
    const MatrixState<T> s = unpack<T>(y);
    const Derived<T> now{s.x, s.R, s.P / body_.mass(), angular_velocity(body_, s.R, s.L)};
    const Wrench<T> net = net_wrench(t, body_, now, forces_);
    return pack(MatrixState<T>{now.v, rotation_dot(s.R, now.omega), net.force, net.torque});
  }

 private:
  RigidBody<T> body_;
  std::tuple<Forces...> forces_;
};

template <class T, class... Forces>
MatrixStateRhs(const RigidBody<T>&, const Forces&...) -> MatrixStateRhs<T, Forces...>;

/// @}

}  // namespace tumble::rotation
