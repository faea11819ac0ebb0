#pragma once

#include "tumble/core/compiled.hpp"
#include "tumble/core/largest.hpp"
#include "tumble/simulate/trajectory.hpp"

namespace tumble::detail {

TUMBLE_BODY void add_report(SimulationReport& all, const SimulationReport& one) {
  if (one.method != all.method) all.method = "each part by itself";
  if (one.why != all.why) all.why = "each part for its own reasons";
  all.model = std::max(all.model, one.model);
  all.error_estimate = largest({all.error_estimate, one.error_estimate});
  all.error_of_small_motion = largest({all.error_of_small_motion, one.error_of_small_motion});
  all.runs += one.runs;
  all.steps += one.steps;
  all.rejected += one.rejected;
  all.evaluations += one.evaluations;
}

}  // namespace tumble::detail
