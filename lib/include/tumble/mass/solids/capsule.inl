#pragma once

#include "tumble/mass/solids/capsule.hpp"

#include <numbers>

#include "tumble/core/compiled.hpp"

namespace tumble {

TUMBLE_BODY MassProperties mass_properties(const Capsule& capsule, double density) {
  detail::require_positive(density, "the density");
  const double r = capsule.bounds().max().x(), r2 = r * r, h = capsule.height;
  const double cylinder = density * (std::numbers::pi * r2 * h);
  const double caps = density * (4 * std::numbers::pi / 3 * r2 * r);
  const double across =
      cylinder * (3 * r2 + h * h) / 12 + caps * (0.4 * r2 + h * h / 4 + 0.375 * h * r);
  return detail::symmetric_body(cylinder + caps, 0, across, across,
                                cylinder * r2 / 2 + 0.4 * caps * r2);
}

}  // namespace tumble
