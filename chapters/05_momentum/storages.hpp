#pragma once
/// @file
/// Three ways to store the spin of a free body, and a wrong one.

#include <array>
#include <string>

#include "common.hpp"
#include "support/counted.hpp"
#include "thrown_objects.hpp"

namespace momentum_chapter {

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

template <class T>
const RigidBody<T>& subject() {
  static const RigidBody<T> body(properties_of(free_handle));
  return body;
}

/// L̇ = 0.
template <class T>
Seven<T> rate_of_L(T, const Seven<T>& y) {
  const Quaternion<T> q = orientation_of(y);
  const Vector3<T> L = y.template tail<3>();
  const Vector3<T> omega = angular_velocity(subject<T>(), to_matrix(q), L);
  return seven<T>(rotation::quaternion_dot(q, omega), Vector3<T>::Zero());
}

/// ω̇ = −I⁻¹ (ω × L).
template <class T>
Seven<T> rate_of_omega(T, const Seven<T>& y) {
  const Quaternion<T> q = orientation_of(y);
  const Matrix3<T> R = to_matrix(q);
  const Vector3<T> omega = y.template tail<3>();
  const Vector3<T> turning = angular_momentum(subject<T>(), R, omega).cross(omega);
  return seven<T>(rotation::quaternion_dot(q, omega), angular_velocity(subject<T>(), R, turning));
}

/// The same in body axes, where the tensor stands still.
template <class T>
Seven<T> rate_of_omega_body(T, const Seven<T>& y) {
  const Vector3<T> omega = y.template tail<3>();
  const Vector3<T> L_body = subject<T>().I_body() * omega;
  const Vector3<T> turning = L_body.cross(omega);
  return seven<T>(rotation::quaternion_dot_body(orientation_of(y), omega),
                  subject<T>().I_body_inv() * turning);
}

/// As if ω stayed, because nothing pushes.
template <class T>
Seven<T> rate_of_constant_omega(T, const Seven<T>& y) {
  const Vector3<T> omega = y.template tail<3>();
  return seven<T>(rotation::quaternion_dot(orientation_of(y), omega), Vector3<T>::Zero());
}

using Counted = support::Counted;

/// Three numbers that tell, together with the orientation, how a body spins.
struct Storage {
  std::string name, law;
  Seven<double> (*rate)(double, const Seven<double>&);
  Seven<Counted> (*counted)(Counted, const Seven<Counted>&);
  Vec3 (*from_omega)(const Mat3& R, const Vec3& omega);
  Vec3 (*to_omega)(const Mat3& R, const Vec3& stored);
};

inline Vec3 same(const Mat3&, const Vec3& omega) { return omega; }

inline const std::array<Storage, 4> storages{
    Storage{"L", "0", rate_of_L<double>, rate_of_L<Counted>,
            [](const Mat3& R, const Vec3& omega) {
              return angular_momentum(subject<double>(), R, omega);
            },
            [](const Mat3& R, const Vec3& L) { return angular_velocity(subject<double>(), R, L); }},
    {"ω", "−I⁻¹ (ω × I ω)", rate_of_omega<double>, rate_of_omega<Counted>, same, same},
    {"ω_body", "−I⁻¹ (ω × I ω)", rate_of_omega_body<double>, rate_of_omega_body<Counted>,
     [](const Mat3& R, const Vec3& omega) -> Vec3 { return R.transpose() * omega; },
     [](const Mat3& R, const Vec3& omega_body) -> Vec3 { return R * omega_body; }},
    {"ω", "0: wrong", rate_of_constant_omega<double>, rate_of_constant_omega<Counted>, same, same}};

}  // namespace momentum_chapter
