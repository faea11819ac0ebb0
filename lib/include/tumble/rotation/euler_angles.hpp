#pragma once
/// @file
/// Three angles for an orientation, in all twelve orders, both ways.
///
/// R = R_i(α) R_j(β) R_k(γ): turn by α about axis i, then by β about the *new* axis j, then by γ
/// about the newest axis k (rotating axes). Turning about the fixed world axes k, j, i in that
/// order, by γ, β, α, gives the same R: see fixed_angles_to_matrix().
///
/// Source: Goldstein, Poole & Safko, "Classical Mechanics" (2002), §4.4 and appendix A; the inverse
/// follows Shuster's idea to take the first angle out before the other two are read.

#include <array>
#include <cmath>
#include <utility>

#include "tumble/core/require.hpp"
#include "tumble/core/types.hpp"

namespace tumble {

/// @addtogroup rotation
/// @{

/// The axes of the three turns, in order: six Tait–Bryan sequences, six proper Euler sequences.
enum class EulerSequence { xyz, xzy, yxz, yzx, zxy, zyx, xyx, xzx, yxy, yzy, zxz, zyz };

namespace detail {

/// The axes of a sequence as 0, 1, 2 for x, y, z.
/// @throws std::invalid_argument if `sequence` is none of the twelve
inline std::array<int, 3> axes_of(EulerSequence sequence) {
  constexpr std::array<std::array<int, 3>, 12> axes{{{0, 1, 2},
                                                     {0, 2, 1},
                                                     {1, 0, 2},
                                                     {1, 2, 0},
                                                     {2, 0, 1},
                                                     {2, 1, 0},
                                                     {0, 1, 0},
                                                     {0, 2, 0},
                                                     {1, 0, 1},
                                                     {1, 2, 1},
                                                     {2, 0, 2},
                                                     {2, 1, 2}}};
  const auto index = static_cast<std::size_t>(sequence);
  require(index < axes.size(), "there is no Euler sequence number ", index);
  return axes[index];
}

}  // namespace detail

/// The rotation by `angle` [rad] about coordinate axis 0, 1 or 2.
inline Mat3 axis_rotation(int axis, double angle) {
  return Eigen::AngleAxisd(angle, Vec3::Unit(axis)).toRotationMatrix();
}

/// R = R_i(α) R_j(β) R_k(γ).
/// @param angles   (α, β, γ) [rad], in the order of the sequence
/// @param sequence the axes i, j, k
/// @throws std::invalid_argument if an angle is not finite
inline Mat3 euler_angles_to_matrix(const Vec3& angles, EulerSequence sequence) {
  require(angles.allFinite(), "Euler angles must be finite, got ", angles.transpose());
  const auto [i, j, k] = detail::axes_of(sequence);
  return axis_rotation(i, angles[0]) * axis_rotation(j, angles[1]) * axis_rotation(k, angles[2]);
}

/// The angles (α, β, γ) [rad] of a rotation matrix, with −π ≤ α, γ ≤ π and β in [−π/2, π/2] for the
/// six Tait–Bryan sequences, in [0, π] for the six proper ones. At the singular β (gimbal lock)
/// only α ± γ is determined; the angles returned still give R back to rounding.
/// @param R a rotation matrix; not checked
inline Vec3 matrix_to_euler_angles(const Mat3& R, EulerSequence sequence) {
  const auto [i, j, last] = detail::axes_of(sequence);
  const bool proper = last == i;
  const int k = 3 - i - j;
  const double s = (j - i + 3) % 3 == 1 ? 1 : -1;  // e_i × e_j = s e_k

  // The image of the last axis does not depend on γ, and its azimuth about axis i is α.
  const double alpha =
      proper ? std::atan2(R(j, i), -s * R(k, i)) : std::atan2(-s * R(j, k), R(k, k));
  // With the first turn taken out, β and γ are read off what is left, stable even at gimbal lock.
  const Mat3 M = axis_rotation(i, -alpha) * R;
  if (proper) return {alpha, std::atan2(-s * M(k, i), M(i, i)), std::atan2(-s * M(j, k), M(j, j))};
  return {alpha, std::atan2(s * M(i, k), M(k, k)), std::atan2(s * M(j, i), M(j, j))};
}

/// R = R_k(γ) R_j(β) R_i(α): the same three turns about the *fixed* world axes i, then j, then k.
/// @param angles (α, β, γ) [rad], in the order of the sequence
inline Mat3 fixed_angles_to_matrix(const Vec3& angles, EulerSequence sequence) {
  require(angles.allFinite(), "fixed-axis angles must be finite, got ", angles.transpose());
  const auto [i, j, k] = detail::axes_of(sequence);
  return axis_rotation(k, angles[2]) * axis_rotation(j, angles[1]) * axis_rotation(i, angles[0]);
}

/// @}

}  // namespace tumble
