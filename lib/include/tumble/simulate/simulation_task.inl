#pragma once

#include "tumble/simulate/simulation_task.hpp"

#include <cmath>

#include "tumble/core/compiled.hpp"
#include "tumble/core/require.hpp"
#include "tumble/core/time_span.hpp"

namespace tumble::detail {

TUMBLE_BODY void require_valid_task(const SimulationTask& task) {
  require(std::isfinite(task.t0) && std::isfinite(task.t1), "simulate: from t0 = ", task.t0,
          " to t1 = ", task.t1, " is not a span of time");
  require(is_time(task.t1 - task.t0), "simulate: from t0 = ", task.t0, " to t1 = ", task.t1,
          " are ", task.t1 - task.t0, " s, a span that doubles have no digits for");
  require(task.tolerance > 0 && std::isfinite(task.tolerance), "simulate: the tolerance ",
          task.tolerance, " is not positive and finite");
  require(task.longest_step > 0, "simulate: longest_step = ", task.longest_step,
          " s is not positive");
  for (const double t : task.breaks)
    require(std::isfinite(t), "simulate: a break at t = ", t, " is not a time");
}

}  // namespace tumble::detail
