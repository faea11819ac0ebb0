#pragma once
/// @file
/// The terms of a turning's series, to be kept when the series goes on to the next moment.

#include "tumble/steady/four_lanes.hpp"
#include "tumble/steady/steady_torque.hpp"

namespace tumble::detail {

/// One coefficient of q and of ω.
struct TurningTerm {
  FourDoubles q, w;
};

/// The state a time h after the moment of a series, from its terms 0 … order, an even number: even
/// and odd ones side by side, which is twice as fast as one after the other.
steady::TurningState turning_at(const TurningTerm* terms, int order, double h);

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/steady/turning_term.inl"
#endif
