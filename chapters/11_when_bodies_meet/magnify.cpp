/// @file
/// How each bounce magnifies a small difference.

#include "11_when_bodies_meet/thrown_die.hpp"
#include "common.hpp"
#include "parts.hpp"

namespace contact_chapter {

namespace {

constexpr double nanometre = 1e-9, micrometre = 1e-6;
constexpr int bounces = 12;

/// A die on a smooth table.
contact::ContactRun smooth_throw(double higher_by) {
  contact::ContactScene scene = scene_of_die(objects::thrown_die(), 0.6, 0);
  scene.bodies[0].start.x.z() += higher_by;
  const contact::ContactSettings settings{.until = 2, .tolerance = 1e-15, .max_impacts = bounces};
  return contact::detail::ContactSimulation<OneBodyEvents>(scene, settings).run();
}

}  // namespace

Table magnify_table() {
  Table table(
      {"impact", "at [s]", "1 nm higher: off by [s]", "1 µm higher: off by [s]", "energy left"});
  const contact::ContactRun run = smooth_throw(0), close = smooth_throw(nanometre),
                            far = smooth_throw(micrometre);
  const double at_start = energy_of_die(run.flights[0].front().state);
  double energy = at_start;
  for (std::size_t i = 0; i < std::size_t{bounces}; ++i) {
    const double t = run.impacts.at(i).t;
    energy += run.impacts[i].energy;
    table.add({std::to_string(i + 1), rounded(t, 5), error_number(close.impacts.at(i).t - t),
               error_number(far.impacts.at(i).t - t), number(100 * energy / at_start, 3) + " %"});
  }
  return table;
}

}  // namespace contact_chapter
