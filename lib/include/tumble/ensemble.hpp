#pragma once
/// @file
/// Many independent bodies in one call.

/// @defgroup ensemble Ensembles
/// Many independent bodies in one call.

#include "tumble/ensemble/advance.hpp"
#include "tumble/ensemble/common_fall.hpp"
#include "tumble/ensemble/drift.hpp"
#include "tumble/ensemble/eights.hpp"
#include "tumble/ensemble/ensemble.hpp"
#include "tumble/ensemble/fixed_steps.hpp"
#include "tumble/ensemble/force_kernel_list.hpp"
#include "tumble/ensemble/force_kernels.hpp"
#include "tumble/ensemble/force_of.hpp"
#include "tumble/ensemble/lost_bodies.hpp"
#include "tumble/ensemble/magnus.hpp"
#include "tumble/ensemble/pack_force.hpp"
#include "tumble/ensemble/packs_in_turn.hpp"
#include "tumble/ensemble/rk4.hpp"
#include "tumble/ensemble/spin.hpp"
#include "tumble/ensemble/stepper.hpp"
#include "tumble/ensemble/taylor_magnus.hpp"

/// What a force of your own on an ensemble is given, and what it gives.
/// @ingroup ensemble
namespace tumble::ensemble {}
