#pragma once
/// @file
/// Orientation as four numbers and as nine: their right-hand sides, and steps with a repair.

#include "common.hpp"

namespace quaternions_chapter {

/// The same steady turn as in chapter 3, whose exact orientation is known.
inline const Vec3 omega = 2 * Vec3(2, -1, 2).normalized();  // [rad/s]
inline constexpr double h = 1.0 / 60;                       // a frame of a game [s]

template <class T>
using Four = Eigen::Matrix<T, 4, 1>;
template <class T>
using Nine = Eigen::Matrix<T, 9, 1>;

/// q̇ = ½ ⟨0, ω⟩ q as a right-hand side, for an angular velocity ω(t).
template <class T, class Spin>
auto rate_of_four(Spin spin) {
  return [spin](const T& t, const Four<T>& y) -> Four<T> {
    return coefficients(rotation::quaternion_dot<T>(from_coefficients<T>(y), spin(t)));
  };
}

/// Ṙ = [ω]× R.
template <class T, class Spin>
auto rate_of_nine(Spin spin) {
  return [spin](const T& t, const Nine<T>& y) -> Nine<T> {
    return rotation::rotation_dot<T>(y.reshaped(3, 3), spin(t)).reshaped();
  };
}

inline const auto as_it_is = [](const auto& y) { return y; };
inline const auto normalised = [](const Four<double>& y) {
  return coefficients(rotation::normalize(from_coefficients(y)));
};

/// The state after so many steps, repaired by `repair` after each.
template <class Method, class State, class Rate, class Repair>
State stepped(const Rate& rate, State y, double step, int steps, Repair&& repair) {
  for (int i = 0; i < steps; ++i) y = repair(Method::step(rate, i * step, y, step));
  return y;
}

inline const Four<double> four_start = coefficients(Quat::Identity());
inline const Nine<double> nine_start = Mat3(Mat3::Identity()).reshaped();

inline Vec3 steady(double) { return omega; }

}  // namespace quaternions_chapter
