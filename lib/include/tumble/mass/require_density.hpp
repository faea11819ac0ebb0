#pragma once
/// @file
/// What a density must be before mass properties mean anything.

#include <cmath>

#include "tumble/core/require.hpp"

namespace tumble {

/// @addtogroup mass
/// @{

/// Refuses a density that nothing has.
/// @throws std::invalid_argument if the density is not positive and finite
inline void require_density(double density) {
  require(density > 0 && std::isfinite(density), "the density ", density,
          " kg/m³ is not positive and finite");
}

/// @}

}  // namespace tumble
