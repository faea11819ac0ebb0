#pragma once

#include "tumble/core/compiled.hpp"
#include "tumble/simulate/any_forces.hpp"

namespace tumble::detail {

TUMBLE_BODY std::vector<double> breaks_within(const SimulationTask& task) {
  std::vector<double> inside;
  for (const double t : task.breaks)
    if (t > task.t0 && t < task.t1) inside.push_back(t - task.t0);
  std::sort(inside.begin(), inside.end());
  return inside;
}

TUMBLE_BODY void require_longest_step(const SimulationTask& task) {
  const double span = task.t1 - task.t0, steps = span / task.longest_step;
  require(steps <= most_steps, "simulate: longest_step = ", task.longest_step, " s needs at least ",
          steps, " steps from t0 = ", task.t0, " to t1 = ", task.t1, ", and at most ", most_steps,
          " are taken: give longest_step = ", span / most_steps,
          " s or more; or say in breaks when forces begin, end or jump");
}

TUMBLE_BODY double looks_after(int surprises) {
  constexpr double at_first = 2048, closer = 8, most = 0x1p20;
  return std::min(most, at_first * std::pow(closer, surprises));
}

}  // namespace tumble::detail
