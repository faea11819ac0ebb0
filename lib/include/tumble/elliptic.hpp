#pragma once
/// @file
/// Elliptic integrals and functions.

/// @defgroup elliptic Elliptic functions
/// Elliptic integrals and functions.

#include "tumble/elliptic/complementary_theta_series.hpp"
#include "tumble/elliptic/integrals.hpp"
#include "tumble/elliptic/modulus.hpp"
#include "tumble/elliptic/theta_series.hpp"

/// Elliptic integrals and Jacobi's functions, and the polhode that they describe.
/// @ingroup elliptic
namespace tumble::elliptic {}
