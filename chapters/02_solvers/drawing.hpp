#pragma once
/// @file
/// What an integration leaves for a drawing: places, times, steps.

#include <algorithm>
#include <vector>

#include "plane.hpp"
#include "problems.hpp"

namespace solvers_chapter {

/// The places after all the steps of an integration, and the lengths of the steps.
struct Track {
  Path places;
  std::vector<double> times, steps;

  void operator()(double t, const Vec4& y) {
    steps.push_back(t - (times.empty() ? 0 : times.back()));
    times.push_back(t);
    places.push_back(y.head<2>());
  }
  double shortest() const { return *std::min_element(steps.begin(), steps.end()); }
  double longest() const { return *std::max_element(steps.begin(), steps.end()); }
};

}  // namespace solvers_chapter
