#pragma once
/// @file
/// What the topics of the chapter share.

#include <string>

#include "mixtures.hpp"
#include "support/sketch.hpp"
#include "support/table.hpp"
#include "tumble/quaternion.hpp"
#include "tumble/rotation.hpp"

namespace quaternions_chapter {

using support::degrees;
using support::error_number;
using support::error_or_rounding;
using support::number;
using support::Table;
using support::Vec2;

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

}  // namespace quaternions_chapter
