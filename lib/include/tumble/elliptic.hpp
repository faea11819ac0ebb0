#pragma once
/// @file
/// Elliptic integrals and functions.

/// @defgroup elliptic Elliptic functions
/// Elliptic integrals and functions.

#include "tumble/elliptic/complementary_theta_series.hpp"
#include "tumble/elliptic/integrals.hpp"
#include "tumble/elliptic/modulus.hpp"
#include "tumble/elliptic/theta_series.hpp"
