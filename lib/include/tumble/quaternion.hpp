#pragma once
/// @file
/// Everything about quaternions that Eigen does not have.

/// @defgroup quaternion Quaternions
/// Everything about quaternions that Eigen does not have.

#include "tumble/quaternion/between_directions.hpp"
#include "tumble/quaternion/convert.hpp"
#include "tumble/quaternion/exp_log.hpp"
#include "tumble/quaternion/normalize.hpp"
#include "tumble/quaternion/quaternion_dot.hpp"
#include "tumble/quaternion/slerp.hpp"
