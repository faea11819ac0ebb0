#pragma once
/// @file
/// The rigid body: state, forces, dydt, models.

/// @defgroup body Rigid bodies
/// The rigid body: state, forces, dydt, models.

#include "tumble/body/derived.hpp"
#include "tumble/body/dydt.hpp"
#include "tumble/body/exact_omega.hpp"
#include "tumble/body/force_pace.hpp"
#include "tumble/body/forces.hpp"
#include "tumble/body/forces_between.hpp"
#include "tumble/body/held_body.hpp"
#include "tumble/body/many_bodies.hpp"
#include "tumble/body/matrix_state.hpp"
#include "tumble/body/model.hpp"
#include "tumble/body/rigid_body.hpp"
#include "tumble/body/state.hpp"
#include "tumble/body/steady_forces.hpp"
#include "tumble/body/wrench.hpp"
