#pragma once
/// @file
/// The units of length that mesh files are written in.

#include <string>

#include "tumble/mass/error_bound.hpp"

namespace tumble::scenes {

/// A unit, as a fraction of the metre. No digit is lost in `above`⁵ and `below`⁵.
struct LengthUnit {
  double above = 1, below = 1;

  /// A length in metres, or several; rounded.
  template <class Length>
  Length in_metres(const Length& x) const {
    return x * above / below;
  }

  /// What is measured in this unit to a power, as lengths, areas and volumes are, in metres.
  simd::DoubleDouble in_metres(simd::DoubleDouble x, int power) const {
    for (int i = 0; i < power; ++i) x = x * above / below;
    return x;
  }
};

/// @param name mm, cm, m or in
inline LengthUnit length_unit(const std::string& name) {
  if (name == "mm") return {1, 1000};
  if (name == "cm") return {1, 100};
  if (name == "in") return {127, 5000};
  return {};
}

/// A body whose mesh has its lengths in a unit, in SI units. Coordinates in metres would be
/// rounded, and far from the origin the body with them; results are rounded once each.
/// @param dimensions of what has the mass: 3 of a solid, 2 of a shell
inline void convert_to_metres(MassProperties& body, const LengthUnit& unit, int dimensions) {
  body.mass = double(unit.in_metres(body.mass, dimensions));
  for (double& c : body.centre) c = double(unit.in_metres(c, 1));
  for (double& I : body.inertia.reshaped()) I = double(unit.in_metres(I, dimensions + 2));
}

/// The same of a solid, with its bounds.
inline void convert_to_metres(BoundedMassProperties& body, const LengthUnit& unit) {
  if (unit.above == unit.below) return;
  constexpr double once = 2 * detail::unit_roundoff, quotient = 32 * once * once;
  for (int k = 0; k < 3; ++k) {
    const simd::DoubleDouble c =
        unit.in_metres(simd::DoubleDouble(body.centre_rest[k]) + body.centre[k], 1);
    body.centre[k] = c.hi;
    body.centre_rest[k] = c.lo;
  }
  const Vec3 centre = body.centre;
  convert_to_metres(static_cast<MassProperties&>(body), unit, 3);
  body.centre = centre;
  body.mass_error_bound += once * (1 + body.mass_error_bound);
  body.centre_error_bound =
      (1 + once) * unit.in_metres(body.centre_error_bound) + quotient * centre.lpNorm<1>();
  body.inertia_error_bound += once * (1 + body.inertia_error_bound);
}

}  // namespace tumble::scenes
