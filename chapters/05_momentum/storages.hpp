#pragma once
/// @file
/// Three ways to store the spin of a free body, and a wrong one. Nothing here needs more than a
/// page that draws its own figures has.

#include <array>

#include "tumble/body/derived.hpp"
#include "tumble/quaternion/quaternion_dot.hpp"

namespace momentum_chapter {

using namespace tumble;

/// q and three more numbers: L, or ω in world axes, or ω in body axes.
template <class T>
using Seven = Eigen::Matrix<T, 7, 1>;

template <class T>
Quaternion<T> orientation_of(const Seven<T>& y) {
  return {y[0], y[1], y[2], y[3]};
}

template <class T>
Seven<T> seven(const Quaternion<T>& q, const Vector3<T>& three) {
  Seven<T> y;
  y << coefficients(q), three;
  return y;
}

/// L̇ = 0.
template <class T>
Seven<T> rate_of_L(const RigidBody<T>& body, const Seven<T>& y) {
  const Quaternion<T> q = orientation_of(y);
  const Vector3<T> L = y.template tail<3>();
  const Vector3<T> omega = angular_velocity(body, to_matrix(q), L);
  return seven<T>(rotation::quaternion_dot(q, omega), Vector3<T>::Zero());
}

/// ω̇ = −I⁻¹ (ω × L).
template <class T>
Seven<T> rate_of_omega(const RigidBody<T>& body, const Seven<T>& y) {
  const Quaternion<T> q = orientation_of(y);
  const Matrix3<T> R = to_matrix(q);
  const Vector3<T> omega = y.template tail<3>();
  const Vector3<T> turning = angular_momentum(body, R, omega).cross(omega);
  return seven<T>(rotation::quaternion_dot(q, omega), angular_velocity(body, R, turning));
}

/// The same in body axes, where the tensor stands still.
template <class T>
Seven<T> rate_of_omega_body(const RigidBody<T>& body, const Seven<T>& y) {
  const Vector3<T> omega = y.template tail<3>();
  const Vector3<T> L_body = body.I_body() * omega;
  const Vector3<T> turning = L_body.cross(omega);
  return seven<T>(rotation::quaternion_dot_body(orientation_of(y), omega),
                  body.I_body_inv() * turning);
}

/// As if ω stayed, because nothing pushes.
template <class T>
Seven<T> rate_of_constant_omega(const RigidBody<T>&, const Seven<T>& y) {
  const Vector3<T> omega = y.template tail<3>();
  return seven<T>(rotation::quaternion_dot(orientation_of(y), omega), Vector3<T>::Zero());
}

/// Three numbers that tell, together with the orientation, how a body spins.
template <class T>
struct Storage {
  const char *name, *law;
  Seven<T> (*rate)(const RigidBody<T>&, const Seven<T>&);
  Vector3<T> (*from_omega)(const RigidBody<T>&, const Matrix3<T>& R, const Vector3<T>& omega);
  Vector3<T> (*to_omega)(const RigidBody<T>&, const Matrix3<T>& R, const Vector3<T>& stored);
};

template <class T>
Vector3<T> same(const RigidBody<T>&, const Matrix3<T>&, const Vector3<T>& omega) {
  return omega;
}

template <class T>
Vector3<T> into_body(const RigidBody<T>&, const Matrix3<T>& R, const Vector3<T>& omega) {
  return R.transpose() * omega;
}

template <class T>
Vector3<T> into_world(const RigidBody<T>&, const Matrix3<T>& R, const Vector3<T>& omega_body) {
  return R * omega_body;
}

template <class T>
constexpr std::array<Storage<T>, 4> storages{
    Storage<T>{"L", "0", rate_of_L<T>, angular_momentum<T>, angular_velocity<T>},
    {"ω", "−I⁻¹ (ω × I ω)", rate_of_omega<T>, same<T>, same<T>},
    {"ω_body", "the same, in the body", rate_of_omega_body<T>, into_body<T>, into_world<T>},
    {"ω", "0: wrong", rate_of_constant_omega<T>, same<T>, same<T>}};

}  // namespace momentum_chapter
