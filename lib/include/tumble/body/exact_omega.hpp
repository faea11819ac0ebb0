#pragma once
/// @file
/// ω with all its digits. In doubles, ω = I_body⁻¹ Rᵀ L of a needle loses those of its spin about
/// itself: they are what remains of numbers that are as much larger as the needle is long.
///
/// Source: refinement of a linear system's solution, its residual in twice the digits: Higham,
/// "Accuracy and Stability of Numerical Algorithms" (2002), §12.1.

#include "tumble/body/rigid_body.hpp"
#include "tumble/core/types.hpp"
#include "tumble/simd/double_double.hpp"

namespace tumble::detail {

using Vec3dd = Vector3<simd::DoubleDouble>;

/// Rᵀ(q) L with twice the digits, q of any length but zero.
Vec3dd into_body(const Quat& q, const Vec3& L);

/// ω in body coordinates [rad/s].
/// @param q of moderate length
Vec3 exact_omega(const RigidBody<>& body, const Quat& q, const Vec3& L);

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/body/exact_omega.inl"
#endif
