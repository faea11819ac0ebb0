#pragma once
/// @file
/// How a body turns, in double-doubles: the truth that methods are measured by. A Taylor series of
/// order 36 whose steps leave 1e-30; written on its own, without the library's methods.
///
/// In principal axes, with the torque of a force F that is constant in the world, at the point p of
/// the body, and u = Rᵀ F:
///
///     J ω̇ = J ω × ω + p × u,   u̇ = u × ω,   q̇ = ½ q ⟨0, ω⟩

#include <algorithm>
#include <cmath>
#include <utility>

#include "tumble/core/types.hpp"
#include "tumble/free_body/polhode.hpp"
#include "tumble/simd/double_double.hpp"

namespace tumble::reference {

/// A body in its principal axes, and what pushes it.
struct Turning {
  Vec3 J;                 ///< [kg m²]
  Quat q;                 ///< of any length
  Vec3 L;                 ///< world
  Vec3 F = Vec3::Zero();  ///< world
  Vec3 p = Vec3::Zero();  ///< body
};

/// Where it is in the end.
struct TurningEnd {
  Quat q;
  Vec3 omega;  ///< body coordinates
};

class DoubleDoubleTurning {
 public:
  explicit DoubleDoubleTurning(const Turning& start) : body_(start) {
    const auto L = detail::into_body(start.q, start.L);
    const auto F = detail::into_body(start.q, start.F);
    const T q[4] = {start.q.w(), start.q.x(), start.q.y(), start.q.z()};
    for (int i = 0; i < 3; ++i) now_[i] = L[i] / T(start.J[i]), now_[3 + i] = F[i];
    for (int i = 0; i < 4; ++i) now_[6 + i] = q[i];
  }

  using State = Eigen::Matrix<simd::DoubleDouble, 10, 1>;  ///< ω, u, q

  TurningEnd at(double t1) {
    while (t_ < simd::DoubleDouble(t1)) {
      expand();
      const double left = double(simd::DoubleDouble(t1) - t_), h = std::min(step(), left);
      advance(h);
      t_ = h == left ? simd::DoubleDouble(t1)
                     : t_ + h;  // of a sum of doubles the digits would be missed
    }
    const auto number = [&](int i) { return double(now_[i]); };
    return {Quat(number(6), number(7), number(8), number(9)).normalized(),
            {number(0), number(1), number(2)}};
  }

  /// All digits of the state that it has come to.
  const State& now() const { return now_; }

  /// What the state's rates are there [1/s].
  State rates() {
    expand();
    return series_.col(1);
  }

  /// ω jumps, as it does in an impact [rad/s], body coordinates.
  void kick(const Eigen::Matrix<simd::DoubleDouble, 3, 1>& change) {
    for (int i = 0; i < 3; ++i) now_[i] += change[i];
  }

  /// Goes on, or back, by a time so short that t need not know of it.
  void shift(double h) {
    expand();
    advance(h);
  }

 private:
  using T = simd::DoubleDouble;
  static constexpr int order = 36;

  /// Coefficient k of the product of two components' series.
  T product(int a, int b, int k) const {
    T sum = 0;
    for (int j = 0; j <= k; ++j) sum += series_(a, j) * series_(b, k - j);
    return sum;
  }

  void expand() {
    const bool free = body_.F.isZero(0);
    series_.col(0) = now_;
    for (int k = 0; k < order; ++k) {
      const T next = T(1) / T(k + 1);
      auto s = series_.col(k + 1);
      const auto c = series_.col(k);
      for (int x = 0; x < 3; ++x) {
        const int y = (x + 1) % 3, z = (x + 2) % 3;
        const T torque = T(body_.p[y]) * c[3 + z] - T(body_.p[z]) * c[3 + y];
        s[x] = (product(y, z, k) * (T(body_.J[y]) - T(body_.J[z])) + torque) / T(body_.J[x]) * next;
        s[3 + x] = free ? T(0) : (product(3 + y, z, k) - product(3 + z, y, k)) * next;
        s[7 + x] = (product(6, x, k) + product(7 + y, z, k) - product(7 + z, y, k)) * T(0.5) * next;
      }
      s[6] = -(product(7, 0, k) + product(8, 1, k) + product(9, 2, k)) * T(0.5) * next;
    }
  }

  /// A step that leaves 1e-32 of each group's size.
  double step() const {
    double h = 1e300;
    for (const auto& [first, end] : {std::pair{0, 3}, std::pair{3, 6}, std::pair{6, 10}})
      for (const int k : {order - 1, order}) {
        double size = 0, last = 0;
        for (int i = first; i < end; ++i) {
          if (first == 0) size = std::max(size, std::sqrt(std::abs(series_(i, 1).hi)));  // at rest
          size = std::max(size, std::abs(series_(i, 0).hi));
          last = std::max(last, std::abs(series_(i, k).hi));
        }
        if (last > 0) h = std::min(h, std::pow(1e-33 * size / last, 1.0 / k));
      }
    return h;
  }

  void advance(double h) {
    for (int i = 0; i < 10; ++i) {
      T sum = series_(i, order);
      for (int k = order - 1; k >= 0; --k) sum = sum * h + series_(i, k);
      now_[i] = sum;
    }
  }

  Turning body_;
  simd::DoubleDouble t_ = 0;
  State now_;
  Eigen::Matrix<T, 10, order + 1> series_;
};

/// The state after the time t.
inline TurningEnd turned(const Turning& start, double t) {
  return DoubleDoubleTurning(start).at(t);
}

}  // namespace tumble::reference
