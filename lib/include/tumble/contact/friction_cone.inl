#pragma once

#include "tumble/contact/friction_cone.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>

#include "tumble/core/compiled.hpp"
#include "tumble/ode/linear_solver.hpp"

namespace tumble::contact::detail {

TUMBLE_BODY Vec2 holding_friction(const Mat3& K) {
  const Mat2 K_tt = K.topLeftCorner<2, 2>();
  const Vec2 K_tn = K.topRightCorner<2, 1>();
  return -tumble::detail::SmallLu<Mat2>(K_tt).solve(K_tn);
}

TUMBLE_BODY Vec2 direction_of_escape(const Mat3& K, double mu) {
  const Mat2 stiffness = mu * K.topLeftCorner<2, 2>();
  const Vec2 push = K.topRightCorner<2, 1>();
  const auto slide = [&](double lambda) -> Vec2 {
    return (stiffness + lambda * Mat2::Identity()).inverse() * push;
  };
  double low = 0, high = push.norm();  // |slide(|push|)| < 1
  for (int i = 0; i < 200 && std::nextafter(low, high) < high; ++i) {
    const double middle = low + (high - low) / 2;
    (slide(middle).squaredNorm() > 1 ? low : high) = middle;
  }
  return slide(high).normalized();
}

}  // namespace tumble::contact::detail
