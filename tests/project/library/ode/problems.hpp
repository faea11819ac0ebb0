#pragma once
/// @file
/// Problems y' = f(t, y) with a known solution, and the error of a method on them.

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "project/harness/inputs.hpp"
#include "tumble/ode.hpp"

namespace tumble::test {

template <class T>
using Vector1 = Eigen::Matrix<T, 1, 1>;
template <class T>
using Vector2 = Eigen::Matrix<T, 2, 1>;
template <class T>
using Vector4 = Eigen::Matrix<T, 4, 1>;

/// y' = −2 t y², y(0) = 1: y = 1/(1 + t²). Nonlinear, and f depends on t.
template <class T>
struct Rational {
  using State = Vector1<T>;
  static constexpr const char* name = "y' = -2 t y^2";
  static State start() { return State(T(1)); }
  static constexpr T end = 1;
  static State exact() { return State(T(1) / 2); }
  State operator()(T t, const State& y) const { return State(-2 * t * y[0] * y[0]); }
};

/// A planet on an ellipse of eccentricity ¼, y = (x, y, vx, vy), from its perihelion
/// to its aphelion.
template <class T>
struct Kepler {
  using State = Vector4<T>;
  static constexpr const char* name = "Kepler";
  static State start() { return {T(0.75), T(0), T(0), std::sqrt(T(5) / 3)}; }
  static constexpr T end = std::numbers::pi_v<T>;
  static State exact() { return {T(-1.25), T(0), T(0), -std::sqrt(T(3) / 5)}; }
  State operator()(T, const State& y) const {
    const T r = std::hypot(y[0], y[1]), r3 = r * r * r;
    return {y[2], y[3], -y[0] / r3, -y[1] / r3};
  }
};

/// What the function throws, as text; empty if it throws nothing of this kind.
template <class Exception, class F>
std::string message_of(F&& f) {
  try {
    f();
  } catch (const Exception& e) {
    return e.what();
  }
  return {};
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace tumble::test
