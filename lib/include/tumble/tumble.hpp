#pragma once
/// @file
/// The whole library.

/// @defgroup core Foundations
/// What every topic needs: vectors, refusals, solids, numbers of twice the digits, threads.

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
