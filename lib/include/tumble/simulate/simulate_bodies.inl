#pragma once

#include "tumble/simulate/simulate_bodies.hpp"

#include <span>

#include "tumble/body/forces_between.hpp"
#include "tumble/core/compiled.hpp"

namespace tumble::detail {

TUMBLE_BODY SimulationReport report_of(const std::vector<Trajectory>& bodies) {
  SimulationReport all = bodies.front().report();
  for (const Trajectory& body : std::span(bodies).subspan(1)) add_report(all, body.report());
  return all;
}

TUMBLE_BODY std::vector<RigidBodyState<>> valid_starts(
    const std::vector<RigidBodyState<>>& starts) {
  std::vector<RigidBodyState<>> from;
  for (std::size_t i = 0; i < starts.size(); ++i)
    require_at([&] { from.push_back(valid_start(starts[i])); }, "body ", i, ": ");
  return from;
}

}  // namespace tumble::detail
