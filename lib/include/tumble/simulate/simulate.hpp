#pragma once
/// @file
/// Says where a body goes, with an error that is stated and kept, in the cheapest way there is.
///
///   the turning is not wanted      a particle: its path, in closed form under steady forces
///   nothing turns the body         closed forms, exact to rounding at any time (so too where
///                                  forces pull along the axis that it spins about)
///   a symmetric top is pulled at   a closed form too, unless its axis passes next to the vertical
///   its axis
///   steady forces turn it          Taylor series of high order; the path in closed form
///   any other force                Dormand and Prince's method of order 8, or Radau IIA of order 5
///                                  where the scene is stiff
///
/// The last two run twice and more, until the error over the whole span is what was asked for, see
/// stated_error.hpp.

#include "tumble/body/force_pace.hpp"
#include "tumble/body/forces.hpp"
#include "tumble/simulate/any_forces.hpp"
#include "tumble/simulate/backwards.hpp"
#include "tumble/simulate/no_time.hpp"
#include "tumble/simulate/scaled_rhs.hpp"
#include "tumble/simulate/simulation_task.hpp"
#include "tumble/simulate/steady_trajectory.hpp"
#include "tumble/simulate/trajectory.hpp"
#include "tumble/simulate/valid_start.hpp"

namespace tumble {

/// @addtogroup simulate
/// @{

namespace detail {

/// What steady forces amount to.
/// @throws std::invalid_argument as SteadyForces::require_valid() does
template <class... Forces>
SteadyForces valid_steady_forces(const RigidBody<>& body, const Forces&... forces) {
  SteadyForces sum = steady_forces(body, forces...);
  sum.require_valid();
  return sum;
}

/// The motion under steady forces, or any.
/// @param task forwards in time, of a film run backwards or not
template <class... Forces>
Trajectory forwards_trajectory(const RigidBody<>& body, const RigidBodyState<>& from,
                               const SimulationTask& task, bool film, const Forces&... forces) {
  if constexpr ((SteadyForce<Forces> && ...)) {
    const SteadyForces sum = valid_steady_forces(body, forces...);
    return steady_trajectory(body, from, film ? backwards(sum) : sum, task);
  } else {
    using Rhs = RigidBodyRhs<double, FilmedForce<Forces>...>;
    (require_followable(forces, body, task.t1 - task.t0), ...);
    const Rhs rhs(body, FilmedForce<Forces>{forces, film}...);
    const ScaledRhs scaled(rhs, from, task.t0, task.t1 - task.t0);
    return AnyForces(scaled, from, task).trajectory();
  }
}

}  // namespace detail

/// The motion of a body.
/// @param start  at task.t0; q of any length but zero
/// @param task   with t1 before t0 the motion that has led to the start
/// @param forces BodyForce each; those that are a SteadyForce make it cheaper
/// @return the trajectory; its report says if the tolerance could not be reached, and what was. The
///         error is that of x, P and L relative to their largest sizes on the way, or to a
///         thousandth of what the body's own size and a turn by a radian in the span make of them:
///         of a body that forces hold at rest, nothing moves but what they are rounded to. If a
///         motion is smaller than that, error_of_small_motion says what error it has itself
/// @throws std::invalid_argument if a number is not finite, the quaternion zero or the tolerance
///         not positive, if a force refuses what it was made of, or if a spring or drag is so
///         strong that its motion could never be followed to t1
/// @throws std::runtime_error if the motion cannot be followed to t1: a force that is not finite, a
///         singularity, growth beyond all bounds, more turns than there is time for, which it says
///         at once; or if t0 is so large that its rounding hides how forces depend on the time
template <BodyForce<double>... Forces>
Trajectory simulate(const RigidBody<>& body, const RigidBodyState<>& start,
                    const SimulationTask& task, const Forces&... forces) {
  detail::require_valid_task(task);
  const RigidBodyState<> from = detail::valid_start(start);
  (detail::require_valid_force(forces), ...);
  if (task.t0 == task.t1) return detail::no_time_trajectory(body, from, task);
  const auto forwards = [&](const RigidBodyState<>& at_start, const SimulationTask& in_time,
                            bool film) {
    return detail::forwards_trajectory(body, at_start, in_time, film, forces...);
  };
  return detail::in_either_direction(forwards, from, task);
}

/// @}

}  // namespace tumble
