#pragma once

#include "tumble/contact/flight.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "tumble/core/compiled.hpp"

namespace tumble::contact::detail {

TUMBLE_BODY std::vector<Vec3> ends_of_polhodes(const Vec3& I, double L2, double twice_T) {
  constexpr double rounding = 1e-9;
  std::vector<Vec3> ends;
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    const double over = twice_T - L2 / I[j], span = 1 / I[i] - 1 / I[j];
    const double share = span == 0 ? 0 : over / span / L2;
    if (!(share >= -rounding && share <= 1 + rounding)) continue;
    if (span == 0 && std::abs(over) > rounding * twice_T) continue;
    Vec3 squares = Vec3::Zero();
    squares[i] = std::clamp(share, 0., 1.) * L2;
    squares[j] = L2 - squares[i];
    ends.push_back(squares);
  }
  return ends;
}

}  // namespace tumble::contact::detail

namespace tumble::contact {

TUMBLE_BODY TurningBounds turning_bounds(const PrincipalAxes& axes, const Vec3& L) {
  const Vec3 &I = axes.moments, omega = L.cwiseQuotient(I);
  TurningBounds bounds{omega.norm(), 0};
  if (L.isZero(0)) return bounds;
  Vec3 most = L.cwiseAbs2();
  for (const Vec3& squares : detail::ends_of_polhodes(I, L.squaredNorm(), L.dot(omega))) {
    most = most.cwiseMax(squares);
    bounds.spin = std::max(bounds.spin, squares.cwiseSqrt().cwiseQuotient(I).norm());
  }
  // Euler's equations: ω̇ᵢ = (Iⱼ − Iₖ)/(Iᵢ Iⱼ Iₖ) Lⱼ Lₖ
  Vec3 rates;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    rates[i] = (I[j] - I[k]) / I[i] * (std::sqrt(most[j]) / I[j]) * (std::sqrt(most[k]) / I[k]);
  }
  constexpr double wider = 1 + 1e-8;  // than what the ends were rounded by
  bounds.spin *= wider;
  bounds.acceleration = wider * rates.norm();
  return bounds;
}

}  // namespace tumble::contact
