#pragma once
/// @file
/// What the chapter's programs share: how numbers are written, and how far apart two orientations
/// are.

#include <cmath>
#include <string>

#include "paper_rotation.hpp"
#include "support/table.hpp"
#include "tumble/quaternion/exp_log.hpp"
#include "tumble/rotation.hpp"

namespace rotation_matrices_chapter {

using namespace tumble;
using support::error_number;
using support::number;
using support::Table;

/// How far apart two orientations are [rad].
inline double angle_apart(const Mat3& A, const Mat3& B) {
  return log_rotation(A.transpose() * B).norm();
}

/// (0.492, 0.87, 0.025), with three digits behind the point.
inline std::string in_brackets(const Vec3& v) {
  std::string text;
  for (const double x : v) text += (text.empty() ? "" : ", ") + support::svg_number(x, 3);
  return "(" + text + ")";
}

/// From the front, a little to the right and above: x to the right, y away, z up.
inline Mat3 front_view() { return support::view_from(-72 * degree, 20 * degree); }

}  // namespace rotation_matrices_chapter
