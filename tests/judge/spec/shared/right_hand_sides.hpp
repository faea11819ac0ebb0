#pragma once
/// @file
/// What the steps of chapters 1 and 2 are tried on, and how their evaluations are looked at.

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "01_particles/contract.hpp"
#include "judge/spec/spec.hpp"

namespace right_hand_sides {

using Eigen::VectorXd;
using particles::Rhs;
using namespace tumble::judge;

inline double size_of(const VectorXd& v) {
  return v.size() == 0 ? 0 : v.cwiseAbs().maxCoeff<Eigen::PropagateNaN>();
}

/// A state of `count` numbers, uniform in [−size, size).
inline VectorXd any_state(int count, double size = 2) {
  VectorXd y(count);
  for (double& number : y) number = any_number(-size, size);
  return y;
}

// A judge looks at old questions again when it searches for a name: a right-hand side must hold all
// that it needs by value.

/// How strongly the components of coupled() are driven by the next one, by the clock, and damped.
struct Coupling {
  double a, b, c;
};
inline Coupling any_coupling() {
  return {any_number(0.5, 1), any_number(0.5, 1), any_number(0.5, 1)};
}

/// A right-hand side that gives every mistake away: it depends on the time, is not linear, and each
/// component is driven by the next one. It is defined for states of any size; |f| ≤ 2 + |y|,
/// |∂f/∂y| ≤ 3 and |∂f/∂t| ≤ 2.
inline Rhs coupled(const Coupling& coupling) {
  return [coupling](double t, const VectorXd& y) {
    const auto& [a, b, c] = coupling;
    VectorXd ydot(y.size());
    for (Eigen::Index i = 0; i < y.size(); ++i) {
      const auto place = static_cast<double>(i);
      const double next = y[(i + 1) % y.size()];
      ydot[i] =
          a * std::sin(next + place) + b * std::cos(2 * t + place) * std::cos(y[i]) - c * y[i];
    }
    return ydot;
  };
}
inline Rhs any_rhs() { return coupled(any_coupling()); }

/// What rounding may do to a number of a step of any_rhs() with |h| ≤ ½ and |t| ≤ 3. Every state on
/// the way is at most 2 (1 + |y|). A stage is off by 3 roundings of that and by h times what the
/// slope before is off; a slope is off by 3 times as much and by some 20 roundings of its own
/// terms, which are at most 4 + 2 |y|. After four stages that is less than 128 eps (2 + |y|).
inline double rounding(const VectorXd& y) { return 128 * eps * (2 + size_of(y)); }

/// y' = λ y.
inline Rhs growth(double lambda) {
  return [lambda](double, const VectorXd& y) -> VectorXd { return lambda * y; };
}

/// y' = c, whatever t and y.
inline Rhs constant_slope(const VectorXd& c) {
  return [c](double, const VectorXd&) { return c; };
}

/// f, which is defined for states of `count` numbers only, made safe: a student's code may ask with
/// any other number of them.
template <class F>
auto of_size(Eigen::Index count, F f) {
  return [count, f](double t, const VectorXd& y) {
    if (y.size() != count)
      throw Malformed("the right-hand side of a state of " + std::to_string(count) +
                      " numbers was asked with " + std::to_string(y.size()));
    return f(t, y);
  };
}

/// y = (x, v) under the acceleration g.
inline Rhs free_fall(double g) {
  return of_size(2, [g](double, const VectorXd& y) { return Eigen::Vector2d(y[1], g); });
}

/// y' = −2 t y², which 1/(1 + t²) solves.
inline Rhs hill_slope() {
  return [](double t, const VectorXd& y) -> VectorXd { return -2 * t * y.cwiseAbs2(); };
}
inline VectorXd hill(double t) { return VectorXd::Constant(1, 1 / (1 + t * t)); }

/// The last answer of `count` steps along the hill, from `t` to t + 1, each one from where the one
/// before has come to.
template <class Step>
auto climb(const Step& step, double t, int count) {
  const double h = 1. / count;
  auto answer = step(hill_slope(), t, hill(t), h);
  for (int n = 1; n < count; ++n) answer = step(hill_slope(), t + n * h, answer.value(), h);
  return answer;
}

/// The order seen at h and h/2: log₂ of how much smaller the error has become.
inline double order_from(double error, double error_of_half) {
  return std::log2(error / error_of_half);
}

/// Where the right-hand side was evaluated.
struct Place {
  double t;
  VectorXd y;
};

/// "f is evaluated at the right places": by how much the n-th evaluation misses `place`.
template <class Answer>
double missed_by(const Answer& answer, std::size_t n, const Place& place) {
  const auto& arguments = answer.evaluations()[n].arguments;
  const auto y = from_value<VectorXd>(arguments[1]);
  if (y.size() != place.y.size()) return std::numeric_limits<double>::infinity();
  return worse(std::abs(from_value<double>(arguments[0]) - place.t), size_of(y - place.y));
}

/// 0 if f was evaluated that often.
template <class Answer>
Obeys evaluated(const Answer& answer, std::size_t times, const std::string& in_words) {
  const auto count = static_cast<double>(answer.evaluations().size());
  return obeys("f is evaluated exactly " + in_words, std::abs(count - static_cast<double>(times)),
               0);
}

}  // namespace right_hand_sides
