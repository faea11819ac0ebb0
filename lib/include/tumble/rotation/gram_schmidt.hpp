#pragma once
/// @file
/// Re-orthogonalisation by Gram–Schmidt: cheapest to understand, but the first column is never
/// moved and the last takes all the blame.

#include "tumble/core/types.hpp"

namespace tumble::rotation {

/// @addtogroup rotation
/// @{

/// A rotation near M: x = m₁/|m₁|, y = the part of m₂ perpendicular to x, normalised, z = x × y.
/// @param M 3×3 with columns m₁, m₂, m₃ that have drifted from a rotation's
/// @throws std::invalid_argument if M is not finite, its columns are dependent or left-handed
/// Source: Golub & Van Loan, "Matrix Computations" (2013), §5.2.
Mat3 gram_schmidt(const Mat3& M);

/// @}

}  // namespace tumble::rotation

#ifndef TUMBLE_COMPILED
#include "tumble/rotation/gram_schmidt.inl"
#endif
