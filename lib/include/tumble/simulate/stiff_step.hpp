#pragma once
/// @file
/// What is inside a step of Radau5's, whose ends are known.

#include <stdexcept>

#include "tumble/core/require.hpp"
#include "tumble/core/rounding.hpp"
#include "tumble/ode/radau5.hpp"
#include "tumble/simulate/motion_tolerance.hpp"

namespace tumble::detail {

/// The motion at a moment of it, by steps to the same tolerance: one, but where Newton's method
/// needs shorter ones.
/// @param begin, y of the step
/// @param s     the moment
/// @throws std::runtime_error if no step is short enough, as where f is not finite
template <class F, class Numbers>
Numbers inside_stiff_step(const F& f, double begin, Numbers y, double s,
                          const MotionTolerance<Numbers>& tolerance) {
  Radau5::Stepper<Numbers, MotionTolerance<Numbers>> stepper(tolerance, f(begin, y));
  double h = s - begin;
  while (begin != s) {
    const double next = h < s - begin ? begin + h : s;
    const runge_kutta::Attempt<Numbers> attempt = stepper.attempt(f, begin, y, next - begin);
    if (attempt.accepted()) {
      begin = next;
      y = attempt.y;
    } else if (next - begin <= 16 * unit_roundoff * s) {
      throw_error<std::runtime_error>("trajectory: no step is short enough, ", begin,
                                      " s after the start: the forces have no values there");
    }
    h = attempt.next_h;
  }
  return y;
}

/// What f is inside, on the state at the step's start, less the polynomial through what it is there
/// at the moments at which the method has looked.
/// @param begin, y, h of the step
/// @param theta the moment, a part of the step
template <class F, class Numbers>
Numbers unexpected(const F& f, double begin, const Numbers& y, double h, double theta) {
  const auto c = Radau5Coefficients<double>::c();
  const double nodes[] = {0, c[0], c[1], c[2]};
  Numbers rest = f(begin + theta * h, y);
  for (const double node : nodes) {
    double weight = 1;
    for (const double other : nodes)
      if (other != node) weight *= (theta - other) / (node - other);
    rest -= weight * f(begin + node * h, y);
  }
  return rest;
}

}  // namespace tumble::detail
