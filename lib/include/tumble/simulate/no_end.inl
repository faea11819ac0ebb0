#pragma once

#include "tumble/simulate/no_end.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "tumble/core/compiled.hpp"
#include "tumble/core/require.hpp"

namespace tumble::detail {

TUMBLE_BODY std::string why_so_many(std::size_t breaks, const StepBudget& budget, double t0,
                                    double s, bool stiff) {
  constexpr double steps_a_break = 100, roundings_a_step = 1e4;
  const double steps = std::max<double>(budget.steps(), budget.predicted());
  const double rounding = rounding_at(std::abs(t0 + s));
  std::ostringstream why;
  if (steps < steps_a_break * static_cast<double>(breaks))
    why << "its forces begin, end or jump at " << breaks
        << " times, and each takes some steps; ask for a shorter time";
  else if (budget.pace() < roundings_a_step * rounding)
    why << "doubles near this time lie " << rounding
        << " s apart, and forces that depend on the time jump as often; count the time from a "
           "moment near t0";
  else if (stiff)
    why << "a force is so stiff that the steps are " << budget.pace()
        << " s long; give a smaller stiffness or damping, a larger tolerance, or a shorter time";
  else
    why << "the body turns or swings too often, or its forces switch to and fro, as dry friction "
           "does; ask for a shorter time";
  return why.str();
}

TUMBLE_BODY void require_moments(double jumps, double t) {
  constexpr double most = 0.2;
  if (jumps > most)
    throw_error<std::runtime_error>("simulate: doubles near t = ", t, " lie ", rounding_at(t),
                                    " s apart, and meanwhile the forces change by ", jumps,
                                    " of themselves; count the time from a moment near t0");
}

TUMBLE_BODY void require_range(double square, double t) {
  constexpr double most = 1e300;
  if (!(square < most))
    throw_error<std::runtime_error>(
        "simulate: the motion grows to 1e150 times what its start and the forces there make of "
        "it, at t = ",
        t, ": ask for a shorter time");
}

TUMBLE_BODY void require_finite(const RigidBodyState<>& end, double error, double t1) {
  if (!pack(end).allFinite() || !std::isfinite(error))
    throw_error<std::runtime_error>("simulate: the motion overflows a double before t = ", t1);
}

TUMBLE_BODY void require_finite(const std::vector<RigidBodyState<>>& ends, double error,
                                double t1) {
  for (const RigidBodyState<>& end : ends) require_finite(end, error, t1);
}

}  // namespace tumble::detail
