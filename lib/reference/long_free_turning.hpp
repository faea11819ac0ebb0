#pragma once
/// @file
/// Where a free body is after a very long time, in double-doubles: the truth for times that no
/// solver of steps can be asked for.
///
/// ω in the body comes back to itself after a period T, and then the body has turned by some angle
/// about L, the same in each period. So with one period by the Taylor series of order 36,
///
///     q(N T + s) = (q(T) q(0)⁻¹)ᴺ q(s)
///
/// The closed forms only say where to look for T: whether it is one, ω(T) = ω(0) shows.

#include <algorithm>
#include <cmath>
#include <vector>

#include "reference/double_double_motion.hpp"
#include "tumble/elliptic/integrals.hpp"

namespace tumble::reference {

/// The turning of a free body with three different moments that wobbles.
class LongFreeTurning {
 public:
  /// @param start with J ascending and no force
  explicit LongFreeTurning(const Turning& start) : start_(start) {
    DoubleDoubleTurning motion(start);
    const State begin = motion.now();
    const double guess = guessed_period(start);
    motion.at(guess);
    const double late = lateness(motion, begin);
    motion.shift(-late);
    period_ = simd::DoubleDouble(guess) - simd::DoubleDouble(late);
    const double left = lateness(motion, begin);
    motion.shift(-left);
    period_ -= simd::DoubleDouble(left);
    for (int i = 0; i < 3; ++i)
      defect_ = std::max(defect_, std::abs(double(motion.now()[i] - begin[i])));
    turn_ = product(quaternion(motion.now()), conjugate(quaternion(begin)));
    turn_ = scaled(turn_, simd::DoubleDouble(1) / norm_squared(quaternion(begin)));
  }

  double period() const { return double(period_); }  ///< of ω [s]
  double defect() const { return defect_; }  ///< by how much ω misses itself after it [rad/s]

  /// When the body's spin about the middle axis changes its sense, up to a time [s]: first near
  /// that which is given, then each half period.
  std::vector<double> flips(double first, double until) const {
    DoubleDoubleTurning motion(start_);
    motion.at(first);
    simd::DoubleDouble begin = first;
    for (int i = 0; i < 4; ++i) {
      const double late = double(motion.now()[1] / motion.rates()[1]);
      motion.shift(-late);
      begin += -late;
    }
    std::vector<double> times;
    for (double half = 0;; ++half) {
      const auto t = double(begin + period_ * (half / 2));
      if (t > until) return times;
      times.push_back(t);
    }
  }

  /// The state at time t ≥ 0 [s].
  TurningEnd at(double t) const {
    const double periods = std::floor(t / period());
    const simd::DoubleDouble rest = simd::DoubleDouble(t) - period_ * periods;
    DoubleDoubleTurning motion(start_);
    motion.at(rest.hi);
    motion.shift(rest.lo);
    const Q q = product(power(turn_, static_cast<long long>(periods)), quaternion(motion.now()));
    const auto number = [&](int i) { return double(motion.now()[i]); };
    return {Quat(double(q[0]), double(q[1]), double(q[2]), double(q[3])).normalized(),
            {number(0), number(1), number(2)}};
  }

 private:
  using State = DoubleDoubleTurning::State;
  using Q = Eigen::Matrix<simd::DoubleDouble, 4, 1>;  // w, x, y, z

  static double guessed_period(const Turning& start) {
    const PrincipalAxes axes{start.J, Mat3::Identity()};
    const auto polhode = elliptic::polhode_of(axes, start.q, start.L);
    require(polhode.has_value(), "the body does not wobble");
    return std::abs(4 * elliptic::complete_elliptic_k(std::sqrt(polhode->modulus.kc2)) /
                    polhode->lambda);
  }

  /// How long ago ω was what it was at the beginning, for a short time [s].
  static double lateness(DoubleDoubleTurning& motion, const State& begin) {
    const State rates = motion.rates();
    simd::DoubleDouble way = 0, square = 0;
    for (int i = 0; i < 3; ++i) {
      way += (motion.now()[i] - begin[i]) * rates[i];
      square += rates[i] * rates[i];
    }
    return double(way / square);
  }

  static Q quaternion(const State& s) { return {s[6], s[7], s[8], s[9]}; }
  static Q conjugate(Q q) {
    for (int i = 1; i < 4; ++i) q[i] = -q[i];
    return q;
  }
  static Q scaled(const Q& q, const simd::DoubleDouble& s) {
    return {q[0] * s, q[1] * s, q[2] * s, q[3] * s};
  }
  static simd::DoubleDouble norm_squared(const Q& q) {
    return q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
  }
  static Q product(const Q& a, const Q& b) {
    Q c;
    c[0] = a[0] * b[0];
    for (int i = 1; i < 4; ++i) {
      const int j = i % 3 + 1, k = j % 3 + 1;  // i, j, k follow each other in a circle
      c[0] -= a[i] * b[i];
      c[i] = a[0] * b[i] + a[i] * b[0] + a[j] * b[k] - a[k] * b[j];
    }
    return c;
  }
  static Q power(Q base, long long n) {
    Q result{1, 0, 0, 0};
    for (; n > 0; n /= 2) {
      if (n % 2) result = product(result, base);
      base = product(base, base);
    }
    return result;
  }

  Turning start_;
  simd::DoubleDouble period_ = 0;
  double defect_ = 0;
  Q turn_ = {1, 0, 0, 0};
};

}  // namespace tumble::reference
