#pragma once
/// @file
/// A scene with a question whose answer is known.

#include "project/bench/contact/contest.hpp"
#include "project/bench/speed_against_error.hpp"
#include "tumble/contact/simulate_contacts.hpp"

namespace tumble::bench {

/// What is asked of those that go step by step, and of ours, that go from impact to impact. Both
/// say how far the answer is off.
struct Question {
  /// Lets the simulation, which has begun, go all its steps.
  std::function<double(Simulation&, double h, int steps)> of_steps;
  std::function<double(const contact::ContactScene&, const contact::ContactRun&)> of_run;
};

struct Problem {
  std::string name, title;
  std::string error;  ///< what it is, and its unit
  Scene scene;
  double duration;  ///< [s]
  Question question;
  double promised;  ///< of our best error, at most
  int count = 0;    ///< if not 0, the error is the share of so many that is missed
};

/// How far motions at the end are off, of bodies in their order.
using EndError = std::function<double(const std::vector<Motion>&)>;
Question at_end(const Scene& scene, double duration, const EndError& error);

/// A ball that bounces, lands with a slip, and five in a row.
std::vector<Problem> ball_problems();
/// A rod and a brick that land on a corner.
std::vector<Problem> corner_problems();
// Scenes that forget how they began: how many contacts does an answer stay right?
Problem billiard_break();
Problem brick_in_room();
/// What is right of all, as an error.
inline double share_missed(std::size_t right, std::size_t all) {
  return 1 - static_cast<double>(right) / static_cast<double>(all);
}

/// The scene as the library takes it.
contact::ContactScene contact_scene(const Scene& scene);
Entrant own_method(const Problem& problem);
/// @param stepper of which `make` gives something for this scene
Entrant stepping(const Problem& problem, const Stepper& stepper);

}  // namespace tumble::bench
