#pragma once
/// @file
/// Points whose coordinates are numbers of any kind: doubles, Pairs, Packs, or Pairs of Packs.

#include <type_traits>

#include "tumble/simd/pair.hpp"

namespace tumble::simd {

/// @addtogroup simd
/// @{

/// A point or vector.
template <class T>
struct Point {
  T x, y, z;
};

template <class T>
TUMBLE_INLINE Point<T> operator+(const Point<T>& a, const Point<T>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
TUMBLE_INLINE Point<T> operator-(const Point<T>& a, const Point<T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

/// s p. @param s a double, or a T
template <class S, class T>
TUMBLE_INLINE Point<T> operator*(const S& s, const Point<T>& p) {
  return {s * p.x, s * p.y, s * p.z};
}

/// a + s p, each sum of a product in one expression, which a compiler may make one instruction of.
template <class S, class T>
TUMBLE_INLINE Point<T> add_scaled(const Point<T>& a, const S& s, const Point<T>& p) {
  return {a.x + s * p.x, a.y + s * p.y, a.z + s * p.z};
}

/// The products of the coordinates: diag(d) p.
template <class T>
TUMBLE_INLINE Point<T> scaled_axes(const Point<T>& d, const Point<T>& p) {
  return {d.x * p.x, d.y * p.y, d.z * p.z};
}

/// a × b
template <class T>
TUMBLE_INLINE Point<T> cross(const Point<T>& a, const Point<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// c + a × b
template <class T>
TUMBLE_INLINE Point<T> add_cross(const Point<T>& c, const Point<T>& a, const Point<T>& b) {
  return {c.x + a.y * b.z - a.z * b.y, c.y + a.z * b.x - a.x * b.z, c.z + a.x * b.y - a.y * b.x};
}

/// a · b. @tparam fma how products are added up: see multiply_add()
template <Fma fma = baseline_fma, class T>
TUMBLE_INLINE T dot(const Point<T>& a, const Point<T>& b) {
  return detail::multiply_add<fma>(a.x, b.x, detail::multiply_add<fma>(a.y, b.y, a.z * b.z));
}

template <class P>
TUMBLE_INLINE const P& leading(const P& x) {
  return x;
}
template <class P, Fma fma>
TUMBLE_INLINE const P& leading(const detail::Pair<P, fma>& x) {
  return x.hi;
}

/// Of Pairs their leading parts.
template <class T>
TUMBLE_INLINE auto leading(const Point<T>& p) {
  return Point<std::remove_cvref_t<decltype(leading(p.x))>>{leading(p.x), leading(p.y),
                                                            leading(p.z)};
}

/// |x| + |y| + |z|, of Pairs that of their leading parts.
template <class T>
TUMBLE_INLINE auto norm1(const Point<T>& p) {
  return absolute(leading(p.x)) + absolute(leading(p.y)) + absolute(leading(p.z));
}

/// 6V of the tetrahedron on the triangle a, b, c with its apex in the origin: positive if they go
/// round counter-clockwise seen from outside.
template <Fma fma = baseline_fma, class T>
TUMBLE_INLINE T six_volume(const Point<T>& a, const Point<T>& b, const Point<T>& c) {
  return dot<fma>(cross(b - a, c - a), a);
}

/// @}

}  // namespace tumble::simd
