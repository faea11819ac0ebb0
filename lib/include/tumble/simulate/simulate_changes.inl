#pragma once

#include "tumble/simulate/simulate_changes.hpp"

#include <cmath>

#include "tumble/core/compiled.hpp"

namespace tumble::detail {

TUMBLE_BODY void require_forwards(const SimulationTask& task) {
  require_valid_task(task);
  require(task.t1 >= task.t0, "simulate_changes: t1 = ", task.t1, " is before t0 = ", task.t0,
          "; what an event has changed can't be undone");
}

}  // namespace tumble::detail
