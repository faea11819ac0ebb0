#pragma once
/// @file
/// The start of a simulation: refused if it means nothing, with a quaternion of moderate length.

#include "tumble/body/state.hpp"

namespace tumble::detail {

/// The start, its quaternion with numbers of about 1.
/// @throws std::invalid_argument if a number is not finite, or the quaternion zero
RigidBodyState<> valid_start(const RigidBodyState<>& start);

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/simulate/valid_start.inl"
#endif
