#pragma once
/// @file
/// What an impulse at a point does to the velocity there: u' = u + K j.
///
/// K = 1/m − [r]× I⁻¹ [r]× for one body, the sum of both for two. Source: Mirtich, "Impulse-based
/// Dynamic Simulation of Rigid Body Systems", PhD thesis, Berkeley (1996), §3.2 (the "collision
/// matrix").

#include "tumble/body/derived.hpp"

namespace tumble::contact {

/// @addtogroup contact
/// @{

/// How easily a point of a body is moved by an impulse there [1/kg].
/// @param now   its motion, for its place and orientation
/// @param point in the world [m]
/// @return symmetric and positive definite; of a body that nothing moves it is 0
Mat3 contact_matrix(const RigidBody<>& body, const Derived<>& now, const Vec3& point);

/// The state after an impulse [N s] at a point [m] of the body.
RigidBodyState<> after_impulse(const RigidBodyState<>& state, const Vec3& impulse,
                               const Vec3& point);

/// @}

}  // namespace tumble::contact

#ifndef TUMBLE_COMPILED
#include "tumble/contact/contact_matrix.inl"
#endif
