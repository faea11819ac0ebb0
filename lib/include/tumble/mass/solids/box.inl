#pragma once

#include "tumble/core/compiled.hpp"
#include "tumble/mass/solids/box.hpp"

namespace tumble {

TUMBLE_BODY MassProperties mass_properties(const Box& box, double density) {
  detail::require_positive(density, "the density");
  const Vec3 squares = box.bounds().sizes().cwiseAbs2();
  const double mass = density * box.size.prod();
  return detail::symmetric_body(mass, 0, mass * (squares.y() + squares.z()) / 12,
                                mass * (squares.z() + squares.x()) / 12,
                                mass * (squares.x() + squares.y()) / 12);
}

}  // namespace tumble
