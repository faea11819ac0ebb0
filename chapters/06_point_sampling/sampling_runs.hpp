#pragma once
/// @file
/// Single runs of sampling the mug, for a figure: without what checks a mesh.

#include <cmath>
#include <vector>

#include "placed_mug.hpp"
#include "point_sets.hpp"
#include "tumble/mass/mirtich/volume_integrals.hpp"
#include "tumble/mass/point_sampling.hpp"
#include "tumble/mass/solids/placed.hpp"
#include "tumble/mesh/reference_point.hpp"
#include "tumble/mesh/windings.hpp"

namespace point_sampling_chapter {

/// How many points there are, as powers of 2, and in how many placements.
inline constexpr int fewest = 8, most = 14, all_placements = 16, sets = 4;

/// So many points of a set, thrown at the mug in one placement.
struct Run {
  int set, k, placement;

  int number() const { return 1 << k; }
  Seed seed() const { return static_cast<Seed>(placement); }
};

inline const std::vector<Placement>& places() {
  static const std::vector<Placement> list = placements(all_placements);
  return list;
}
inline const Placement& place_of(const Run& run) {
  return places()[static_cast<std::size_t>(run.placement - 1)];
}

inline const MassProperties& truth_of_the_mug() {
  static const Vec3 middle = tumble::detail::reference_point(mug());
  static const MassProperties exact =
      mass_properties(mirtich::volume_integrals(mug(), middle), middle, mug_density);
  return exact;
}

/// The mug as a solid. It is closed, so nothing has to be checked.
struct MugItself {
  static const tumble::detail::Windings& surface() {
    static const tumble::detail::Windings made(mug());
    return made;
  }
  static bool contains(const Vec3& p) { return surface().contains(p); }
  static Eigen::AlignedBox3d bounds() { return surface().bounds(); }
};

inline solids::Placed<MugItself> body_of(const Run& run) {
  return solids::placed(MugItself{}, place_of(run).R, place_of(run).x);
}

/// What a run finds, computed once.
inline const MassProperties& found(const Run& run) {
  static std::vector<MassProperties> known(sets * (most + 1) * all_placements, MassProperties{});
  const int index = (run.set * (most + 1) + run.k) * all_placements + run.placement - 1;
  MassProperties& here = known[static_cast<std::size_t>(index)];
  if (!(here.mass > 0))
    here =
        with_points(run.set, run.number(), run.seed(), [&](const auto& points) -> MassProperties {
          return sampling::sample_mass_properties(body_of(run), mug_density, points);
        });
  return here;
}

inline double error_of(const Run& run) {
  return inertia_error(found(run).inertia,
                       rotate_inertia(place_of(run).R, truth_of_the_mug().inertia));
}

/// The geometric mean over all placements.
inline double typical_error(const Run& run) {
  double sum = 0;
  for (int i = 1; i <= all_placements; ++i) sum += std::log(error_of({run.set, run.k, i}));
  return std::exp(sum / all_placements);
}

}  // namespace point_sampling_chapter
