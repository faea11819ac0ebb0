#pragma once
/// @file
/// Re-orthogonalisation by the polar decomposition: the rotation nearest to M, no column favoured.
///
/// M = R S with S symmetric; from the singular value decomposition M = U Σ Vᵀ, R = U Vᵀ, with the
/// sign of the last singular direction turned where that would be a reflection.
///
/// Source: Higham, "Functions of Matrices" (2008), ch. 8; the sign: Umeyama, IEEE PAMI 13
/// (1991), eq. 43.

#include "tumble/core/types.hpp"

namespace tumble {

/// @addtogroup rotation
/// @{

/// The rotation R that minimises ‖R − M‖ (Frobenius).
/// @param M any 3×3 matrix of rank 2 or 3
/// @throws std::invalid_argument if M is not finite or of rank < 2: no rotation is nearest then
Mat3 nearest_rotation(const Mat3& M);

/// @}

}  // namespace tumble

#ifndef TUMBLE_COMPILED
#include "tumble/rotation/nearest_rotation.inl"
#endif
