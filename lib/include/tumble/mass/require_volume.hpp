#pragma once
/// @file
/// What mass properties must be before they can be those of a body.

#include "tumble/mass/error_bound.hpp"

namespace tumble {

/// @addtogroup mass
/// @{

namespace detail {

/// Refuses numbers that doubles hold with fewer digits than usual, or not at all.
/// @param of what has them: "mesh"
/// @throws std::invalid_argument if the mass or the tensor is subnormal, or not finite
void require_normal(const MassProperties& body, const char* of);

}  // namespace detail

/// Passes on mass properties that can be those of a body.
/// @throws std::invalid_argument if the mesh is inside out, or so flat, thin or small that no digit
///         of its mass or inertia is certain
BoundedMassProperties require_volume(const BoundedMassProperties& body);

/// @}

}  // namespace tumble

#ifndef TUMBLE_COMPILED
#include "tumble/mass/require_volume.inl"
#endif
