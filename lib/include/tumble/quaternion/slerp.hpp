#pragma once
/// @file
/// Between two orientations at constant angular velocity, the short way round.
///
/// slerp(a, b, t) = a (a⁻¹ b)^t, which is (sin((1−t)Ω) a + sin(tΩ) b) / sin Ω without the 0/0 at Ω
/// = 0 and without an arc cosine. Source: Shoemake, SIGGRAPH 1985, §3.3.

#include "tumble/core/types.hpp"
#include "tumble/quaternion/exp_log.hpp"

namespace tumble {

/// @addtogroup quaternion
/// @{

/// The orientation a fraction t of the way from a to b: a at t = 0, b (or −b) at t = 1.
/// @param a, b unit quaternions; b and −b give the same path, never longer than π
/// @param t    any real; outside [0, 1] the turn goes on at the same rate
template <class T>
Quaternion<T> slerp(const Quaternion<T>& a, const Quaternion<T>& b, const T& t) {
  return a * exp_quaternion<T>(t * log_quaternion<T>(a.conjugate() * b));
}

/// @}

}  // namespace tumble
