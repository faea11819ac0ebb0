#pragma once
/// @file
/// The stability function of a method, asked of the method itself, and the border of its region.

#include <complex>
#include <numbers>

#include "plane.hpp"
#include "tumble/ode/jacobian.hpp"

namespace solvers_chapter {

using Complex = std::complex<double>;

/// R(z): what one step of length 1 makes of y = 1 under y' = z y. A complex number is a pair of
/// real ones.
template <class Method>
Complex stability_function(Complex z) {
  Eigen::Matrix2d turn;
  turn << z.real(), -z.imag(), z.imag(), z.real();
  const auto f = [&](double, const Vec2& y) -> Vec2 { return turn * y; };
  const auto jacobian = [&](double, const Vec2&) { return turn; };
  const Vec2 y = Method::step(tumble::with_jacobian(f, jacobian), 0.0, Vec2(1, 0), 1.0);
  return {y[0], y[1]};
}

/// The curve |R| = 1 through 0: R runs round the unit circle, z after it, by Newton's method.
/// @param R a stability function
inline Path stability_boundary(Complex (*R)(Complex)) {
  constexpr int points_a_turn = 48;
  Path path{Vec2(0, 0)};
  Complex z = 0;
  for (int i = 1; i < 12 * points_a_turn; ++i) {
    const Complex target = std::polar(1.0, 2 * std::numbers::pi * i / points_a_turn);
    for (int round = 0; round < 12; ++round) {
      const Complex d(1e-6, 0), here = R(z);
      z -= (here - target) * d / (R(z + d) - here);
    }
    path.emplace_back(z.real(), z.imag());
    if (i % points_a_turn == 0 && std::abs(z) < 1e-3) break;
  }
  return path;
}

}  // namespace solvers_chapter
