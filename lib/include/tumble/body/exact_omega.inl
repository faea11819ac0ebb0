#pragma once

#include "tumble/body/exact_omega.hpp"

#include <cmath>

#include "tumble/core/compiled.hpp"

namespace tumble::detail {

TUMBLE_BODY Vec3dd into_body(const Quat& q, const Vec3& L) {
  using T = simd::DoubleDouble;
  const T w = q.w();
  const Vec3dd v = q.vec().cast<T>(), l = L.cast<T>();
  const T vv = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
  const T vl = v[0] * l[0] + v[1] * l[1] + v[2] * l[2];
  const Vec3dd cross(v[1] * l[2] - v[2] * l[1], v[2] * l[0] - v[0] * l[2],
                     v[0] * l[1] - v[1] * l[0]);
  const T scale = T(1) / (w * w + vv);
  Vec3dd turned;
  for (int i = 0; i < 3; ++i)
    turned[i] = ((w * w - vv) * l[i] + (v[i] * vl - w * cross[i]) * 2) * scale;
  return turned;
}

TUMBLE_BODY Vec3 exact_omega(const RigidBody<>& body, const Quat& q, const Vec3& L) {
  // In units of its own: products of halves of very large numbers would overflow.
  const double unit = L.isZero(0) ? 1 : std::scalbn(1.0, std::ilogb(L.cwiseAbs().maxCoeff()));
  const Vec3dd L_body = into_body(q, L / unit);
  const Mat3& I = body.I_body();
  Vec3 omega = Vec3::Zero();
  constexpr int refinements = 3;  // each gains the digits that the tensor's condition leaves
  for (int k = 0; k <= refinements; ++k) {
    Vec3 residual;
    for (int i = 0; i < 3; ++i) {
      simd::DoubleDouble left = L_body[i];
      for (int j = 0; j < 3; ++j) left -= simd::DoubleDouble(I(i, j)) * omega[j];
      residual[i] = double(left);
    }
    omega += body.I_body_inv() * residual;
  }
  return unit * omega;
}

}  // namespace tumble::detail
