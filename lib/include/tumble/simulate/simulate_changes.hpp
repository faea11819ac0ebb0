#pragma once
/// @file
/// Motions that events change at once: a rocket that drops its stage, a rope that tears, a ball
/// that you turn back yourself. For bodies that hit each other, contact/simulate_contacts.hpp knows
/// more.
///
/// The whole is computed twice, with a rough and with a fine tolerance: what the two differ by
/// holds what the events make of errors, too. A time has 16 digits. At t = 1000 s an event is late
/// by up to 10⁻¹³ s, and in two runs alike; so those of the rough run are late by one digit more.

#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "tumble/simulate/event_count.hpp"
#include "tumble/simulate/pieces.hpp"
#include "tumble/simulate/simulate_bodies.hpp"

namespace tumble::events {

/// @addtogroup simulate
/// @{

/// What a simulation with events gives.
template <class State>
struct ChangedTrajectory {
  TrajectoryOf<State> trajectory;              ///< at the time of an event: after it
  std::vector<detail::EventOf<State>> events;  ///< when, and the state before the change
};

/// @}

}  // namespace tumble::events

namespace tumble::detail {

/// A callable (t, state) → state, or std::optional of it: nothing ends the motion.
template <class F, class State>
concept StateChange = requires(const F& change, double t, const State& state) {
  { change(t, state) } -> std::convertible_to<std::optional<State>>;
};

/// The first time at which `when` has come from above zero.
template <class State, class When>
std::optional<EventOf<State>> first_fall(const TrajectoryOf<State>& motion, const When& when) {
  std::optional<EventOf<State>> fall;
  visit_events(motion, when, [&](const EventOf<State>& event, bool falls) {
    if (falls) fall = event;
    return !fall;
  });
  return fall;
}

/// What happens one rounding of the time later.
template <class State>
EventOf<State> later(const EventOf<State>& event, const TrajectoryOf<State>& motion) {
  const double t = std::nextafter(event.t, motion.t1());
  return {t, motion.at(t)};
}

/// When events change the state: where they are found, or one rounding later.
enum class Changed { in_time, late };

/// Goes from event to event.
/// @param go go(state, task) → the motion without events
template <class State, class Go, class When, class Change>
TrajectoryWithChanges<State> change_at_events(const Go& go, State state, const SimulationTask& task,
                                              const When& when, const Change& change,
                                              Changed moment) {
  TrajectoryWithChanges<State> changed;
  EventCount events(task.t1 - task.t0);
  SimulationTask part = task;
  double t = task.t0, window = task.t1 - task.t0, last = t;
  while (t < task.t1 || changed.pieces.empty()) {
    part.t0 = t;
    part.t1 = task.t1 - t <= 1.01 * window ? task.t1 : t + window;
    const TrajectoryOf<State> motion = go(state, part);
    std::optional<EventOf<State>> event = first_fall(motion, when);
    if (event && moment == Changed::late) event = later(*event, motion);
    changed.pieces.push_back({motion, t, event ? event->t : part.t1});
    t = changed.pieces.back().t1;
    if (event) {
      changed.events.push_back(*event);
      const std::optional<State> next = change(t, event->state);
      if (!next) break;
      events.count(t, t - last);
      // The next event is looked for not much further than the last one was away.
      window = 4 * (t - last);
      last = t;
      state = *next;
    } else {
      state = motion.end();
      window *= 2;
    }
  }
  return changed;
}

template <class State>
SimulationReport report_of(const TrajectoryWithChanges<State>& motion) {
  SimulationReport all = motion.pieces.front().motion.report();
  for (const Piece<State>& piece : std::span(motion.pieces).subspan(1))
    add_report(all, piece.motion.report());
  return all;
}

/// Runs the whole with ever finer tolerances until two runs agree.
template <class State, class Go, class When, class Change>
events::ChangedTrajectory<State> changed_trajectory(const Go& go, const State& start,
                                                    const SimulationTask& task, const When& when,
                                                    const Change& change) {
  constexpr double finer = 0.03, finest = 1e-13;
  const auto run = [&](double tolerance, Changed moment) {
    SimulationTask part = task;
    part.tolerance = tolerance;
    return change_at_events<State>(go, start, part, when, change, moment);
  };
  double tolerance = std::max(finest / finer, 0.3 * task.tolerance);
  Changed moment = Changed::late;  // in each second run, so that two differ by it
  TrajectoryWithChanges<State> rough = run(tolerance, moment);
  while (true) {
    tolerance = std::max(finest, finer * tolerance);
    moment = moment == Changed::late ? Changed::in_time : Changed::late;
    TrajectoryWithChanges<State> fine = run(tolerance, moment);
    SimulationReport report = report_of(fine);
    report.tolerance = task.tolerance;
    // Two runs that meet different events have nothing in common.
    report.error_estimate +=
        fine.events.size() == rough.events.size() && fine.pieces.size() == rough.pieces.size()
            ? difference_of(rough, fine)
            : std::numeric_limits<double>::infinity();
    if (report.reached() || tolerance == finest) {
      const double t1 = fine.pieces.back().t1;
      return {
          {std::make_shared<const PiecewiseTrajectory<State>>(fine.pieces), task.t0, t1, report},
          fine.events};
    }
    rough = std::move(fine);
  }
}

void require_forwards(const SimulationTask& task);

}  // namespace tumble::detail

namespace tumble::events {

/// @addtogroup simulate
/// @{

/// The motion of a body that is changed each time `when` falls from above zero.
/// @param when   (t, state) → number
/// @param change (t, state) → the state after it, or std::optional: nothing ends the motion
/// @return the motion and the events; the report's error holds what the events make of errors, and
///         is infinite if two tolerances meet different events
/// @throws as simulate(), std::invalid_argument if t1 is before t0, and std::runtime_error if the
///         events come to no end
template <detail::EventFunction When, detail::StateChange<RigidBodyState<>> Change,
          BodyForce<double>... Forces>
ChangedTrajectory<RigidBodyState<>> simulate_changes(const RigidBody<>& body,
                                                     const RigidBodyState<>& start,
                                                     const SimulationTask& task, const When& when,
                                                     const Change& change,
                                                     const Forces&... forces) {
  detail::require_forwards(task);
  const auto go = [&](const RigidBodyState<>& from, const SimulationTask& part) {
    return simulate(body, from, part, forces...);
  };
  return detail::changed_trajectory(go, start, task, when, change);
}

/// The motion of several bodies, in the same way; `when` and `change` take the states of all.
template <detail::EventFunction<std::vector<RigidBodyState<>>> When,
          detail::StateChange<std::vector<RigidBodyState<>>> Change, detail::AnyForce... Forces>
ChangedTrajectory<std::vector<RigidBodyState<>>> simulate_changes(
    const std::vector<RigidBody<>>& bodies, const std::vector<RigidBodyState<>>& starts,
    const SimulationTask& task, const When& when, const Change& change, const Forces&... forces) {
  detail::require_forwards(task);
  const auto go = [&](const std::vector<RigidBodyState<>>& from, const SimulationTask& part) {
    return simulate(bodies, from, part, forces...);
  };
  return detail::changed_trajectory(go, starts, task, when, change);
}

/// @}

}  // namespace tumble::events

#ifndef TUMBLE_COMPILED
#include "tumble/simulate/simulate_changes.inl"
#endif
