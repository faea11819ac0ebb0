#pragma once
/// @file
/// The error of each way to sample a mug.

#include "mug_methods.hpp"

namespace point_sampling_chapter {

/// The typical error of the inertia for each of the method's numbers: the geometric mean over
/// placements of the mug.
inline std::vector<double> typical_errors(const Method& method) {
  constexpr int count = 16;
  std::vector<double> errors;
  for (const int n : method.numbers) {
    double sum = 0;
    Seed seed = 0;
    for (const Placement& at : placements(count)) {
      const Mat3 truth = rotate_inertia(at.R, mug_truth().inertia);
      sum += std::log(inertia_error(method.find(at, n, ++seed).inertia, truth));
    }
    errors.push_back(std::exp(sum / count));
  }
  return errors;
}

/// Of all methods, computed once.
inline const std::vector<std::vector<double>>& all_errors() {
  static const std::vector<std::vector<double>> errors = [] {
    std::vector<std::vector<double>> list;
    for (const Method& method : methods()) list.push_back(typical_errors(method));
    return list;
  }();
  return errors;
}

}  // namespace point_sampling_chapter
