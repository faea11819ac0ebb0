#pragma once
/// @file
/// A motion from late to early is what a film of it shows that runs backwards. With s = −t all
/// velocities and momenta have the other sign, and the forces are what they were.

#include <memory>
#include <utility>
#include <vector>

#include "tumble/body/many_bodies.hpp"
#include "tumble/simulate/simulation_task.hpp"
#include "tumble/simulate/trajectory.hpp"

namespace tumble::detail {

inline RigidBodyState<> backwards(RigidBodyState<> state) {
  state.P = -state.P;
  state.L = -state.L;
  return state;
}
inline std::vector<RigidBodyState<>> backwards(std::vector<RigidBodyState<>> states) {
  for (RigidBodyState<>& state : states) state = backwards(std::move(state));
  return states;
}
inline Derived<> backwards(Derived<> now) {
  now.v = -now.v;
  now.omega = -now.omega;
  return now;
}

/// Drag pushes in the film.
inline SteadyForces backwards(SteadyForces forces) {
  forces.linear_drag = -forces.linear_drag;
  forces.angular_drag = -forces.angular_drag;
  return forces;
}

inline SimulationTask backwards(SimulationTask task) {
  task.t0 = -task.t0;
  task.t1 = -task.t1;
  for (double& t : task.breaks) t = -t;
  return task;
}

/// A force on a body or between bodies, as it is or as the film shows it. One type for both, so
/// that the solvers are compiled once.
template <class Force>
struct FilmedForce {
  Force force;
  bool backwards_in_time;

  Wrench<> operator()(double t, const RigidBody<>& body,
                      const Derived<>& now) const requires BodyForce<Force, double> {
    return backwards_in_time ? force(-t, body, backwards(now)) : force(t, body, now);
  }
  void operator()(double t, std::span<const RigidBody<>> bodies, std::span<const Derived<>> now,
                  std::span<Wrench<>> net) const requires SceneForce<Force, double> {
    if (!backwards_in_time) return force(t, bodies, now, net);
    std::vector<Derived<>> then;
    for (const Derived<>& each : now) then.push_back(backwards(each));
    force(-t, bodies, std::span<const Derived<>>(then), net);
  }
};

/// The motion, from the film of it.
template <class State>
class BackwardsTrajectory final : public AnyTrajectory<State> {
 public:
  explicit BackwardsTrajectory(TrajectoryOf<State> film) : film_(std::move(film)) {}

  State at(double t) const override { return backwards(film_.at(-t)); }
  std::vector<double> times() const override {
    std::vector<double> times = film_.times();
    for (double& t : times) t = -t;
    return times;
  }

 private:
  TrajectoryOf<State> film_;
};

template <class State>
TrajectoryOf<State> backwards(const TrajectoryOf<State>& film) {
  return {std::make_shared<const BackwardsTrajectory<State>>(film), -film.t0(), -film.t1(),
          film.report()};
}

/// The motion of a task in either direction of time.
/// @param forwards forwards(start, task, whether it is a film run backwards) → the motion
template <class State, class Forwards>
TrajectoryOf<State> in_either_direction(const Forwards& forwards, const State& from,
                                        const SimulationTask& task) {
  if (task.t0 < task.t1) return forwards(from, task, false);
  return backwards(forwards(backwards(from), backwards(task), true));
}

}  // namespace tumble::detail
