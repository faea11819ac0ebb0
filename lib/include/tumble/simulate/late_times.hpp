#pragma once
/// @file
/// What the rounding of late times does to forces that depend on the time.

#include <algorithm>
#include <cmath>
#include <vector>

#include "tumble/core/rounding.hpp"
#include "tumble/simulate/motion_tolerance.hpp"
#include "tumble/simulate/simulation_task.hpp"

namespace tumble::detail {

/// By how much forces jump where a late time is rounded, on average and as a part of the largest
/// that they are: steps that are to see less than that would be as short as the times lie apart.
/// @param y          the motion at its start
/// @param begin, end of a piece of the span [s after t0]
template <class Rhs>
double jumps_by_rounding(const Rhs& rhs, const typename Rhs::Numbers& y, const SimulationTask& task,
                         double begin, double end) {
  using Numbers = typename Rhs::Numbers;
  constexpr double little = 1e-9;
  constexpr int looks = 64;
  const double late = 4 * unit_roundoff * std::max(std::abs(task.t0), std::abs(task.t1));
  if (late <= little * (end - begin)) return 0;
  const double span = task.t1 - task.t0;
  const auto rate = [&](double t) { return Numbers(span * rhs(t, y)); };
  auto sizes = rhs.least_squares(span);
  auto jumps = SquaredSizes<Numbers>::Zero(sizes.size()).eval();
  for (int i = 0; i < looks; ++i) {
    const double t = task.t0 + begin + (i + 0.618) / looks * (end - begin);
    const auto here = rate(t);
    sizes = sizes.cwiseMax(squared_sizes(here));
    jumps += squared_sizes(Numbers(rate(t + late) - here)) / looks;
  }
  const double part = std::sqrt(jumps.cwiseQuotient(sizes).maxCoeff());
  return part > 0 ? part : 0;
}

/// The largest of all pieces between breaks: a short pulse may be one.
template <class Rhs>
double jumps_by_rounding(const Rhs& rhs, const typename Rhs::Numbers& y, const SimulationTask& task,
                         std::vector<double> breaks) {
  breaks.push_back(task.t1 - task.t0);
  double most = 0, begin = 0;
  for (const double end : breaks) {
    most = std::max(most, jumps_by_rounding(rhs, y, task, begin, end));
    begin = end;
  }
  return most;
}

}  // namespace tumble::detail
