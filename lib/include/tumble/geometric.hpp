#pragma once
/// @file
/// Steps that keep what motions keep.

/// @defgroup geometric Geometric steps
/// Steps that keep what motions keep.

#include "tumble/geometric/composition.hpp"
#include "tumble/geometric/lie_group_rk4.hpp"
#include "tumble/geometric/splitting.hpp"

/// Steps that keep what motions keep: splittings, and a Lie-group method.
/// @ingroup geometric
namespace tumble::geometric {}
