#pragma once

#include "tumble/core/compiled.hpp"
#include "tumble/mass/tetrahedron.hpp"

namespace tumble::detail {

TUMBLE_BODY Moments<simd::DoubleDouble> with_factors(Moments<simd::DoubleDouble> m) {
  const auto divide = [](simd::DoubleDouble& x, double factor) {
    x = x / simd::DoubleDouble(factor);
  };
  divide(m.one, 6);
  for (simd::DoubleDouble* first : {&m.x, &m.y, &m.z}) divide(*first, 24);
  for (simd::DoubleDouble* second : {&m.xx, &m.yy, &m.zz, &m.xy, &m.yz, &m.zx})
    divide(*second, 120);
  return m;
}

}  // namespace tumble::detail
