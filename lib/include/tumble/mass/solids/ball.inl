#pragma once

#include "tumble/mass/solids/ball.hpp"

#include <numbers>

#include "tumble/core/compiled.hpp"

namespace tumble {

TUMBLE_BODY MassProperties mass_properties(const Ball& ball, double density) {
  detail::require_positive(density, "the density");
  detail::require_positive(ball.radius, "the ball's radius");
  const double r = ball.radius, mass = density * (4 * std::numbers::pi / 3 * r * r * r);
  const double I = 0.4 * mass * r * r;
  return detail::symmetric_body(mass, 0, I, I, I);
}

}  // namespace tumble
