#pragma once
/// @file
/// Everything about rotation matrices.

/// @defgroup rotation Rotation matrices
/// Everything about rotation matrices.

#include "tumble/rotation/euler_angles.hpp"
#include "tumble/rotation/exp.hpp"
#include "tumble/rotation/gram_schmidt.hpp"
#include "tumble/rotation/nearest_rotation.hpp"
#include "tumble/rotation/newton_rotation.hpp"
#include "tumble/rotation/orthonormality.hpp"
#include "tumble/rotation/rotation_dot.hpp"
#include "tumble/rotation/skew.hpp"

/// How orientations change, and how they are kept orthonormal: matrices, and quaternions too.
/// @ingroup rotation
namespace tumble::rotation {}
