#pragma once
/// @file
/// Revolutions of the satellite by each method, and how far it is then from where it should be.

#include <cmath>
#include <numbers>
#include <string>

#include "methods.hpp"
#include "satellite.hpp"
#include "support/table.hpp"

namespace particles_chapter {

constexpr double km = 1000;

inline double distance(const Orbit& a, const Orbit& b) { return (a - b).head<2>().norm(); }

/// After so many whole revolutions the satellite is where it was at the start.
template <class Method>
Orbit after(int revolutions, int steps) {
  return integrate_fixed<Method>(rhs_from_c(satellite), at_perigee(), 0, revolutions * period(),
                                 steps);
}

/// A number to so many digits, a large one filled with zeros.
inline std::string count(double value, int digits) {
  const double unit = std::pow(10, std::floor(std::log10(value)) + 1 - digits);
  return support::number(unit < 1 ? value : std::round(value / unit) * unit, unit < 1 ? digits : 7);
}

}  // namespace particles_chapter
