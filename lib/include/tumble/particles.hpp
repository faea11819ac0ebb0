#pragma once
/// @file
/// Everything about particles and what pushes them.

/// @defgroup particles Particles
/// Everything about particles and what pushes them.

#include "tumble/particles/drag.hpp"
#include "tumble/particles/flatten.hpp"
#include "tumble/particles/force.hpp"
#include "tumble/particles/particle.hpp"
#include "tumble/particles/particle_system.hpp"
#include "tumble/particles/spring.hpp"
#include "tumble/particles/uniform_gravity.hpp"

/// Particles, the forces on them, and their state as one column.
/// @ingroup particles
namespace tumble::particles {}
