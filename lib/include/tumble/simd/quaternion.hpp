#pragma once
/// @file
/// Quaternions whose numbers are Packs: many orientations at once.

#include "tumble/simd/point.hpp"

namespace tumble::simd {

/// @addtogroup simd
/// @{

/// w + x i + y j + z k.
template <class P>
struct Quaternion {
  P w, x, y, z;
};

template <class P>
TUMBLE_INLINE Quaternion<P> operator*(const Quaternion<P>& a, const Quaternion<P>& b) {
  return {
      a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
      a.w * b.y + a.y * b.w + a.z * b.x - a.x * b.z, a.w * b.z + a.z * b.w + a.x * b.y - a.y * b.x};
}

/// a + s b
template <class S, class P>
TUMBLE_INLINE Quaternion<P> add_scaled(const Quaternion<P>& a, const S& s, const Quaternion<P>& b) {
  return {a.w + s * b.w, a.x + s * b.x, a.y + s * b.y, a.z + s * b.z};
}

/// The rotation the other way, of a unit quaternion.
template <class P>
TUMBLE_INLINE Quaternion<P> conjugate(const Quaternion<P>& q) {
  return {q.w, -q.x, -q.y, -q.z};
}

/// R p for a unit quaternion: p + 2w (v × p) + 2 v × (v × p), v its vector part.
template <class P>
TUMBLE_INLINE Point<P> rotate(const Quaternion<P>& q, const Point<P>& p) {
  const Point<P> v{q.x, q.y, q.z}, t = cross(Point<P>{v.x + v.x, v.y + v.y, v.z + v.z}, p);
  return add_cross(add_scaled(p, q.w, t), v, t);
}

/// q ⟨0, p⟩
template <class P>
TUMBLE_INLINE Quaternion<P> times_vector(const Quaternion<P>& q, const Point<P>& p) {
  return {-(q.x * p.x + q.y * p.y + q.z * p.z), q.w * p.x + q.y * p.z - q.z * p.y,
          q.w * p.y + q.z * p.x - q.x * p.z, q.w * p.z + q.x * p.y - q.y * p.x};
}

/// q ½(3 − |q|²), which is q/|q| but for ⅜(|q|² − 1)²: one step of Newton's method for 1/√.
template <class P>
TUMBLE_INLINE Quaternion<P> nearly_normalised(const Quaternion<P>& q) {
  const P scale = 1.5 - 0.5 * (q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  return {q.w * scale, q.x * scale, q.y * scale, q.z * scale};
}

/// (cos ½θ, sin ½θ u) of the rotation vector θ u, to rounding for θ ≤ ½ rad; beyond it what is left
/// out of the series grows as θ¹⁴/2·10¹⁵.
template <class P>
TUMBLE_INLINE Quaternion<P> exp_small(const Point<P>& r) {
  const P x = 0.25 * (r.x * r.x + r.y * r.y + r.z * r.z);  // (½θ)²
  constexpr double c[] = {1,          -1. / 2,       1. / 24,       -1. / 720,
                          1. / 40320, -1. / 3628800, 1. / 479001600};  // cos √x
  constexpr double s[] = {1. / 2,      -1. / 12,    1. / 240,
                          -1. / 10080, 1. / 725760, -1. / 79833600};  // sin √x / 2√x
  P cosine = P{} + c[6], sine = P{} + s[5];
#pragma GCC unroll 8
  for (int k = 5; k >= 0; --k) cosine = cosine * x + c[k];
#pragma GCC unroll 8
  for (int k = 4; k >= 0; --k) sine = sine * x + s[k];
  return {cosine, sine * r.x, sine * r.y, sine * r.z};
}

/// @}

}  // namespace tumble::simd
