#pragma once

#include "tumble/steady/top_constants.hpp"

#include <algorithm>

#include "tumble/core/compiled.hpp"
#include "tumble/free_body/polhode.hpp"

namespace tumble::detail {

TUMBLE_BODY simd::DoubleDouble square_root(const simd::DoubleDouble& x) {
  if (!(simd::DoubleDouble(0) < x)) return 0;
  const double root = std::sqrt(x.hi);
  return simd::DoubleDouble(root) +
         (x - simd::DoubleDouble(root) * root) / simd::DoubleDouble(2 * root);
}

TUMBLE_BODY simd::DoubleDouble least_root(const simd::DoubleDouble& c2,
                                          const simd::DoubleDouble& c1,
                                          const simd::DoubleDouble& c0) {
  const double size =
      std::max({std::abs(c2.hi), std::sqrt(std::abs(c1.hi)), std::cbrt(std::abs(c0.hi))});
  double w = -2 * size, step = 1;
  for (int i = 0; i < 200 && std::abs(step) > 1e-8 * std::abs(w); ++i) {
    const double slope = (3 * w + 2 * c2.hi) * w + c1.hi;
    step = slope == 0 ? 0 : (((w + c2.hi) * w + c1.hi) * w + c0.hi) / slope;
    w -= step;
  }
  simd::DoubleDouble root = w;
  for (int i = 0; i < 3; ++i) {
    const simd::DoubleDouble slope = (root * 3 + c2 * 2) * root + c1;
    if (slope == simd::DoubleDouble(0)) break;
    root -= (((root + c2) * root + c1) * root + c0) / slope;
  }
  return root;
}

TUMBLE_BODY elliptic::Amplitude starting_amplitude(const TopConstants& m, double back, double down,
                                                   double rise) {
  // Next to the separatrix it takes long to leave w₂: how long, only the digits of cn tell.
  if (m.modulus().k2 > 0.5) {
    const double sn = std::sqrt(std::max(0.0, down / m.spread));
    return {std::copysign(sn, rise), std::sqrt(std::max(0.0, back / m.spread))};
  }
  // 2 am(v₀) from its cosine and its sine: each alone says little where it is nearly 1.
  const double dn = std::sqrt((back + (m.w2 - m.w3)) / (m.w1 - m.w3));
  const double am = std::atan2(rise / (m.spread * m.lambda() * dn), (back - down) / m.spread) / 2;
  return {std::sin(am), std::cos(am)};
}

TUMBLE_BODY std::optional<TopConstants> top_constants(double A, double mu, const Vec3dd& L,
                                                      const Vec3dd& up) {
  using T = simd::DoubleDouble;
  // 1 − cos θ from the sine where the axis is nearly upright: of the cosine nothing is left there.
  const T sin2 = up[0] * up[0] + up[1] * up[1];
  const T w0 = up[2].hi > 0 ? sin2 / (T(1) + up[2]) : T(1) - up[2];
  const T excess = L[0] * up[0] + L[1] * up[1] - L[2] * w0;
  const T Amu = T(A) * T(mu);
  const T epsilon = (L[0] * L[0] + L[1] * L[1]) / (Amu * 2) - w0;  // ε/μ
  const T c2 = epsilon - T(2) + L[2] * L[2] / (Amu * 2), c1 = excess * L[2] / Amu - epsilon * 2,
          c0 = excess * excess / (Amu * 2);
  if (c1 == T(0) && c0 == T(0)) return {};  // upright, and nothing tips it over
  const T w3 = least_root(c2, c1, c0), sum = -c2 - w3, product = c1 - w3 * sum;  // of w₁ and w₂
  constexpr double closest =
      1e-3;  // cosine of η: of the digits a part of its inverse square is lost
  if (!(sum.hi > closest * closest * -w3.hi)) return {};
  const T spread = square_root(sum * sum - product * 4);
  const T w1 = (sum + spread) * 0.5, w2 = product / w1;

  TopConstants m{A,          mu,         double(L[2]), double(L[2] + excess), double(excess),
                 double(w1), double(w2), double(w3),   double(spread),        {0, 1}};
  if (!(m.w2 > closest * closest * (m.w2 - m.w3)) || !(2 - m.w1 > closest * closest * (2 - m.w3)))
    return {};
  const double rise = double(L[1] * up[0] - L[0] * up[1]) / A;  // d(cos θ)/dt
  if (m.spread > 0) m.start = starting_amplitude(m, double(w0 - w2), double(w1 - w0), rise);
  return m;
}

}  // namespace tumble::detail
