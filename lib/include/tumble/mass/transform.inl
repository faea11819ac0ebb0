#pragma once

#include "tumble/mass/transform.hpp"

#include "tumble/core/compiled.hpp"
#include "tumble/mass/as_point.hpp"
#include "tumble/mass/parallel_axis.hpp"

namespace tumble {

TUMBLE_BODY MassProperties scaled(const MassProperties& body, const Vec3& s) {
  require(s.minCoeff() > 0 && s.allFinite(), "the scale factors ", detail::AsPoint{s},
          " are not all positive and finite");
  const double volume = s.prod();
  // ∫ r rᵀ dm = ½ tr(I) 1 − I, and it stretches to det(D) D (∫ r rᵀ dm) D with D = diag(s).
  const Mat3 second = body.inertia.trace() / 2 * Mat3::Identity() - body.inertia;
  const Mat3 stretched = volume * (s.asDiagonal() * second * s.asDiagonal());
  return {volume * body.mass, s.cwiseProduct(body.centre),
          stretched.trace() * Mat3::Identity() - stretched};
}

TUMBLE_BODY MassProperties combine(const MassProperties& a, const MassProperties& b) {
  for (const double mass : {a.mass, b.mass})
    require(mass > 0 && std::isfinite(mass), "the mass ", mass, " kg is not positive and finite");
  const double mass = a.mass + b.mass;
  const Vec3 apart = b.centre - a.centre;
  // Both offsets from the common centre lie along `apart`: their sum is the reduced
  // mass at `apart`.
  const double reduced = a.mass * (b.mass / mass);
  return {mass, a.centre + (b.mass / mass) * apart,
          a.inertia + b.inertia + point_inertia(reduced, apart)};
}

TUMBLE_BODY MassProperties combine(std::span<const MassProperties> bodies) {
  require(!bodies.empty(), "there are no bodies to combine");
  MassProperties all = bodies[0];
  for (const MassProperties& body : bodies.subspan(1)) all = combine(all, body);
  return all;
}

}  // namespace tumble
