#pragma once

#include "tumble/simulate/first_event.hpp"

#include <stdexcept>

#include "tumble/core/compiled.hpp"
#include "tumble/core/require.hpp"

namespace tumble::detail {

TUMBLE_BODY double require_number(double g, double t) {
  if (std::isnan(g))
    throw_error<std::runtime_error>("the function of an event is not a number at t = ", t);
  return g;
}

TUMBLE_BODY std::optional<double> nearest_to_zero(const std::array<Look, 3>& looks) {
  const auto& [a, b, c] = looks;
  const double side = std::signbit(a.g) ? -1 : 1, span = c.t - a.t;
  const double rise = side * (b.g - a.g) / (b.t - a.t),
               next_rise = side * (c.g - b.g) / (c.t - b.t);
  const double curve = (next_rise - rise) / span;
  const double t = (a.t + b.t - rise / curve) / 2;
  if (!(curve > 0 && t > std::min(a.t, c.t) && t < std::max(a.t, c.t))) return {};
  constexpr double doubt = 0.25;  // of how far the parabola bends
  const double least = side * a.g + (t - a.t) * (rise + curve * (t - b.t));
  return least <= doubt * curve * span * span ? std::optional(t) : std::nullopt;
}

}  // namespace tumble::detail
