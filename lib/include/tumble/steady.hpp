#pragma once
/// @file
/// Everything about bodies under forces that are constant in the world.

/// @defgroup steady Steady forces and tops in closed form
/// Everything about bodies under forces that are constant in the world.

#include "tumble/steady/lagrange_top.hpp"
#include "tumble/steady/slowing.hpp"
#include "tumble/steady/steady_path.hpp"
#include "tumble/steady/steady_torque.hpp"
#include "tumble/steady/top_constants.hpp"
#include "tumble/steady/turning_by_series.hpp"
#include "tumble/steady/turning_lanes.hpp"
#include "tumble/steady/turning_series.hpp"
#include "tumble/steady/turning_step.hpp"
#include "tumble/steady/turning_term.hpp"

/// What forces that are constant in the world make of a body: a top in closed form, Taylor series.
/// @ingroup steady
namespace tumble::steady {}
