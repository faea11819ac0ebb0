#pragma once

#include "tumble/core/compiled.hpp"
#include "tumble/mass/moments.hpp"

namespace tumble {

TUMBLE_BODY MassProperties mass_properties(const Moments<simd::DoubleDouble>& m,
                                           const Vec3& reference, double density) {
  using T = simd::DoubleDouble;
  const Vector3<T> c = detail::centre_from_reference(m);
  // ∫ (r − c)(r − c)ᵀ = ∫ r rᵀ − c ∫ rᵀ
  const T xx = m.xx - c.x() * m.x, yy = m.yy - c.y() * m.y, zz = m.zz - c.z() * m.z;
  const double xy = double(m.xy - c.x() * m.y), yz = double(m.yz - c.y() * m.z),
               zx = double(m.zx - c.z() * m.x);
  MassProperties result;
  result.mass = density * double(m.one);
  result.centre = detail::to_double(c + reference.cast<T>());
  // clang-format off
  result.inertia << double(yy + zz), -xy, -zx,
                    -xy, double(zz + xx), -yz,
                    -zx, -yz, double(xx + yy);
  // clang-format on
  result.inertia *= density;
  return result;
}

}  // namespace tumble
