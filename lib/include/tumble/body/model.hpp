#pragma once
/// @file
/// The least that a body's turning needs. How many of its moments are equal decides what has to be
/// computed when nothing turns it:
///
///   particle       the turning is not wanted: position and momentum are enough
///   ball           ω = L/A for ever: no tensor, no orientation needed to know ω
///   symmetric top  turns about L and about its own axis at constant rates: sines only
///   full body      the equation of motion, or elliptic functions
///
/// Source: Landau & Lifshitz, "Mechanics" (1976), §33 and §37.

#include <string>

#include "tumble/body/rigid_body.hpp"
#include "tumble/mass/principal_axes.hpp"

namespace tumble {

/// @addtogroup body
/// @{

enum class Model { particle, ball, symmetric_top, full_body };

/// "symmetric top", …
inline const char* name_of(Model model) {
  constexpr const char* names[] = {"particle", "ball", "symmetric top", "full body"};
  return names[static_cast<int>(model)];
}

/// A model, and why it will do.
struct ModelChoice {
  Model model;
  std::string why;
};

/// A body's moments sorted for its model: the odd one out and the mean of the two that are equal.
struct SymmetricMoments {
  double axial;       ///< C, about the axis of symmetry [kg m²]
  double transverse;  ///< A, about any axis perpendicular to it [kg m²]
  Vec3 axis;          ///< unit vector of the axis of symmetry, body coordinates
  double asymmetry;   ///< difference of the two nearly equal moments, by the larger: 0 for a top
};

/// The symmetric top that is nearest to a body.
SymmetricMoments nearest_symmetric_top(const PrincipalAxes& p);
inline SymmetricMoments nearest_symmetric_top(const RigidBody<>& body) {
  return nearest_symmetric_top(principal_axes(body.I_body()));
}

/// The simplest model that tells the turning of a body that nothing pushes round.
/// @param tolerance difference of two moments, by the larger one, that counts as none. The angle
///                  that it makes wrong grows as tolerance · |ω| · t, so choose it for the time
///                  span. For a spin perpendicular to the axis of a near-symmetry it grows as t²
/// @throws std::invalid_argument if the tolerance is negative or not finite
ModelChoice model_of_moments(const PrincipalAxes& axes, double tolerance = 0);
inline ModelChoice model_of_moments(const RigidBody<>& body, double tolerance = 0) {
  return model_of_moments(principal_axes(body.I_body()), tolerance);
}

/// @}

}  // namespace tumble

#ifndef TUMBLE_COMPILED
#include "tumble/body/model.inl"
#endif
