#pragma once
/// @file
/// A satellite on an ellipse about the Earth: its right-hand side and its start.
///
/// Source of the constants: IERS Conventions (2010), table 1.1: GM and equatorial radius of the
/// Earth.

#include <cmath>
#include <numbers>

#include "tumble/ode/c_interface.hpp"
#include "tumble/ode/euler.hpp"
#include "tumble/ode/integrate_fixed.hpp"
#include "tumble/ode/midpoint.hpp"
#include "tumble/ode/rk4.hpp"

namespace particles_chapter {

using namespace tumble;

constexpr double GM = 3.986004418e14;               // of the Earth [m³/s²]
constexpr double perigee = 7.0e6, apogee = 21.0e6;  // from the Earth's centre [m]

/// y = (x, y, vx, vy), in the plane of the orbit [m, m/s].
inline void satellite(double, const double y[], double ydot[]) {
  const double r = std::sqrt(y[0] * y[0] + y[1] * y[1]);
  ydot[0] = y[2];
  ydot[1] = y[3];
  ydot[2] = -GM * y[0] / (r * r * r);
  ydot[3] = -GM * y[1] / (r * r * r);
}

using Orbit = Eigen::Vector4d;

constexpr double semi_major_axis = (perigee + apogee) / 2;

/// Of one revolution [s].
inline double period() {
  return 2 * std::numbers::pi * std::sqrt(semi_major_axis * semi_major_axis * semi_major_axis / GM);
}

/// At the perigee, across the line to the Earth, as fast as the ellipse asks for.
inline Orbit at_perigee() {
  return {perigee, 0, 0, std::sqrt(GM * (2 / perigee - 1 / semi_major_axis))};
}

}  // namespace particles_chapter
