#pragma once
/// @file
/// Everything about the motion of rigid bodies.

#include "tumble/body/derived.hpp"
#include "tumble/body/dydt.hpp"
#include "tumble/body/ensemble/advance.hpp"
#include "tumble/body/forces.hpp"
#include "tumble/body/free/free_motion.hpp"
#include "tumble/body/many_bodies.hpp"
#include "tumble/body/matrix_state.hpp"
#include "tumble/body/model.hpp"
#include "tumble/body/rigid_body.hpp"
#include "tumble/body/simulate/first_event.hpp"
#include "tumble/body/simulate/simulate.hpp"
#include "tumble/body/state.hpp"
#include "tumble/body/wrench.hpp"
