#pragma once
/// @file
/// Why a run does not come to its end: where it takes more steps than there is time for, and where
/// the motion leaves the range of doubles.

#include <cmath>
#include <string>
#include <vector>

#include "tumble/body/state.hpp"
#include "tumble/core/step_budget.hpp"

namespace tumble::detail {

/// How far apart doubles lie [s].
inline double rounding_at(double t) { return std::nextafter(t, 2 * t + 1) - t; }

/// What makes the steps so short, as far as they show it, and what to do.
/// @param breaks at which steps begin anew
/// @param s      where the run is [s after t0]
/// @param stiff  whether a solver for stiff scenes has been tried
std::string why_so_many(std::size_t breaks, const StepBudget& budget, double t0, double s,
                        bool stiff);

/// @param jumps by what part forces change where the time t is rounded
/// @throws std::runtime_error if they are unknown because of that
void require_moments(double jumps, double t);

/// @param square the largest of the squares of a motion's sizes
/// @throws std::runtime_error if they would soon be infinite
void require_range(double square, double t);

/// That a motion and its error are numbers, so that nobody gets an answer that is none.
/// @param error as it is stated
/// @param t1    the end of the span [s]
/// @throws std::runtime_error if the motion left the range of doubles on the way
void require_finite(const RigidBodyState<>& end, double error, double t1);
void require_finite(const std::vector<RigidBodyState<>>& ends, double error, double t1);

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/simulate/no_end.inl"
#endif
