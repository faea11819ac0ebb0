#pragma once
/// @file
/// The ways to sample a mug, and the error of each.

#include <cstdint>
#include <functional>

#include "common.hpp"

namespace point_sampling_chapter {

using Seed = std::uint64_t;

/// A way to find mass properties of the mug, wherever it is, from n points or columns.
struct Method {
  std::string name, theory;
  std::function<MassProperties(const Placement& at, int n, Seed seed)> find;
  std::vector<int> numbers;  ///< n
};

inline int per_axis(int n) { return static_cast<int>(std::lround(std::cbrt(n))); }

template <class MakePoints>
sampling::SampledMassProperties sampled_mug(const Placement& at, MakePoints&& points) {
  return sampling::sample_mass_properties(solids::placed(mug_solid(), at.R, at.x), mug_density,
                                          points);
}

inline const std::vector<Method>& methods() {
  static const std::vector<int> points{1000, 4096, 15625, 64000};
  static const std::vector<int> columns{1000, 4000, 16000, 64000};
  using At = const Placement&;
  static const std::vector<Method> list{
      {"random points", "−1/2",
       [](At at, int n, Seed seed) { return sampled_mug(at, sampling::RandomPoints(n, seed)); },
       points},
      {"grid points", "−2/3, unsteady",
       [](At at, int n, Seed) { return sampled_mug(at, sampling::GridPoints(per_axis(n))); },
       points},
      {"stratified points", "−2/3",
       [](At at, int n, Seed seed) {
         return sampled_mug(at, sampling::StratifiedPoints(per_axis(n), seed));
       },
       points},
      {"R3 points", "about −2/3",
       [](At at, int n, Seed) { return sampled_mug(at, sampling::R3Points(n)); }, points},
      {"jittered columns", "−1",
       [](At at, int n, Seed seed) {
         return sampling::jittered_column_mass_properties(placed_mesh(mug(), at), mug_density, n,
                                                          seed);
       },
       columns},
      {"grid columns", "−1 to −3/2",
       [](At at, int n, Seed) {
         return sampling::column_mass_properties(placed_mesh(mug(), at), mug_density, n);
       },
       columns}};
  return list;
}

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
