#pragma once

#include "tumble/mass/error_bound.hpp"

#include "tumble/core/compiled.hpp"
#include "tumble/core/rounding.hpp"

namespace tumble::detail {

TUMBLE_BODY BoundedMassProperties bounded(const Moments<simd::DoubleDouble>& m,
                                          const Vec3& reference, double density,
                                          const IntegralErrors& errors) {
  const double volume = std::abs(double(m.one));
  BoundedMassProperties body{mass_properties(m, reference, density)};
  const Vector3<simd::DoubleDouble> offset = centre_from_reference(m);
  const Vector3<simd::DoubleDouble> rest =
      offset + reference.cast<simd::DoubleDouble>() - body.centre.cast<simd::DoubleDouble>();
  body.centre_rest = to_double(rest);
  const double c = to_double(offset).norm();
  const double relative = relative_to_true(errors.volume, volume);
  body.mass_error_bound = 2 * unit_roundoff * (1 + relative) + relative;
  // V d = E₁ − E₀ c: the centre's error d by those of ∫ r dV and V.
  const double rounding =
      8 * unit_roundoff * unit_roundoff * (to_double(offset).lpNorm<1>() + reference.lpNorm<1>());
  const double shift = (errors.first + c * errors.volume) / volume * (1 + relative);
  body.centre_error_bound = rounding + shift;
  // The same of ∫ r rᵀ dV − c ∫ rᵀ dV; and |tr(C) 1 − C| ≤ 2 |C|, |tr(C) 1 − C| ≥ 2/√3 tr(C) for
  // a C without negative eigenvalues.
  const double second = errors.second + 2 * c * errors.first + c * c * errors.volume +
                        (errors.first + c * errors.volume) * shift;
  const double size = std::abs(inertia_size(m));
  // What has lost digits next to the smallest double has lost them at any density.
  const double tensor = size < 0x1p-960 ? std::numeric_limits<double>::infinity()
                                        : relative_to_true(std::sqrt(3.0) * second, size);
  body.inertia_error_bound = 2 * unit_roundoff * (1 + tensor) + tensor;
  return body;
}

}  // namespace tumble::detail
