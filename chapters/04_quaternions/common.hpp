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
using support::error_number;
using support::number;
using support::Table;
using support::Vec2;

inline constexpr double pi = std::numbers::pi, degree = pi / 180;

/// How far apart two orientations are [rad].
inline double angle_apart(const Mat3& A, const Mat3& B) {
  return log_rotation(A.transpose() * B).norm();
}

inline std::string degrees(double angle, int digits = 4) {
  return number(angle / degree, digits) + "°";
}

/// An error, or that there is none but rounding.
inline std::string error_or_rounding(double error) {
  if (std::isnan(error)) return "not a number";
  return error < 1e-14 ? "< 1e-14" : error_number(error);
}

inline std::string four_numbers(const Quat& q) {
  std::string text;
  for (const double x : coefficients(q))
    text += (text.empty() ? "" : ", ") + support::svg_number(x, 4);
  return "(" + text + ")";
}

}  // namespace quaternions_chapter
