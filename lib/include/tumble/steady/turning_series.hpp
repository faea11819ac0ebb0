#pragma once
/// @file
/// The turning of a body under forces that are constant in the world, as a power series in time.
///
/// In principal axes the equations are products and sums only, so that each coefficient follows
/// from those before it:
///
///     J ω̇ = J ω × ω + Σ p × u − k ω,   u̇ = u × ω  (u = Rᵀ b),   q̇ = ½ q ⟨0, ω⟩
///
/// A product of two series is a sum over pairs of coefficients; the three or four components of a
/// vector lie side by side and go through it together.
///
/// The coefficient of tᵏ has the unit 1/sᵏ: if a turn takes a day, or a nanosecond, it is no double
/// any more. So time counts in powers of 2 s in which the body turns by about one radian.
///
/// Source: Jorba & Zou, "A software package for the numerical integration of ODEs by means of
/// high-order Taylor methods", Experimental Mathematics 14 (2005), §2 and §3.

#include <algorithm>
#include <cmath>
#include <vector>

#include "tumble/simd/instruction_set.hpp"
#include "tumble/simd/pair.hpp"
#include "tumble/steady/steady_torque.hpp"
#include "tumble/steady/turning_lanes.hpp"
#include "tumble/steady/turning_step.hpp"
#include "tumble/steady/turning_term.hpp"

namespace tumble::detail {

/// The series of a body's turning about one moment.
/// @tparam rank how many directions the torque has, 0 … 3
template <int rank>
class TurningSeries {
 public:
  static constexpr int max_order = 32;                         ///< even, as all orders are
  static constexpr std::size_t slots = std::size_t{rank} + 1;  // 0 would be no array

  /// @param torque with this rank
  /// @param order  even, 2 … max_order
  TurningSeries(const steady::SteadyTorque& torque, int order)
      : order_(order),
        instructions_(simd::best_instruction_set()),
        rate_(torque.drag().cwiseAbs().maxCoeff()),
        drag_per_second_(four_lanes(torque.drag())) {
    const Vec3& J = torque.axes().moments;
    euler_ = four_lanes({(J[1] - J[2]) / J[0], (J[2] - J[0]) / J[1], (J[0] - J[1]) / J[2]});
    for (int r = 0; r < rank; ++r) {
      const Vec3& a = torque.arm(r);
      directions_[r] = torque.direction(r);
      const Vec3 plus(a[1] / J[0], a[2] / J[1], a[0] / J[2]);
      const Vec3 minus(a[2] / J[0], a[0] / J[1], a[1] / J[2]);
      plus_per_second_[r] = four_lanes(plus);
      minus_per_second_[r] = four_lanes(minus);
      rate_ = std::max(
          {rate_, std::sqrt(plus.cwiseAbs().maxCoeff()), std::sqrt(minus.cwiseAbs().maxCoeff())});
    }
  }

  int order() const { return order_; }

  /// Expands about a state; what was there before is forgotten.
  void expand(const steady::TurningState& state) {
    const Quat& q = state.q;
    count_time_by(std::max(rate_, state.omega.cwiseAbs().maxCoeff()));
    w_[0] = arranged_omega(unit_ * four_lanes(state.omega));
    q_[0] = arranged_orientation(FourDoubles{q.w(), q.x(), q.y(), q.z()});
    const double scale = 1 / q.squaredNorm();
    for (int r = 0; r < rank; ++r)
      u_[r][0] = arranged_direction(four_lanes(scale * (q.conjugate() * directions_[r])));
    dispatch(instructions_, Expansion{*this});
  }

  /// What the series counts time by since it was expanded [s].
  double unit() const { return unit_; }

  /// The longest step [s] whose last terms stay below the tolerance, see turning_step().
  double step(double tolerance) const { return unit_ * turning_step(q_, w_, order_, tolerance); }

  /// The state so many seconds after the one expanded about.
  steady::TurningState at(double seconds) const {
    const double h = seconds / unit_;
    FourDoubles q = q_[order_].q, w = w_[order_].xyz;
    for (int k = order_ - 1; k >= 0; --k) {
      q = q * h + q_[k].q;
      w = w * h + w_[k].xyz;
    }
    return {Quat(q[0], q[1], q[2], q[3]), Vec3(w[0], w[1], w[2]) / unit_};
  }

  /// Appends the series' terms, by its unit of time, to others.
  void keep(std::vector<TurningTerm>& terms) const {
    for (int k = 0; k <= order_; ++k) terms.push_back({q_[k].q, w_[k].xyz});
  }

 private:
  struct Expansion {
    TurningSeries& series;

    template <class P, simd::Fma fma>
    TUMBLE_INLINE void run() const {
      series.template expand_with<fma>();
    }
  };

  using Omega = TurningOmega;
  using Orientation = TurningOrientation;
  using Direction = TurningDirection;

  /// @param rate at which something changes [1/s], or 0
  void count_time_by(double rate) {
    unit_ = rate > 0 ? std::ldexp(1., -std::ilogb(rate)) : 1;
    drag_ = unit_ * drag_per_second_;
    for (int r = 0; r < rank; ++r) {
      plus_[r] = unit_ * (unit_ * plus_per_second_[r]);
      minus_[r] = unit_ * (unit_ * minus_per_second_[r]);
    }
  }

  /// Sums of products that make one coefficient.
  struct Sums {
    FourDoubles w{}, q{}, qz{};
    FourDoubles plus[slots]{}, minus[slots]{};  // of u × ω
  };

  /// Adds the products of coefficient j with one of ω.
  template <simd::Fma fma>
  TUMBLE_INLINE void add(Sums& sums, int j, const Omega& w) const {
    sums.w = multiply_add<fma>(w_[j].yzx, w.zxy, sums.w);
    sums.q = multiply_add<fma>(q_[j].i, w.x, sums.q);
    sums.qz = multiply_add<fma>(q_[j].k, w.z, sums.qz);
    sums.q = multiply_add<fma>(q_[j].j, w.y, sums.q);
    for (int r = 0; r < rank; ++r) {
      sums.plus[r] = multiply_add<fma>(u_[r][j].yzx, w.zxy, sums.plus[r]);
      sums.minus[r] = multiply_add<fma>(u_[r][j].zxy, w.yzx, sums.minus[r]);
    }
  }

  /// Two coefficients at a time: what is read for one serves the other.
  template <simd::Fma fma>
  TUMBLE_INLINE void expand_with() {
    for (int k = 0; k < order_; k += 2) {
      Sums first{}, second{};
      Omega next{};
      for (int j = 0; j <= k; ++j) {
        // Number by number: gcc copies a whole one by way of memory.
        const Omega& stored = w_[k - j];
        const Omega w{stored.xyz, stored.yzx, stored.zxy, stored.x, stored.y, stored.z};
        add<fma>(first, j, w);
        add<fma>(second, j, next);
        next.yzx = w.yzx;
        next.zxy = w.zxy;
        next.x = w.x;
        next.y = w.y;
        next.z = w.z;
      }
      finish(k, first);
      add<fma>(second, 0, w_[k + 1]);
      add<fma>(second, k + 1, w_[0]);
      finish(k + 1, second);
    }
  }

  /// Coefficient k + 1 from the products of those up to k.
  TUMBLE_INLINE void finish(int k, const Sums& sums) {
    const double share = 1.0 / (k + 1);
    FourDoubles w = euler_ * sums.w - drag_ * w_[k].xyz;
    for (int r = 0; r < rank; ++r) {
      w += plus_[r] * u_[r][k].zxy - minus_[r] * u_[r][k].yzx;
      u_[r][k + 1] = arranged_direction(share * (sums.plus[r] - sums.minus[r]));
    }
    w_[k + 1] = arranged_omega(share * w);
    q_[k + 1] = arranged_orientation((share / 2) * (sums.q + sums.qz));
  }

  int order_;
  simd::InstructionSet instructions_;
  double rate_, unit_ = 1;
  FourDoubles euler_, drag_per_second_, drag_{};
  Vec3 directions_[slots];
  FourDoubles plus_per_second_[slots], minus_per_second_[slots];  // the arms over J
  FourDoubles plus_[slots], minus_[slots];                        // the same by the unit of time
  Omega w_[max_order + 1];
  Orientation q_[max_order + 1];
  Direction u_[slots][max_order + 1];
};

}  // namespace tumble::detail
