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

}  // namespace tumble::detail
