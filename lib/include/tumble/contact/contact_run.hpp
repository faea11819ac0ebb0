#pragma once
/// @file
/// What a simulation of contacts takes and gives: settings, impacts, flights, who came to rest, and
/// an energy ledger.

#include <algorithm>
#include <cstdint>
#include <vector>

#include "tumble/contact/flight.hpp"
#include "tumble/contact/impact.hpp"
#include "tumble/contact/scene.hpp"

namespace tumble::contact {

/// @addtogroup contact
/// @{

/// How long, and how exactly.
struct ContactSettings {
  double until;              ///< from t = 0 on [s]
  double tolerance = 1e-11;  ///< at which distance bodies touch [m]
  /// Contact that lasts, and is neither rest nor a straight slide on a face, is a train of hops for
  /// a body that is no ball: so high, as a part of its reach.
  double hop = 1e-6;
  int max_impacts = 100000;  ///< after so many contacts the run ends, and says so
};

/// One impulse between two bodies, or between a body and a wall.
struct ImpactEvent {
  double t;       ///< [s]
  int body;       ///< whom the impulse acts on
  int other;      ///< the other body, or -1 for a wall
  int wall;       ///< the wall, or -1 for a body
  Vec3 point;     ///< where, in the world [m]
  Vec3 normal;    ///< unit, out of the other one
  Vec3 impulse;   ///< [N s]; the other one gets its negative
  double energy;  ///< gained [J]: never more than 0, but for rounding
  Slip slip;      ///< how friction went
  bool jammed;    ///< Painlevé's paradox: see ImpactResult
};

/// Why a simulation ended.
enum class Ending {
  time,             ///< at the time that was asked for
  all_at_rest,      ///< nothing moves any more
  lasting_contact,  ///< bodies stay in touch, and how they go on is not modelled
  too_many_events,  ///< the number of impacts that was allowed is reached
};

/// A flight from one impact to the next, or how it rests, rolls or slides on a floor.
struct FlightStart {
  double t;                          ///< [s]
  RigidBodyState<> state;            ///< then
  int on_wall;                       ///< the floor that carries it, or -1: then it flies
  Vec3 acceleration = Vec3::Zero();  ///< of what a floor carries: it slides [m/s²]
  /// Whether the body was lifted for it, or thrown back harder than e says, in contact that lasts:
  /// what tips, rolls or slides in a curve is off by some per cent of its way, and more where slow.
  bool is_hop = false;
};

/// Where the energy of all bodies went [J]: start + impacts + sliding + settled = end, to rounding.
struct EnergyLedger {
  double start = 0;    ///< kinetic, and potential in the uniform gravity
  double impacts = 0;  ///< gained in impacts: never more than 0, but for rounding
  double sliding = 0;  ///< the work of friction on what slides on a face: ≤ 0, but for rounding
  double settled = 0;  ///< what bodies still had that were then said to rest, roll or slide: ≤ 0
  double end = 0;
};

/// What happened.
struct ContactRun {
  std::vector<ImpactEvent> impacts;               ///< in the order of time
  std::vector<std::vector<FlightStart>> flights;  ///< of each body, in the order of time
  std::vector<double> rest_since;                 ///< of each body [s], infinity if it moves
  EnergyLedger energy;
  Ending ending = Ending::time;
  int undecided = -1;        ///< the body in lasting contact, or -1
  double t = 0;              ///< when it ended [s]
  std::int64_t queries = 0;  ///< distances that it took

  /// How many of a body's flights are hops of contact that lasts.
  std::ptrdiff_t hops(std::size_t i) const {
    return std::count_if(flights[i].begin(), flights[i].end(),
                         [](const FlightStart& flight) { return flight.is_hop; });
  }

  /// The state of a body at a time, from the start to the end of the run.
  RigidBodyState<> state(const ContactScene& scene, int i, double time) const {
    const auto& legs = flights[static_cast<std::size_t>(i)];
    auto leg = std::upper_bound(legs.begin(), legs.end(), time,
                                [](double at, const FlightStart& f) { return at < f.t; });
    if (leg != legs.begin()) --leg;
    const Vec3& pull = leg->on_wall < 0 ? scene.gravity : leg->acceleration;
    return Flight(scene.body(i).body, leg->state, pull, leg->t).state(time);
  }
};

/// @}

}  // namespace tumble::contact
