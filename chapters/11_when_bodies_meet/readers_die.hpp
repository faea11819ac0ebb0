#pragma once
/// @file
/// The throw of a die by the reader's own functions (11.2 to 11.5), which know no friction.

#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "11_when_bodies_meet/thrown_die.hpp"
#include "support/scene_for_reader.hpp"

namespace contact_chapter {

constexpr int readers_impacts = 2000;

/// What tests/judge/page/student/figure_die.cpp takes.
/// @param scene the die over the floor; friction is left out
inline std::vector<double> question_of_die(const contact::ContactScene& scene, double until) {
  constexpr double tolerance = 1e-8, high = 1e-4;  // [m], too low to see
  const contact::ContactBody& die = scene.body(0);
  const double hop = std::sqrt(2 * die_gravity * high);
  std::vector<double> numbers{die.body.mass(), die_edge, die_gravity, scene.e, tolerance, hop};
  const PackedState<double> start = pack(die.start);
  numbers.insert(numbers.end(), start.begin(), start.end());
  numbers.insert(numbers.end(), {until, double(readers_impacts)});
  return numbers;
}

/// What comes back, as a throw. Where it hops on and on, or is no motion over the table, it ends
/// with the last impact that makes sense.
inline Throw readers_die(const contact::ContactScene& scene, double until,
                         std::span<const double> answer) {
  constexpr std::size_t size = 14;
  constexpr double through = 1e-7;  // [m], as if there were no table
  Throw thrown;
  contact::ContactRun& run = thrown.run;
  run.flights = {{{0, scene.body(0).start, -1}}};
  std::vector<contact::FlightStart>& legs = run.flights[0];
  bool whole = answer.size() < size * readers_impacts;
  for (std::size_t i = 0; i + size <= answer.size(); i += size) {
    const double t = answer[i];
    whole = whole && t >= legs.back().t && t <= until;
    if (!(t >= legs.back().t && t <= until)) break;
    legs.push_back({t, support::states_from_reader(answer.subspan(i + 1, size - 1)).front(), -1});
    run.impacts.push_back({});
    run.impacts.back().t = t;
  }
  run.rest_since = {std::numeric_limits<double>::infinity()};
  run.t = until;
  if (whole && lowest_corner(thrown.at(until)) > -through) return thrown;
  run.t = legs.back().t;
  run.ending = contact::Ending::too_many_events;
  return thrown;
}

}  // namespace contact_chapter
