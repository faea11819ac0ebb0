#pragma once
/// @file
/// Balls of the sports as the air meets them, and one of them in flight.
///
/// Sources: mass and size from the rules of the sports (World Athletics, R&A and USGA, ITF, ITTF);
/// coefficients of drag from Mehta, "Aerodynamics of sports balls", Annual Review of Fluid
/// Mechanics 17 (1985) 151–189, of the tennis ball from Mehta, Alam & Subic, "Review of tennis ball
/// aerodynamics", Sports Technology 1 (2008) 7–16, and of a smooth sphere from Hoerner,
/// "Fluid-Dynamic Drag" (1965), chapter III.

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "methods.hpp"
#include "tumble/particles.hpp"

namespace particles_chapter {

constexpr double air = 1.225;  // density at sea level [kg/m³]
constexpr double g = 9.81;     // [m/s²]

/// A ball as the air meets it.
struct ThrownBall {
  std::string name;
  double mass, diameter, drag;  // [kg], [m], coefficient of drag

  /// ½ ρ c_d A [kg/m]
  double gamma() const { return air * drag * std::numbers::pi * diameter * diameter / 8; }
  /// Where drag carries the weight [m/s].
  double terminal_speed() const { return std::sqrt(mass * g / gamma()); }
};

inline const std::vector<ThrownBall> balls{{"shot", 7.26, 0.12, 0.47},
                                           {"golf ball", 0.0459, 0.0427, 0.25},
                                           {"tennis ball", 0.058, 0.067, 0.6},
                                           {"table-tennis ball", 0.0027, 0.040, 0.47}};

/// From the origin, upwards at 45°.
inline std::array<particles::Particle<double>, 1> thrown(double mass, double speed) {
  return {{{mass, Vec3::Zero(), Vec3(1, 0, 1).normalized() * speed}}};
}

inline auto flight(const ThrownBall& ball, double speed) {
  const particles::UniformGravity weight{{0, 0, -g}};
  const particles::QuadraticDrag drag{ball.gamma()};
  return particles::ParticleSystem(thrown(ball.mass, speed), weight, drag);
}

using Flight = Eigen::Matrix<double, 6, 1>;

}  // namespace particles_chapter
