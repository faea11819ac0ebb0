#pragma once
/// @file
/// The order a method is seen to have: error = C hᵖ is a line of slope p on logarithmic axes.
///
///     p = Σ (xᵢ − x̄)(yᵢ − ȳ) / Σ (xᵢ − x̄)²,   xᵢ = log hᵢ, yᵢ = log errorᵢ
///
/// Source: least squares; LeVeque, "Finite Difference Methods for Ordinary and Partial Differential
/// Equations" (2007), A.6.

#include <algorithm>
#include <cmath>
#include <span>

#include "tumble/core/require.hpp"

namespace tumble::runge_kutta {

/// @addtogroup ode
/// @{

/// The slope of log error against log h, by least squares.
/// @param h      steps, positive, at least two different ones
/// @param errors error at each step, positive
/// @throws std::invalid_argument if the lists are not that
inline double observed_order(std::span<const double> h, std::span<const double> errors) {
  require(h.size() == errors.size(), "observed_order: ", h.size(), " steps but ", errors.size(),
          " errors");
  require(h.size() >= 2, "observed_order: ", h.size(), " points make no line");
  const auto [smallest, largest] = std::minmax_element(h.begin(), h.end());
  require(*smallest != *largest, "observed_order: all steps are ", h[0], ", so there is no slope");
  double x_mean = 0, y_mean = 0;
  for (std::size_t i = 0; i < h.size(); ++i) {
    require(h[i] > 0 && std::isfinite(h[i]), "observed_order: step ", i, " is ", h[i],
            ", not positive and finite");
    require(errors[i] > 0 && std::isfinite(errors[i]), "observed_order: error ", i, " is ",
            errors[i], ", not positive and finite");
    x_mean += std::log(h[i]) / static_cast<double>(h.size());
    y_mean += std::log(errors[i]) / static_cast<double>(h.size());
  }

  double xx = 0, xy = 0;
  for (std::size_t i = 0; i < h.size(); ++i) {
    const double x = std::log(h[i]) - x_mean;
    xx += x * x;
    xy += x * (std::log(errors[i]) - y_mean);
  }
  return xy / xx;
}

/// @}

}  // namespace tumble::runge_kutta
