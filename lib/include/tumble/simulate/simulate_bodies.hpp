#pragma once
/// @file
/// Says where several bodies go that may push each other, with an error that is stated and kept.
/// Bodies that nothing joins are simulated each by itself, in closed form where there is one.

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "tumble/simulate/scaled_scene_rhs.hpp"
#include "tumble/simulate/simulate.hpp"

namespace tumble {

/// @addtogroup simulate
/// @{

/// The motion of several bodies: the states of all at any time.
using SceneTrajectory = TrajectoryOf<std::vector<RigidBodyState<>>>;

namespace detail {

/// Bodies that do nothing to each other.
class ApartTrajectory final : public AnyTrajectory<std::vector<RigidBodyState<>>> {
 public:
  explicit ApartTrajectory(std::vector<Trajectory> bodies) : bodies_(std::move(bodies)) {}

  std::vector<RigidBodyState<>> at(double t) const override {
    std::vector<RigidBodyState<>> states;
    for (const Trajectory& body : bodies_) states.push_back(body.at(t));
    return states;
  }
  /// Those of all bodies.
  std::vector<double> times() const override {
    std::vector<double> all;
    for (const Trajectory& body : bodies_) {
      const std::vector<double> times = body.times();
      all.insert(all.end(), times.begin(), times.end());
    }
    const bool forwards = all.front() <= all.back();
    std::sort(all.begin(), all.end(), [=](double s, double t) { return forwards ? s < t : t < s; });
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
  }

 private:
  std::vector<Trajectory> bodies_;
};

SimulationReport report_of(const std::vector<Trajectory>& bodies);

/// @throws std::invalid_argument naming the body whose start means nothing
std::vector<RigidBodyState<>> valid_starts(const std::vector<RigidBodyState<>>& starts);

/// A force on a body, or between bodies.
template <class F>
concept AnyForce = BodyForce<F, double> || SceneForce<F, double>;

/// @param task forwards in time, of a film run backwards or not
template <class... Forces>
SceneTrajectory joined_trajectory(const std::vector<RigidBody<>>& bodies,
                                  const std::vector<RigidBodyState<>>& from,
                                  const SimulationTask& task, bool film, const Forces&... forces) {
  using Rhs = SceneRhs<double, FilmedForce<Forces>...>;
  const auto require_followable_by = [&](const auto& force) {
    require_followable(force, std::span<const RigidBody<>>(bodies), task.t1 - task.t0);
    for (const RigidBody<>& body : bodies) require_followable(force, body, task.t1 - task.t0);
  };
  (require_followable_by(forces), ...);
  const Rhs rhs(bodies, FilmedForce<Forces>{forces, film}...);
  const ScaledSceneRhs scaled(rhs, from, task.t0, task.t1 - task.t0);
  return AnyForces(scaled, from, task).trajectory();
}

}  // namespace detail

/// The motion of several bodies.
/// @param starts of each body at task.t0; q of any length but zero
/// @param task   Wanted::path_only has a meaning only where no force acts between bodies
/// @param forces BodyForce each, which acts on every body, or a callable (t, bodies, motions,
///               wrenches) that adds to the wrenches of those it acts on
/// @return the trajectory; its report is that of the body that was hardest to follow
/// @throws as simulate() of one body, naming the body, and std::invalid_argument if there are no
///         bodies, or not as many states
template <detail::AnyForce... Forces>
SceneTrajectory simulate(const std::vector<RigidBody<>>& bodies,
                         const std::vector<RigidBodyState<>>& starts, const SimulationTask& task,
                         const Forces&... forces) {
  detail::require_valid_task(task);
  require(!bodies.empty(), "simulate: there are no bodies");
  require(bodies.size() == starts.size(), "simulate: ", bodies.size(), " bodies, but ",
          starts.size(), " states");
  const std::vector<RigidBodyState<>> from = detail::valid_starts(starts);
  if constexpr ((BodyForce<Forces, double> && ...)) {
    std::vector<Trajectory> apart;
    for (std::size_t i = 0; i < bodies.size(); ++i)
      apart.push_back(simulate(bodies[i], from[i], task, forces...));
    return {std::make_shared<const detail::ApartTrajectory>(apart), task.t0, task.t1,
            detail::report_of(apart)};
  } else {
    (detail::require_valid_force(forces), ...);
    if (task.t0 == task.t1) return simulate(bodies, from, task);
    const auto forwards = [&](const std::vector<RigidBodyState<>>& at_start,
                              const SimulationTask& in_time, bool film) {
      return detail::joined_trajectory(bodies, at_start, in_time, film, forces...);
    };
    return detail::in_either_direction(forwards, from, task);
  }
}

/// @}

}  // namespace tumble

#ifndef TUMBLE_COMPILED
#include "tumble/simulate/simulate_bodies.inl"
#endif
