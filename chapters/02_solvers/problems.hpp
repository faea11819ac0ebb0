#pragma once
/// @file
/// The problems of chapter 2: a comet, a speck of dust, an oscillator and a pendulum on a rod.

#include <cmath>
#include <numbers>
#include <string>

#include "support/table.hpp"
#include "tumble/ode/rhs.hpp"

namespace solvers_chapter {

using namespace tumble;

using Vec2 = Eigen::Vector2d;
using Vec4 = Eigen::Vector4d;  ///< place and velocity in a plane

constexpr double pi = std::numbers::pi;

/// dy/dt of a body that the sun attracts, in AU and years.
struct SunsPull {
  Vec4 operator()(double, const Vec4& y) const {
    constexpr double gm = 4 * pi * pi;  // [AU³/a²]
    const double r2 = y[0] * y[0] + y[1] * y[1];
    const double pull = -gm / (r2 * std::sqrt(r2));
    return {y[2], y[3], pull * y[0], pull * y[1]};
  }
};

/// An ellipse about the sun, which is in a focus, at the origin.
struct Orbit {
  double a;  ///< half the long axis [AU]
  double e;  ///< eccentricity

  double period() const { return a * std::sqrt(a); }  // [a]

  /// The state t years after the farthest point, by Kepler's equation E − e sin E = M.
  Vec4 at(double t) const {
    const double n = 2 * pi / period(), M = pi + n * t;
    double E = M;
    for (int i = 0; i < 50; ++i) E -= (E - e * std::sin(E) - M) / (1 - e * std::cos(E));
    const double b = a * std::sqrt(1 - e * e), rate = n / (1 - e * std::cos(E));
    return {a * (std::cos(E) - e), b * std::sin(E), -a * std::sin(E) * rate,
            b * std::cos(E) * rate};
  }
};

constexpr Orbit comet{17.83, 0.967};  // that of Halley's comet in 1994 (JPL), rounded
constexpr Orbit mild{1, 0.3};         // equal steps are not too bad here

/// The wind in a row of whirls of 1 m, each turning against its neighbours [m/s].
inline Vec2 wind(const Vec2& x) {
  constexpr double speed = 0.5;
  return {speed * std::sin(pi * x[0]) * std::cos(pi * x[1]),
          -speed * std::cos(pi * x[0]) * std::sin(pi * x[1])};
}

/// dy/dt of a speck that drifts with the wind.
struct Dust {
  double tau;  ///< in this time its difference from the wind falls to 1/e [s]

  Vec4 operator()(double, const Vec4& y) const {
    const Vec2 x = y.head<2>(), v = y.tail<2>();
    const Vec2 acceleration = (wind(x) - v) / tau;
    return {v[0], v[1], acceleration[0], acceleration[1]};
  }
};

/// τ = 2 ρ r²/(9 η), of a grain of quartz in air.
inline Dust dust_of_radius(double radius) {
  constexpr double density = 2650, viscosity = 1.8e-5;  // [kg/m³], [Pa s]
  return {2 * density * radius * radius / (9 * viscosity)};
}

/// Let go at the wind's own speed.
inline Vec4 dust_start() {
  const Vec2 x(0.5, 0.2), v = wind(x);
  return {x[0], x[1], v[0], v[1]};
}

constexpr double dust_time = 10;  // [s]

/// The van der Pol oscillator: y'' = μ (1 − y²) y' − y.
struct VanDerPol {
  double mu;

  Vec2 operator()(double, const Vec2& y) const {
    return {y[1], mu * (1 - y[0] * y[0]) * y[1] - y[0]};
  }

  /// The eigenvalue of the Jacobian at y that lies farthest to the left, or 0 if that is no real
  /// negative number.
  double fastest_decay(const Vec2& y) const {
    const double trace = mu * (1 - y[0] * y[0]), determinant = 2 * mu * y[0] * y[1] + 1;
    const double inside = trace * trace / 4 - determinant;
    return inside < 0 ? 0 : std::min(0.0, trace / 2 - std::sqrt(inside));
  }
};

constexpr double gravity = 9.81;  // [m/s²]

/// A weight of 1 kg on a rod of 1 m, which is a critically damped spring of stiffness k [N/m].
struct RodInXY {
  double k;

  Vec4 operator()(double, const Vec4& y) const {
    const Vec2 x = y.head<2>(), v = y.tail<2>();
    const double r = x.norm();
    const Vec2 n = x / r;
    const double tension = k * (r - 1) + 2 * std::sqrt(k) * n.dot(v);
    return {v[0], v[1], -tension * n[0], -tension * n[1] - gravity};
  }
};

/// The same weight by its angle from below, its rod's stretch, and their rates.
struct RodInAngle {
  double k;

  Vec4 operator()(double, const Vec4& y) const {
    const double r = 1 + y[1], turning = y[2], stretching = y[3];
    return {turning, stretching, (-gravity * std::sin(y[0]) - 2 * stretching * turning) / r,
            r * turning * turning + gravity * std::cos(y[0]) - k * y[1] -
                2 * std::sqrt(k) * stretching};
  }
};

/// Two digits of a ratio, without a power of ten.
inline std::string ratio_number(double ratio) {
  double unit = 1;
  while (ratio >= 100 * unit) unit *= 10;
  return ratio < 10 ? support::number(ratio, 2)
                    : std::to_string(std::lround(unit * std::round(ratio / unit)));
}

using support::error_or_rounding;

}  // namespace solvers_chapter
