#pragma once
/// @file
/// The least that a body's turning needs: three equal moments, two, or none decide
/// what is computed.
///
///   ball           ω = L/A for ever: no tensor, no orientation needed to know ω
///   symmetric top  turns about L and about its own axis at constant rates: sines only
///   full body      the equation of motion, or elliptic functions
///
/// (A body whose orientation nobody asks for needs none of them: a Particle will do.)
/// Source: Landau & Lifshitz, "Mechanics" (1976), §33 and §37.

#include <cmath>

#include "tumble/body/rigid_body.hpp"
#include "tumble/core/require.hpp"
#include "tumble/mass/principal_axes.hpp"

namespace tumble {

enum class Model { ball, symmetric_top, full_body };

/// A body's moments sorted for its model: the odd one out and the mean of the two that are equal.
struct SymmetricMoments {
  double axial;       ///< C, about the axis of symmetry [kg m²]
  double transverse;  ///< A, about any axis across it [kg m²]
  Vec3 axis;          ///< unit vector of the axis of symmetry, body coordinates
  double asymmetry;   ///< |difference of the two nearly equal moments| / A: 0 for a true top
};

/// The symmetric top that is nearest to a body.
inline SymmetricMoments nearest_symmetric_top(const PrincipalAxes& p) {
  const double low = p.moments[1] - p.moments[0], high = p.moments[2] - p.moments[1];
  const int odd = low < high ? 2 : 0;  // the axis of the moment that has no equal
  const double a = p.moments[1], b = p.moments[odd == 2 ? 0 : 2];
  return {p.moments[odd], (a + b) / 2, p.R.col(odd), std::abs(a - b) / ((a + b) / 2)};
}
inline SymmetricMoments nearest_symmetric_top(const RigidBody<>& body) {
  return nearest_symmetric_top(principal_axes(body.I_body()));
}

/// The simplest model that tells the body's turning.
/// @param tolerance relative difference of moments that counts as none; its angle grows as
///                  tolerance · |ω| · t, so choose it for the time span
/// @throws std::invalid_argument if the tolerance is negative or not finite
inline Model choose_model(const RigidBody<>& body, double tolerance) {
  require(tolerance >= 0 && std::isfinite(tolerance), "choose_model: the tolerance is ", tolerance);
  const SymmetricMoments top = nearest_symmetric_top(body);
  if (top.asymmetry > tolerance) return Model::full_body;
  const bool ball = std::abs(top.axial - top.transverse) <= tolerance * top.transverse;
  return ball ? Model::ball : Model::symmetric_top;
}

}  // namespace tumble
