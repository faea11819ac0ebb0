#pragma once

#include "tumble/collide/first_contact.hpp"

#include <limits>

#include "tumble/core/compiled.hpp"

namespace tumble::collide {

TUMBLE_BODY double landing_time(double h, double v, double a) {
  constexpr double never = std::numeric_limits<double>::infinity();
  const double height = std::fmax(h, 0);
  const double square = v * v - 2 * a * height;
  if (a < 0 && v > 0) return (v + std::sqrt(square)) / -a;
  if (a >= 0 && (v >= 0 || square < 0)) return never;
  return height == 0 ? 0 : 2 * height / (std::sqrt(square) - v);
}

}  // namespace tumble::collide
