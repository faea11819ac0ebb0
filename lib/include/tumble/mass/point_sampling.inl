#pragma once

#include "tumble/mass/point_sampling.hpp"

#include <cmath>

#include "tumble/core/compiled.hpp"

namespace tumble::detail {

TUMBLE_BODY double fourth_moment(const SampleSums& sums, const Moments<simd::DoubleDouble>& m,
                                 const Vec3& c) {
  const Vec3 first = {double(m.x), double(m.y), double(m.z)};
  const double q = double(m.xx + m.yy + m.zz), cc = c.squaredNorm();
  const double cr2 = c.x() * c.x() * double(m.xx) + c.y() * c.y() * double(m.yy) +
                     c.z() * c.z() * double(m.zz) + 2 * c.x() * c.y() * double(m.xy) +
                     2 * c.y() * c.z() * double(m.yz) + 2 * c.z() * c.x() * double(m.zx);
  // |r − c|² = |r|² − 2 c·r + |c|², squared and summed
  return sums.q2 + 4 * cr2 + double(m.one) * cc * cc - 4 * c.dot(sums.qr) + 2 * cc * q -
         4 * cc * c.dot(first);
}

TUMBLE_BODY sampling::SampledMassProperties from_samples(const SampleSums& sums, std::int64_t n,
                                                         const Vec3& middle, double weight) {
  const Moments<simd::DoubleDouble> m = sums.moments.total();
  sampling::SampledMassProperties result{mass_properties(m, middle, weight)};
  const double inside = double(m.one), total = static_cast<double>(n);
  result.points = n;
  result.inside = static_cast<std::int64_t>(inside);
  result.mass_standard_error = weight * std::sqrt(inside * (1 - inside / total));
  // Σ |r − c|² = ½ tr I / weight; the centre is a mean over the points inside.
  result.centre_standard_error = std::sqrt(result.inertia.trace() / 2 / weight) / inside;
  // ‖|r|² 1 − r rᵀ‖² = 2 |r|⁴
  const double squares = 2 * fourth_moment(sums, m, result.centre - middle);
  const double mean = (result.inertia / weight).squaredNorm() / total;
  result.inertia_standard_error = weight * std::sqrt(std::max(0.0, squares - mean));
  return result;
}

}  // namespace tumble::detail
