#pragma once

#include "tumble/free_body/polhode.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tumble/body/rigid_body.hpp"
#include "tumble/body/state.hpp"
#include "tumble/core/compiled.hpp"
#include "tumble/quaternion/convert.hpp"

namespace tumble::detail {

TUMBLE_BODY Vec3dd principal_momentum(const PrincipalAxes& p, const Quat& q, const Vec3& L) {
  const Vec3dd l = into_body(q, L);
  Vec3dd m;
  for (int i = 0; i < 3; ++i) m[i] = l[0] * p.R(0, i) + l[1] * p.R(1, i) + l[2] * p.R(2, i);
  return m;
}

TUMBLE_BODY simd::DoubleDouble separation(const Vec3& moments, const Vec3dd& m) {
  using T = simd::DoubleDouble;
  const T low(moments[0]), middle(moments[1]), high(moments[2]);
  return m[2] * m[2] * ((high - middle) / high) - m[0] * m[0] * ((middle - low) / low);
}

TUMBLE_BODY SignedAxes signed_axes(const Vec3dd& m, bool about_largest) {
  SignedAxes axes = about_largest ? SignedAxes{{0, 1, 2}, {1, 1, 1}}  //
                                  : SignedAxes{{2, 1, 0}, {1, -1, 1}};
  const auto negative = [&](int i) { return axes.sign[i] * m[axes.order[i]].hi < 0; };
  if (negative(2)) {
    axes.sign[1] *= -1;
    axes.sign[2] *= -1;
  }
  if (negative(0)) {
    axes.sign[0] *= -1;
    axes.sign[1] *= -1;
  }
  return axes;
}

TUMBLE_BODY Quat frame_of(const Mat3& R, const SignedAxes& axes, bool pole_is_axis) {
  Mat3 rows;
  for (int i = 0; i < 3; ++i)
    rows.row(pole_is_axis ? i : (i + 2) % 3) = axes.sign[i] * R.col(axes.order[i]).transpose();
  return from_matrix(rows);
}

TUMBLE_BODY elliptic::Polhode polhode_through(const Vec3& J, const Vec3& s, double separation,
                                              double G) {
  const double d31 = J[2] - J[0], d32 = J[2] - J[1], d21 = J[1] - J[0];  // all of one sign
  const double from_largest = s[0] * d31 / J[0] + s[1] * d32 / J[1];     // (2 T J₃ − G²)/G²
  const double from_smallest = s[1] * d21 / J[1] + s[2] * d31 / J[2];    // (G² − 2 T J₁)/G²
  const double span = d32 * from_smallest;
  const double share1 = J[0] * d32 / (J[1] * d31), share3 = J[2] * d21 / (J[1] * d31);
  elliptic::Polhode p;
  p.G = G;
  p.J = J;
  p.modulus = {d21 * from_largest / span, std::abs(d31 / span) * separation};
  p.lambda = std::copysign(G * std::sqrt(d32 / J[0] * (from_smallest / J[1]) / J[2]), d31);
  p.amplitudes = Vec3(s[0] + s[1] * share1, s[1] + s[0] / share1, s[2] + s[1] * share3);
  p.pole_is_axis = p.amplitudes[2] <= 0.5;
  p.amplitudes = p.amplitudes.cwiseSqrt();
  p.eta = p.pole_is_axis ? elliptic::Amplitude{p.amplitudes[2], p.amplitudes[0]}
                         : elliptic::Amplitude{std::sqrt(share1), std::sqrt(share3)};
  return p;
}

}  // namespace tumble::detail

namespace tumble::elliptic {

TUMBLE_BODY std::optional<Polhode> polhode_of(const PrincipalAxes& axes, const Quat& q,
                                              const Vec3& L) {
  if (L.isZero(0)) return {};
  const double size = std::exp2(std::ilogb(L.cwiseAbs().maxCoeff()));  // no digit changes
  const detail::Vec3dd m = detail::principal_momentum(axes, q, L / size);
  const auto counts = [&](int i) { return std::abs(m[i].hi) > 1e-150; };
  if (counts(0) + counts(1) + counts(2) < 2) return {};

  const simd::DoubleDouble separation = detail::separation(axes.moments, m);
  const detail::SignedAxes sorted = detail::signed_axes(m, !(separation < simd::DoubleDouble(0)));
  const Vec3 rounded(m[0].hi, m[1].hi, m[2].hi), direction = sorted.of(rounded) / rounded.norm();
  // Only L/J counts: measured by the largest moment, no product leaves the range.
  const double unit = std::exp2(std::ilogb(axes.moments[2]));
  Polhode p = detail::polhode_through(sorted.of(axes.moments / unit), direction.cwiseAbs2(),
                                      std::abs(double(separation)) / rounded.squaredNorm(),
                                      size / unit * rounded.norm());
  p.u0 = detail::start_of(p.modulus, std::abs(direction[0]) / p.amplitudes[0],
                          sorted.sign[1] * direction[1] / p.amplitudes[1]);
  p.frame = detail::frame_of(axes.R, sorted, p.pole_is_axis);
  return p;
}

}  // namespace tumble::elliptic
