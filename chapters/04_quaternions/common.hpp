#pragma once
/// @file
/// What the topics of the chapter share.

#include <cmath>
#include <numbers>
#include <string>

#include "support/sketch.hpp"
#include "support/table.hpp"
#include "tumble/quaternion.hpp"
#include "tumble/rotation.hpp"

namespace quaternions_chapter {

using namespace tumble;
using support::degrees;
using support::error_number;
using support::error_or_rounding;
using support::number;
using support::Table;
using support::Vec2;

inline constexpr double pi = std::numbers::pi, degree = pi / 180;

/// How far apart two orientations are [rad].
inline double angle_apart(const Mat3& A, const Mat3& B) {
  return log_rotation(A.transpose() * B).norm();
}

inline std::string four_numbers(const Quat& q) {
  std::string text;
  for (const double x : coefficients(q))
    text += (text.empty() ? "" : ", ") + support::svg_number(x, 4);
  return "(" + text + ")";
}

inline Quat mix_four(const Quat& a, const Quat& b, double t) {
  const double side = a.dot(b) < 0 ? -1 : 1;
  return Quat(Eigen::Vector4d((1 - t) * a.coeffs() + t * side * b.coeffs()));
}

}  // namespace quaternions_chapter
