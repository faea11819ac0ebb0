#pragma once
/// @file
/// The tumbling of the tour's last station: what is computed of it, and the film strip of it.

#include <string>
#include <vector>

#include "tour/tour.hpp"

namespace tumble::tour {

inline constexpr Spin flight_spin{6.283185307179586,
                                  0.01};  // one turn a second, nearly about the middle axis
constexpr double flight_time = 12;        // [s]
constexpr int moments = 1200;

struct Moment {
  double t;
  RigidBodyState<> state;
  Vec3 omega_principal;  ///< along the axes of the least, middle and largest moment [rad/s]
  double energy;         ///< [J]
};

/// The times when the spin along the middle axis changes its sign: half-way through each turnover.
std::vector<double> turnovers(const std::vector<Moment>& motion);

/// The body through its first turnover, and its angular velocity meanwhile.
std::string film_strip(const Subject& subject, const std::vector<Moment>& motion);

}  // namespace tumble::tour
