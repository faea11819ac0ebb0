#pragma once
/// @file
/// Principal axes and turned vectors with twice the digits of a double, written on their own.

#include <cmath>

#include "tumble/core/types.hpp"
#include "tumble/simd/double_double.hpp"

namespace tumble::test {

using Long = long double;
using LongVec = Vector3<Long>;
using DD = simd::DoubleDouble;

inline Long as_long(const DD& x) { return static_cast<Long>(x.hi) + static_cast<Long>(x.lo); }
inline DD root(const DD& x) {
  const DD first = std::sqrt(x.hi);
  const DD second = (first + x / first) * DD(0.5);
  return (second + x / second) * DD(0.5);
}

/// Principal moments, and the axes as columns.
struct ExactAxes {
  Matrix3<DD> R;
  Vector3<DD> moments;
};

/// Jacobi's rotations with twice the digits.
inline ExactAxes exact_axes(const Mat3& I_body) {
  Matrix3<DD> A, R;
  const double size = I_body.trace();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      A(i, j) = DD(I_body(i, j)) / DD(size);
      R(i, j) = i == j ? 1 : 0;
    }
  for (int turn = 0; turn < 30; ++turn) {
    const int i = turn % 3 == 2 ? 1 : 0, j = turn % 3 == 0 ? 1 : 2, k = 3 - i - j;
    const DD a = A(i, j);
    if (std::abs(a.hi) < 1e-40) continue;
    const DD theta = (A(j, j) - A(i, i)) / (a * DD(2));
    DD t = DD(1) / ((theta.hi < 0 ? -theta : theta) + root(theta * theta + DD(1)));
    if (theta.hi < 0) t = -t;
    const DD c = DD(1) / root(t * t + DD(1)), s = t * c;
    A(i, i) = A(i, i) - t * a;
    A(j, j) = A(j, j) + t * a;
    A(i, j) = A(j, i) = 0;
    const DD p = A(i, k), q = A(j, k);
    A(i, k) = A(k, i) = c * p - s * q;
    A(j, k) = A(k, j) = s * p + c * q;
    for (int r = 0; r < 3; ++r) {
      const DD u = R(r, i), v = R(r, j);
      R(r, i) = c * u - s * v;
      R(r, j) = s * u + c * v;
    }
  }
  return {R, {A(0, 0) * DD(size), A(1, 1) * DD(size), A(2, 2) * DD(size)}};
}

/// Rᵀ(q) v, q of any length.
inline Vector3<DD> into_body(const Quat& q, const Vec3& v) {
  const DD w = q.w(), x = -q.x(), y = -q.y(), z = -q.z();
  const DD n = w * w + x * x + y * y + z * z;
  const Vector3<DD> a(v[0], v[1], v[2]);
  const DD c0 = y * a[2] - z * a[1], c1 = z * a[0] - x * a[2], c2 = x * a[1] - y * a[0];
  const DD d = x * a[0] + y * a[1] + z * a[2], e = w * w - (x * x + y * y + z * z);
  const DD two = 2;
  return {(e * a[0] + two * (d * x + w * c0)) / n, (e * a[1] + two * (d * y + w * c1)) / n,
          (e * a[2] + two * (d * z + w * c2)) / n};
}

}  // namespace tumble::test
