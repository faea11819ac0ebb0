#pragma once
/// @file
/// The whole library, but for tumble/collide.hpp and tumble/contact.hpp, which take as long to
/// compile.

/// @defgroup core Foundations
/// What every topic needs: vectors, refusals, solids.

/// @defgroup simd Vectors of numbers
/// Numbers of twice the digits, many numbers at once, and what the processor has for them.

#include "tumble/body.hpp"
#include "tumble/elliptic.hpp"
#include "tumble/ensemble.hpp"
#include "tumble/free_body.hpp"
#include "tumble/geometric.hpp"
#include "tumble/mass.hpp"
#include "tumble/mesh.hpp"
#include "tumble/ode.hpp"
#include "tumble/particles.hpp"
#include "tumble/quaternion.hpp"
#include "tumble/rotation.hpp"
#include "tumble/simulate.hpp"
#include "tumble/steady.hpp"
#include "tumble/version.hpp"

/// Rigid-body dynamics: the folders under `tumble/` are its topics, each header is one concept.
namespace tumble {}

/// Numbers of twice the digits, vectors of numbers, and the instructions that they use.
/// @ingroup simd
namespace tumble::simd {}
