#pragma once
/// @file
/// Laws for a body that nothing pushes: the right one in two forms, and two wrong ones.

#include <array>
#include <string_view>

#include "tumble/body.hpp"
#include "tumble/quaternion.hpp"

namespace rigid_body_chapter {

using namespace tumble;

/// q, and L or ω in body axes.
using Seven = Eigen::Matrix<double, 7, 1>;

inline Quat orientation_in(const Seven& y) { return {y[0], y[1], y[2], y[3]}; }

inline Seven seven(const Quat& q, const Vec3& three) {
  Seven y;
  y << coefficients(q), three;
  return y;
}

/// A law of motion for a body that nothing pushes, and what its last three numbers are.
struct Law {
  std::string_view name;
  Seven (*rate)(const RigidBody<>&, const Seven&);
  bool of_L;  ///< L in world axes; else ω in body axes
};

inline Vec3 omega_of(const RigidBody<>& body, const Quat& q, const Vec3& L) {
  return angular_velocity(body, to_matrix(q), L);
}

inline Seven L_stays(const RigidBody<>& body, const Seven& y) {
  const Quat q = orientation_in(y);
  return seven(rotation::quaternion_dot<double>(q, omega_of(body, q, y.tail<3>())), Vec3::Zero());
}

inline Seven by_euler(const RigidBody<>& body, const Seven& y) {
  const Vec3 omega = y.tail<3>(), L = body.I_body() * omega;
  return seven(rotation::quaternion_dot_body<double>(orientation_in(y), omega),
               body.I_body_inv() * L.cross(omega));
}

inline Seven omega_stays(const RigidBody<>&, const Seven& y) {
  return seven(rotation::quaternion_dot_body<double>(orientation_in(y), y.tail<3>()), Vec3::Zero());
}

inline Seven with_the_term_in_the_world(const RigidBody<>& body, const Seven& y) {
  const Quat q = orientation_in(y);
  const Vec3 L = y.tail<3>(), omega = omega_of(body, q, L);
  return seven(rotation::quaternion_dot<double>(q, omega), L.cross(omega));
}

inline constexpr std::array<Law, 4> laws{
    Law{"rate of L: 0", L_stays, true},
    {"rate of ω: I⁻¹ (−ω × I ω)", by_euler, false},
    {"rate of ω: 0, term left out", omega_stays, false},
    {"rate of L: −ω × L, term put in", with_the_term_in_the_world, true}};

}  // namespace rigid_body_chapter
