#pragma once

#include "tumble/simulate/held_error.hpp"

#include <algorithm>
#include <cmath>

#include "tumble/core/compiled.hpp"
#include "tumble/core/largest.hpp"
#include "tumble/core/rounding.hpp"
#include "tumble/quaternion/exp_log.hpp"
#include "tumble/rotation/skew.hpp"
#include "tumble/simulate/motion_tolerance.hpp"

namespace tumble::detail {

/// By how much a matrix makes vectors longer, at most. Source: Golub & Van Loan, "Matrix
/// Computations", 4th ed. (2013), corollary 2.3.2.
inline double largest_stretch(const Mat3& M) {
  const Mat3 sizes = M.cwiseAbs();
  return std::sqrt(sizes.rowwise().sum().maxCoeff() * sizes.colwise().sum().maxCoeff());
}

TUMBLE_BODY HeldError::HeldError(const HeldBody& held, const Trajectory& turning)
    : held_(held),
      turning_(turning.report()),
      span_(turning.t1() - turning.t0()),
      from_origin_(turning.at(turning.t0()).x.norm()) {
  const MotionScale point = least_sizes(held.about_point(), std::abs(span_));
  least_ = {point.length, point.momentum,
            least_sizes(held.body(), std::abs(span_)).angular_momentum};
  least_L_point_ = point.angular_momentum;
  constexpr int moments = 16;
  for (int i = 0; i < moments; ++i) {
    const double place = i * 0.6180339887498949;  // in step with no swing
    const double theta = place - std::floor(place);
    const RigidBodyState<> turned = turning.at((1 - theta) * turning.t0() + theta * turning.t1());
    const RigidBodyState<>& state = states_.emplace_back(held.state_of(turned));
    sizes_ = {largest({sizes_.x, state.x.norm()}), largest({sizes_.P, state.P.norm()}),
              largest({sizes_.L, state.L.norm()})};
    L_point_ = largest({L_point_, turned.L.norm()});
    omega_ = largest({omega_, derived(held.about_point(), turned).omega.norm()});
  }
}

TUMBLE_BODY HeldSizes HeldError::sizes_that_matter() const {
  return {largest({sizes_.x, least_.x}), largest({sizes_.P, least_.P}),
          largest({sizes_.L, least_.L})};
}

TUMBLE_BODY HeldSizes HeldError::own_sizes() const {
  const auto own = [](double size, double least) {
    return size < least_motion * least ? least : size;
  };
  return {own(sizes_.x, least_.x), own(sizes_.P, least_.P), own(sizes_.L, least_.L)};
}

TUMBLE_BODY double HeldError::part(double angle, double L, const HeldSizes& sizes) const {
  const Mat3 &I = held_.body().I_body(), &I_inv = held_.about_point().I_body_inv();
  const double m = held_.body().mass(), d = held_.held().norm();
  constexpr double rounding = 4 * unit_roundoff;
  // The error of L, and that of ω which a tensor in turned axes makes about all of them.
  const double l = L + rounding * L_point_;
  const double omega = I_inv.isDiagonal(0) ? 0 : rounding * I_inv.norm() * L_point_;
  const double x = d * angle + rounding * (from_origin_ + d);
  const double P = m * (largest_stretch(rotation::skew(held_.held()) * I_inv) * l +
                        d * (omega + rounding * omega_));
  const double of_L = largest_stretch(I * I_inv) * l + I.norm() * omega;
  return largest({angle, x / sizes.x, P / sizes.P, of_L / sizes.L});
}

TUMBLE_BODY double HeldError::difference(const HeldError& other, const HeldSizes& sizes) const {
  double most = 0;
  for (std::size_t i = 0; i < states_.size(); ++i) {
    const RigidBodyState<>&a = states_[i], &b = other.states_[i];
    most = largest({most, angle_between(a.q, b.q), (a.x - b.x).norm() / sizes.x,
                    (a.P - b.P).norm() / sizes.P, (a.L - b.L).norm() / sizes.L});
  }
  return most;
}

TUMBLE_BODY SimulationReport HeldError::report(double tolerance) const {
  SimulationReport report = turning_;
  report.tolerance = tolerance;
  if (span_ == 0) return report;
  const double angle = turning_.error_estimate, small = turning_.error_of_small_motion;
  // A symmetric top's closed form errs in its phases: what it gives is where such a top is a little
  // earlier or later, so P is as wrong as q. (Of 5900 random tops none was wrong by more than 0.2
  // of that, but for rounding.)
  const bool errs_in_phases = turning_.runs == 0 && turning_.model == Model::symmetric_top;
  const double L = errs_in_phases ? 0 : angle * largest({L_point_, least_L_point_});
  report.error_estimate = part(angle, L, sizes_that_matter());
  const double own = part(angle, small > 0 && !errs_in_phases ? small * L_point_ : L, own_sizes());
  report.error_of_small_motion = own > report.error_estimate ? own : 0;
  return report;
}

TUMBLE_BODY SimulationReport HeldError::report(double tolerance, const HeldError& rougher) const {
  SimulationReport report = this->report(tolerance);
  // Two closed forms have their errors in common.
  if (turning_.runs == 0) return report;
  constexpr double doubt = 10, rounding = 8 * unit_roundoff;
  const double share =
      rougher.turning_.runs == 0
          ? 1
          : std::min(1.0, doubt * turning_.error_estimate / rougher.turning_.error_estimate);
  const auto shown = [&](const HeldSizes& sizes) {
    return largest({turning_.error_estimate, share * difference(rougher, sizes) +
                                                 part(rounding, rounding * L_point_, sizes)});
  };
  report.error_estimate = std::min(report.error_estimate, shown(sizes_that_matter()));
  const double own = std::min(report.error_of_small_motion, shown(own_sizes()));
  report.error_of_small_motion = own > report.error_estimate ? own : 0;
  return report;
}

}  // namespace tumble::detail
