#pragma once
/// @file
/// An error estimate that can be trusted for points that are not independent: from how far the
/// results of several sets of points are apart.
///
/// k sets that are right on average and independent of each other have results with a mean of
/// standard error s/√k, s² = Σ |result − mean|²/(k − 1). From 10 sets it is itself known to about
/// 1/√18 = 24 %. Source: L'Ecuyer & Lemieux, "Recent advances in randomized quasi-Monte Carlo
/// methods", in: Modeling Uncertainty (2002).

#include <vector>

#include "tumble/mass/point_sampling.hpp"
#include "tumble/mass/transform.hpp"

namespace tumble::detail {

/// Σ |value(set) − mean|²/(k (k − 1)), square-rooted: the standard error of the mean of k sets.
template <class Value>
double standard_error_of_mean(const std::vector<sampling::SampledMassProperties>& sets,
                              const Value& value) {
  const auto k = static_cast<double>(sets.size());
  auto mean = value(sets.front());
  mean.setZero();
  for (const sampling::SampledMassProperties& set : sets) mean += value(set) / k;
  double squares = 0;
  for (const sampling::SampledMassProperties& set : sets)
    squares += (value(set) - mean).squaredNorm();
  return std::sqrt(squares / (k * (k - 1)));
}

}  // namespace tumble::detail

namespace tumble::sampling {

/// @addtogroup mass
/// @{

/// Mass properties of a solid from all points of several sets together; the standard errors are
/// those of the differences between the sets.
/// @param solid   anything with contains() and bounds()
/// @param density [kg/m³]
/// @param sets    how many: 8 tell the error to a quarter
/// @param points  points(seed) gives one set, for seeds 1, 2, …, `sets`; as many points in each:
///                `[](std::uint64_t seed) { return sampling::StratifiedPoints(20, seed); }`
/// @throws std::invalid_argument if sets < 2, and as sample_mass_properties()
template <solids::Solid S, class MakePoints>
SampledMassProperties replicated_mass_properties(const S& solid, double density, int sets,
                                                 MakePoints&& points) {
  require(sets >= 2, "the number of sets of points is ", sets, ", less than 2");
  std::vector<SampledMassProperties> all;
  for (int i = 1; i <= sets; ++i)
    all.push_back(sample_mass_properties(solid, density, points(static_cast<std::uint64_t>(i))));
  SampledMassProperties result = all.front();
  for (std::size_t i = 1; i < all.size(); ++i) {
    static_cast<MassProperties&>(result) = combine(result, all[i]);
    result.points += all[i].points;
    result.inside += all[i].inside;
  }
  result.mass /= sets;
  result.inertia /= sets;
  using Error = SampledMassProperties;
  using Mass = Eigen::Matrix<double, 1, 1>;
  result.mass_standard_error =
      detail::standard_error_of_mean(all, [](const Error& set) { return Mass(set.mass); });
  result.centre_standard_error =
      detail::standard_error_of_mean(all, [](const Error& set) { return set.centre; });
  result.inertia_standard_error =
      detail::standard_error_of_mean(all, [](const Error& set) { return set.inertia; });
  return result;
}

/// @}

}  // namespace tumble::sampling
