#pragma once
/// @file
/// Says where a body goes, with an error that is stated and kept, in the cheapest way there is.
///
///   nobody asks for the turning    a particle: its path, in closed form under steady forces
///   nothing turns the body         closed forms, exact to rounding at any time (so too where
///                                  forces pull along the axis that it spins about)
///   a symmetric top is pulled at   a closed form too, unless its axis passes next to the vertical
///   its axis
///   steady forces turn it          Taylor series of high order; the path in closed form
///   any other force                Dormand and Prince's method of order 8
///
/// The last two run twice and more, until the error over the whole span is what was asked for, see
/// stated_error.hpp.

#include <cmath>
#include <memory>
#include <string>

#include "tumble/body/forces.hpp"
#include "tumble/free_body/free_trajectory.hpp"
#include "tumble/simulate/general_trajectory.hpp"
#include "tumble/simulate/simulation_task.hpp"
#include "tumble/simulate/steady_trajectory.hpp"
#include "tumble/simulate/trajectory.hpp"
#include "tumble/steady/lagrange_top.hpp"

namespace tumble {

/// @addtogroup simulate
/// @{

namespace detail {

/// Moments between which a closed form does not turn by more than a quarter of a radian.
inline std::vector<double> times_of_turning(double t0, double t1, double omega) {
  constexpr double max_parts = 1e6;
  const double parts = std::clamp(std::ceil(4 * omega * (t1 - t0)), 8.0, max_parts);
  std::vector<double> times;
  for (int i = 0; i <= static_cast<int>(parts); ++i)
    times.push_back(i == static_cast<int>(parts) ? t1 : t0 + i * (t1 - t0) / parts);
  return times;
}

/// A trajectory that owns its run.
template <class Run>
Trajectory trajectory_of(Run&& run, const SimulationReport& report) {
  const auto kept = std::make_shared<const std::decay_t<Run>>(std::forward<Run>(run));
  return {[kept](double t) { return kept->at(t); }, kept->times(), report};
}

/// The error of closed forms: what FreeTrajectory promises.
inline double closed_form_error(double omega, double t0, double t1) {
  return 1e-14 * std::max(1.0, omega * (t1 - t0));
}

inline Trajectory free_trajectory(const RigidBody<>& body, const RigidBodyState<>& start,
                                  const steady::SteadyPath& path, const SimulationTask& task) {
  const auto motion = std::make_shared<const FreeTrajectory>(body, start);
  const double omega = derived(body, start).omega.norm();
  const ModelChoice choice = choose_model(body);
  const SimulationReport report{.model = choice.model,
                                .method = std::string("closed form: ") + name_of(*motion),
                                .why = "no torque; " + choice.why,
                                .tolerance = task.tolerance,
                                .error_estimate = closed_form_error(omega, task.t0, task.t1)};
  const auto at = [motion, path, t0 = task.t0](double t) -> RigidBodyState<> {
    const RigidBodyState<> turned = motion->at(t - t0);
    return {path.x(t - t0), turned.q, path.P(t - t0), turned.L};
  };
  return {at, times_of_turning(task.t0, task.t1, omega), report};
}

inline Trajectory particle_trajectory(const RigidBodyState<>& start, const steady::SteadyPath& path,
                                      const SimulationTask& task) {
  const SimulationReport report{
      .model = Model::particle,
      .method = "closed form: path under steady forces",
      .why = "nobody asks for the turning, and the path does not depend on it",
      .tolerance = task.tolerance,
      .error_estimate = 1e-15};
  const auto at = [start, path, t0 = task.t0](double t) -> RigidBodyState<> {
    return {path.x(t - t0), start.q, path.P(t - t0), start.L};
  };
  return {at, times_of_turning(task.t0, task.t1, 0), report};
}

inline Trajectory top_trajectory(const steady::LagrangeTop& top, const RigidBody<>& body,
                                 const RigidBodyState<>& start, const steady::SteadyPath& path,
                                 const SimulationTask& task) {
  const SimulationReport report{
      .model = Model::symmetric_top,
      .method = "closed form: Lagrange top (elliptic functions)",
      .why = "two principal moments are equal, and the force acts on the axis",
      .tolerance = task.tolerance,
      .error_estimate = top.error_bound(task.t1 - task.t0)};
  const auto at = [top, path, t0 = task.t0](double t) -> RigidBodyState<> {
    const steady::LagrangeTop::State turned = top.at(t - t0);
    return {path.x(t - t0), turned.q, path.P(t - t0), turned.L};
  };
  const double omega = derived(body, start).omega.norm() + top.rate();
  return {at, times_of_turning(task.t0, task.t1, omega), report};
}

template <int rank>
Trajectory turning_trajectory(const steady::SteadyTorque& torque, const steady::SteadyPath& path,
                              const RigidBodyState<>& start, const SimulationTask& task) {
  const double span = task.t1 - task.t0, inertia = torque.axes().moments.mean();
  double turning = start.L.norm();
  for (int r = 0; r < torque.rank(); ++r) turning = std::max(turning, torque.arm(r).norm() * span);
  const MotionScale scale{
      .length = 1, .momentum = 1, .angular_momentum = std::max(turning, inertia / span)};
  SimulationReport report{
      .model = Model::full_body, .why = "steady forces turn the body", .tolerance = task.tolerance};
  const auto run = [&](const RigidBodyState<>& from, double tolerance) {
    return SteadyTrajectory<rank>(torque, path, from, task.t0, task.t1, tolerance);
  };
  auto motion = run_to_tolerance(run, start, scale, task.t0, task.t1, report);
  report.method = "Taylor series of order " + std::to_string(motion.order());
  return trajectory_of(std::move(motion), report);
}

inline Trajectory steady_trajectory(const RigidBody<>& body, const RigidBodyState<>& start,
                                    const SteadyForces& forces, const SimulationTask& task) {
  const steady::SteadyPath path(body, start, forces);
  if (task.wanted == Wanted::path_only) return particle_trajectory(start, path, task);
  const steady::SteadyTorque torque(body, forces);
  if (torque.is_free() || torque.is_idle(torque.turning(start.q, start.L)) || task.t0 == task.t1)
    return free_trajectory(body, start, path, task);
  if (const auto top = steady::LagrangeTop::from(torque, start.q, start.L))
    if (top->error_bound(task.t1 - task.t0) <= task.tolerance)
      return top_trajectory(*top, body, start, path, task);
  switch (torque.rank()) {
    case 0:
      return turning_trajectory<0>(torque, path, start, task);
    case 1:
      return turning_trajectory<1>(torque, path, start, task);
    case 2:
      return turning_trajectory<2>(torque, path, start, task);
    default:
      return turning_trajectory<3>(torque, path, start, task);
  }
}

template <class... Forces>
Trajectory general_trajectory(const RigidBody<>& body, const RigidBodyState<>& start,
                              const SimulationTask& task, const Forces&... forces) {
  using Rhs = RigidBodyRhs<double, Forces...>;
  const Rhs rhs(body, forces...);
  const MotionScale scale = scale_of(rhs, start, task.t0, task.t1);
  SimulationReport report{.model = Model::full_body,
                          .method = "Dormand–Prince 8(5,3)",
                          .why = "a force depends on where the body is or how it is turned",
                          .tolerance = task.tolerance};
  const auto run = [&](const RigidBodyState<>& from, double tolerance) {
    return GeneralTrajectory<Rhs>(rhs, scale, from, task.t0, task.t1, tolerance);
  };
  auto solution = run_to_tolerance(run, start, scale, task.t0, task.t1, report);
  return trajectory_of(std::move(solution), report);
}

}  // namespace detail

/// The motion of a body.
/// @param start  at task.t0; q of any length but zero
/// @param forces BodyForce each; those that are a SteadyForce make it cheaper
/// @return the trajectory; its report says if the tolerance could not be reached, and what was
/// @throws std::invalid_argument if a number is not finite, the quaternion zero, t1 before t0 or
///         the tolerance not positive, or if a force refuses what it was made of
/// @throws std::runtime_error if the motion cannot be followed to t1: a force that is not finite, a
///         singularity, a stiff scene
template <BodyForce<double>... Forces>
Trajectory simulate(const RigidBody<>& body, const RigidBodyState<>& start,
                    const SimulationTask& task, const Forces&... forces) {
  require(std::isfinite(task.t0) && std::isfinite(task.t1) && task.t0 <= task.t1,
          "simulate: from t0 = ", task.t0, " to t1 = ", task.t1, " is no span of time");
  require(task.tolerance > 0 && std::isfinite(task.tolerance), "simulate: the tolerance ",
          task.tolerance, " is not positive and finite");
  require(pack(start).allFinite(), "simulate: the state (", pack(start).transpose(),
          ") is not finite");
  require(start.q.squaredNorm() > 0, "simulate: the quaternion is zero");
  (detail::require_valid_force(forces), ...);
  RigidBodyState<> from = start;
  from.q.normalize();
  if constexpr ((detail::SteadyForce<Forces> && ...))
    return detail::steady_trajectory(body, from, detail::steady_forces(body, forces...), task);
  else
    return detail::general_trajectory(body, from, task, forces...);
}

/// @}

}  // namespace tumble
