#pragma once
/// @file
/// Mass properties of any solid by counting points: the integral of f is the mean of f over the
/// box, 0 outside the solid, times the box's volume.
///
/// The standard error of a mean of n independent values is σ/√n; 19 of 20 errors are below twice,
/// all but one in 10⁴ below four times that. So it is for random points. Stratified points never
/// scatter more, and less the more there are: for them it is a bound; what their error is, sets
/// with other seeds tell (replicated_sampling.hpp). Low-discrepancy points do better than it says
/// on every solid tried, without a proof. A grid does too, but where flat faces are parallel to its
/// planes it can do worse: a whole layer of points is inside or not. Source: e.g. Caflisch, "Monte
/// Carlo and quasi-Monte Carlo methods", Acta Numerica 7, 1998, §2; Owen, "Monte Carlo theory,
/// methods and examples" (2013), ch. 8 on stratified points.

#include "tumble/core/require.hpp"
#include "tumble/core/solid.hpp"
#include "tumble/mass/as_point.hpp"
#include "tumble/mass/moments.hpp"
#include "tumble/mass/require_density.hpp"
#include "tumble/mass/sample_points.hpp"

namespace tumble::sampling {

/// @addtogroup mass
/// @{

/// Mass properties and how far they may be off, as for random points (1 standard error).
struct SampledMassProperties : MassProperties {
  std::int64_t points = 0;            ///< how many were tried
  std::int64_t inside = 0;            ///< how many of them were in the solid
  double mass_standard_error = 0;     ///< [kg]
  double centre_standard_error = 0;   ///< of its distance from the truth [m]
  double inertia_standard_error = 0;  ///< of the Frobenius norm of its error [kg m²]
};

/// @}

}  // namespace tumble::sampling

namespace tumble::detail {

/// The sums over the points inside, r from the middle of the box.
struct SampleSums {
  BlockedMoments moments;
  double q2 = 0;           ///< Σ |r|⁴ [m⁴]
  Vec3 qr = Vec3::Zero();  ///< Σ |r|² r [m³]

  void add(const Vec3& r) {
    const double q = r.squaredNorm();
    moments.add(unit_moments(r));
    q2 += q * q;
    qr += q * r;
  }
};

/// Σ |r − c|⁴ over the points, from sums about another point than c.
double fourth_moment(const SampleSums& sums, const Moments<simd::DoubleDouble>& m, const Vec3& c);

/// Mass properties and standard errors from the sums.
/// @param weight the mass that each point stands for: density · box volume / n [kg]
sampling::SampledMassProperties from_samples(const SampleSums& sums, std::int64_t n,
                                             const Vec3& middle, double weight);

}  // namespace tumble::detail

namespace tumble::sampling {

/// @addtogroup mass
/// @{

/// Mass properties of a solid from points that are tried whether they are inside.
/// @param solid   anything with contains() and bounds()
/// @param density [kg/m³]
/// @param points  GridPoints, RandomPoints, StratifiedPoints or R3Points
/// @throws std::invalid_argument if the density is not positive and finite, the bounds are empty or
///         not finite, or no point fell inside
template <solids::Solid S, SamplePoints P>
SampledMassProperties sample_mass_properties(const S& solid, double density, P points) {
  require_density(density);
  const Eigen::AlignedBox3d box = solid.bounds();
  const Vec3 size = box.sizes(), middle = box.center();
  require(!box.isEmpty(), "the solid's bounds are empty: do the parts of an intersection meet?");
  require(size.minCoeff() > 0 && size.allFinite() && middle.allFinite(),
          "the solid's bounds are empty or not finite: from ", detail::AsPoint{box.min()}, " to ",
          detail::AsPoint{box.max()});
  const std::int64_t n = points.count();
  detail::SampleSums sums;
  for (std::int64_t i = 0; i < n; ++i) {
    const Vec3 r = (points.next() - Vec3::Constant(0.5)).cwiseProduct(size);
    if (solid.contains(middle + r)) sums.add(r);
  }
  require(double(sums.moments.total().one) > 0, "none of ", n,
          " points fell inside the solid within ", detail::AsPoint{box.min()}, " to ",
          detail::AsPoint{box.max()},
          ": take more points, or tighter bounds if it is much smaller than they are");
  return detail::from_samples(sums, n, middle, density * size.prod() / static_cast<double>(n));
}

/// @}

}  // namespace tumble::sampling

#ifndef TUMBLE_COMPILED
#include "tumble/mass/point_sampling.inl"
#endif
