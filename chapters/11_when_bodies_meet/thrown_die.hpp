#pragma once
/// @file
/// A die of plastic, from the hand to where it rests, and what it shows.

#include <algorithm>
#include <cmath>
#include <vector>

#include "11_when_bodies_meet/one_body_events.hpp"
#include "objects/die.hpp"

namespace contact_chapter {

using objects::die_edge;
constexpr double die_gravity = 9.81;  // [m/s²]

inline RigidBody<> the_die() { return objects::die(); }

/// Its energy above that of a die that lies still on the table [J].
inline double energy_of_die(const RigidBodyState<>& state) {
  const RigidBody<> body = the_die();
  return kinetic_energy(body, state) + body.mass() * die_gravity * (state.x.z() - die_edge / 2);
}

/// How high its lowest corner is.
inline double lowest_corner(const RigidBodyState<>& state) {
  return state.x.z() - die_edge / 2 * to_matrix(state.q).row(2).cwiseAbs().sum();
}

/// It leaves the hand over a table.
inline contact::ContactScene scene_of_die(const RigidBodyState<>& start, double e, double mu) {
  return {{{"die", the_die(), collide::Convex::box(Vec3::Constant(die_edge)), start}},
          {collide::HalfSpace{Vec3::Zero(), Vec3::UnitZ()}},
          Vec3(0, 0, -die_gravity),
          e,
          mu};
}

/// From the hand to where it rests.
struct Throw {
  RigidBody<> body = the_die();
  contact::ContactRun run;

  const std::vector<contact::FlightStart>& legs() const { return run.flights[0]; }
  /// When nothing more happens: it rests, or stands on an edge, and the library says that it can't
  /// tell how that goes on.
  double end() const { return std::min(run.rest_since[0], run.t); }

  SteadyFlight flight(const contact::FlightStart& leg) const {
    const Vec3 falls(0, 0, -die_gravity);
    return {body, leg.state, leg.on_wall < 0 ? falls : leg.acceleration, leg.t};
  }
  RigidBodyState<> at(double t) const {
    t = std::min(t, run.t);
    const auto next =
        std::upper_bound(legs().begin() + 1, legs().end(), t,
                         [](double time, const contact::FlightStart& leg) { return time < leg.t; });
    return flight(*(next - 1)).state(t);
  }
};

/// The pips of a face in units of a quarter of an edge, by their number.
inline std::vector<Eigen::Vector2d> pips(int number) {
  std::vector<Eigen::Vector2d> all;
  if (number % 2 == 1) all.emplace_back(0, 0);
  if (number >= 2) all.insert(all.end(), {{1, 1}, {-1, -1}});
  if (number >= 4) all.insert(all.end(), {{1, -1}, {-1, 1}});
  if (number == 6) all.insert(all.end(), {{1, 0}, {-1, 0}});
  return all;
}

/// Opposite faces add up to seven.
inline int number_on(int axis, double side) { return side > 0 ? axis + 1 : 6 - axis; }

/// The number on the face that looks up most.
inline int number_shown(const RigidBodyState<>& state) {
  const Vec3 up = to_matrix(state.q).row(2);
  int axis = 0;
  for (int i = 1; i < 3; ++i)
    if (std::abs(up[i]) > std::abs(up[axis])) axis = i;
  return number_on(axis, up[axis]);
}

}  // namespace contact_chapter
