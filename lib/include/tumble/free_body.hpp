#pragma once
/// @file
/// Everything about bodies that nothing pushes: closed forms.

/// @defgroup free_body Free bodies in closed form
/// Everything about bodies that nothing pushes: closed forms.

#include "tumble/free_body/free_asymmetric_top.hpp"
#include "tumble/free_body/free_flow.hpp"
#include "tumble/free_body/free_symmetric_top.hpp"
#include "tumble/free_body/free_trajectory.hpp"
#include "tumble/free_body/polhode.hpp"
#include "tumble/free_body/uniform_rotation.hpp"
