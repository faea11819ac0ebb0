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

#include "tumble/core/types.hpp"

namespace tumble {

/// @addtogroup rotation
/// @{

/// The axes of the three turns, in order: six Tait–Bryan sequences, six proper Euler sequences.
enum class EulerSequence { xyz, xzy, yxz, yzx, zxy, zyx, xyx, xzx, yxy, yzy, zxz, zyz };

namespace detail {

/// The axes of a sequence as 0, 1, 2 for x, y, z.
/// @throws std::invalid_argument if `sequence` is none of the twelve
std::array<int, 3> axes_of(EulerSequence sequence);

}  // namespace detail

/// The rotation by `angle` [rad] about coordinate axis 0, 1 or 2.
inline Mat3 axis_rotation(int axis, double angle) {
  return Eigen::AngleAxisd(angle, Vec3::Unit(axis)).toRotationMatrix();
}

/// R = R_i(α) R_j(β) R_k(γ).
/// @param angles   (α, β, γ) [rad], in the order of the sequence
/// @param sequence the axes i, j, k
/// @throws std::invalid_argument if an angle is not finite
Mat3 euler_angles_to_matrix(const Vec3& angles, EulerSequence sequence);

/// The angles (α, β, γ) [rad] of a rotation matrix, with −π ≤ α, γ ≤ π and β in [−π/2, π/2] for the
/// six Tait–Bryan sequences, in [0, π] for the six proper ones. At the singular β (gimbal lock)
/// only α ± γ is determined; the angles returned still give R back to rounding.
/// @param R a rotation matrix; not checked
Vec3 matrix_to_euler_angles(const Mat3& R, EulerSequence sequence);

/// R = R_k(γ) R_j(β) R_i(α): the same three turns about the *fixed* world axes i, then j, then k.
/// @param angles (α, β, γ) [rad], in the order of the sequence
Mat3 fixed_angles_to_matrix(const Vec3& angles, EulerSequence sequence);

/// @}

}  // namespace tumble

#ifndef TUMBLE_COMPILED
#include "tumble/rotation/euler_angles.inl"
#endif
