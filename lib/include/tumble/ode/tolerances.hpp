#pragma once
/// @file
/// How exact a solution has to be, and how an error is measured against that.
///
///     ‖e‖ = √( 1/n Σ (eᵢ / (absolute + relative · max(|y0ᵢ|, |y1ᵢ|)))² ),   fine if ‖e‖ ≤ 1
///
/// Source: Hairer, Nørsett & Wanner, "Solving Ordinary Differential Equations I", 2nd ed. (1993),
/// eqs. II.4.10 and II.4.11.

#include <algorithm>
#include <cmath>

#include "tumble/core/require.hpp"
#include "tumble/ode/rhs.hpp"

namespace tumble {

/// @addtogroup ode
/// @{

/// The error allowed in one step: relative for large components, absolute for small ones.
struct Tolerances {
  double relative = 1e-6;
  double absolute = 1e-9;  ///< in the unit of the state's components
};

/// Refuses tolerances that no solver can keep.
/// @throws std::invalid_argument if one is not positive and finite, also as a `Scalar`
template <class Scalar = double>
void require_valid(const Tolerances& tolerances) {
  using std::isfinite;
  const auto valid = [](double tolerance) {
    const auto rounded = static_cast<Scalar>(tolerance);
    return isfinite(rounded) && rounded > 0;
  };
  require(valid(tolerances.relative), "tolerances: relative = ", tolerances.relative,
          " is not positive and finite");
  require(valid(tolerances.absolute), "tolerances: absolute = ", tolerances.absolute,
          " is not positive and finite");
}

/// @}

}  // namespace tumble

namespace tumble::runge_kutta {

/// @addtogroup ode
/// @{

/// The error of a step from y0 to y1 in units of what is allowed: root mean square over the
/// components, at most 1 if the step may be kept.
/// @return dimensionless; 0 for a state without components
template <OdeState State>
ScalarOf<State> error_norm(const State& error, const State& y0, const State& y1,
                           const Tolerances& tolerances) {
  using std::abs, std::max, std::sqrt;
  using Scalar = ScalarOf<State>;
  if (error.size() == 0) return Scalar(0);
  const auto absolute = static_cast<Scalar>(tolerances.absolute);
  const auto relative = static_cast<Scalar>(tolerances.relative);
  Scalar sum(0);
  for (Eigen::Index i = 0; i < error.size(); ++i) {
    const Scalar allowed = absolute + relative * max(abs(y0[i]), abs(y1[i]));
    const Scalar ratio = error[i] / allowed;
    sum += ratio * ratio;
  }
  return sqrt(sum / static_cast<Scalar>(error.size()));
}

/// @}

}  // namespace tumble::runge_kutta
