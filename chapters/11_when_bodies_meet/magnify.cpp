/// @file
/// How each bounce magnifies a small difference.

#include "11_when_bodies_meet/thrown_die.hpp"
#include "common.hpp"
#include "parts.hpp"

namespace contact_chapter {

namespace {

constexpr double higher = 1e-9;  // [m]
constexpr int bounces = 12;

/// A die on a smooth table.
contact::ContactRun smooth_throw(double higher_by) {
  contact::ContactScene scene = scene_of_die({0.5, 0, 0.4}, {10, 6 * pi, 4}, 0.6, 0);
  scene.bodies[0].start.x.z() += higher_by;
  const contact::ContactSettings settings{.until = 2, .tolerance = 1e-13, .most_impacts = bounces};
  return contact::detail::ContactSimulation<OneBodyEvents>(scene, settings).run();
}

}  // namespace

Table magnify_table() {
  Table table({"impact", "at [s]", "a nanometre higher: off by [s]", "energy left"});
  const contact::ContactRun run = smooth_throw(0), other = smooth_throw(higher);
  double energy = run.energy.start;
  for (std::size_t i = 0; i < std::size_t{bounces}; ++i) {
    energy += run.impacts[i].energy;
    table.add({std::to_string(i + 1), rounded(run.impacts[i].t, 6),
               support::error_number(other.impacts[i].t - run.impacts[i].t),
               number(100 * energy / run.energy.start, 3) + " %"});
  }
  return table;
}

}  // namespace contact_chapter
