#pragma once
/// @file
/// Everything that solves y' = f(t, y).

/// @defgroup ode Solvers
/// Everything that solves y' = f(t, y).

#include "tumble/ode/backward_euler.hpp"
#include "tumble/ode/c_interface.hpp"
#include "tumble/ode/dop853.hpp"
#include "tumble/ode/dormand_prince_54.hpp"
#include "tumble/ode/euler.hpp"
#include "tumble/ode/integrate_adaptive.hpp"
#include "tumble/ode/integrate_fixed.hpp"
#include "tumble/ode/midpoint.hpp"
#include "tumble/ode/observed_order.hpp"
#include "tumble/ode/radau5.hpp"
#include "tumble/ode/rk4.hpp"

/// What a method is made of and measured by: tableaus, the simplest methods, error norms.
/// @ingroup ode
namespace tumble::runge_kutta {}
