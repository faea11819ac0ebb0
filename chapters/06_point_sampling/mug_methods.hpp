#pragma once
/// @file
/// The ways to sample a mug.

#include <functional>

#include "common.hpp"
#include "point_sets.hpp"

namespace point_sampling_chapter {

/// A way to find mass properties of the mug, wherever it is, from n points or columns.
struct Method {
  std::string name, theory;
  std::function<MassProperties(const Placement& at, int n, Seed seed)> find;
  std::vector<int> numbers;  ///< n
};

template <class MakePoints>
sampling::SampledMassProperties sampled_mug(const Placement& at, MakePoints&& points) {
  return sampling::sample_mass_properties(solids::placed(mug_solid(), at.R, at.x), mug_density,
                                          points);
}

inline const std::vector<Method>& methods() {
  static const std::vector<int> points{1000, 4096, 15625, 64000};
  static const std::vector<int> columns{1000, 4000, 16000, 64000};
  using At = const Placement&;
  const auto by_points = [](int set) {
    return [set](At at, int n, Seed seed) {
      return with_points(set, n, seed, [&](const auto& those) -> MassProperties {
        return sampled_mug(at, those);
      });
    };
  };
  static const std::vector<Method> list{{"random points", "−1/2", by_points(0), points},
                                        {"grid points", "−2/3, unsteady", by_points(1), points},
                                        {"stratified points", "−2/3", by_points(2), points},
                                        {"R3 points", "about −2/3", by_points(3), points},
                                        {"jittered columns", "−1",
                                         [](At at, int n, Seed seed) {
                                           return sampling::jittered_column_mass_properties(
                                               placed_mesh(mug(), at), mug_density, n, seed);
                                         },
                                         columns},
                                        {"grid columns", "−1 to −3/2",
                                         [](At at, int n, Seed) {
                                           return sampling::column_mass_properties(
                                               placed_mesh(mug(), at), mug_density, n);
                                         },
                                         columns}};
  return list;
}

}  // namespace point_sampling_chapter
