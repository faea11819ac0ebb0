/// @file
/// One step of each method as a picture, and the conditions that make a method's order.

#include <array>
#include <string>
#include <vector>

#include "hanging_net.hpp"
#include "methods.hpp"
#include "parts.hpp"
#include "support/sketch.hpp"
#include "tumble/ode/explicit_runge_kutta.hpp"

namespace particles_chapter {

using support::number;
using support::Vec2;

// ── The methods as tableaux ──

namespace {

/// One slope, at the start.
struct EulerTableau {
  static constexpr std::size_t stages = 1;
  static constexpr int order = 1;
  static constexpr runge_kutta::Weights<1> c{0}, b{1};
  static constexpr std::array<runge_kutta::Weights<1>, 1> a{};
};

/// Two slopes; the second, halfway, is the one that counts.
struct MidpointTableau {
  static constexpr std::size_t stages = 2;
  static constexpr int order = 2;
  static constexpr runge_kutta::Weights<2> c{0, 1 / 2.L}, b{0, 1};
  static constexpr std::array<runge_kutta::Weights<2>, 2> a{{{0}, {1 / 2.L}}};
};

/// The classical method of order four.
struct Rk4Tableau {
  static constexpr std::size_t stages = 4;
  static constexpr int order = 4;
  static constexpr runge_kutta::Weights<4> c{0, 1 / 2.L, 1 / 2.L, 1};
  static constexpr runge_kutta::Weights<4> b{1 / 6.L, 1 / 3.L, 1 / 3.L, 1 / 6.L};
  static constexpr std::array<runge_kutta::Weights<4>, 4> a{
      {{0}, {1 / 2.L}, {0, 1 / 2.L}, {0, 0, 1}}};
};

/// Kutta's other method of order four, with slopes at thirds of the step.
struct ThreeEighthsTableau {
  static constexpr std::size_t stages = 4;
  static constexpr int order = 4;
  static constexpr runge_kutta::Weights<4> c{0, 1 / 3.L, 2 / 3.L, 1};
  static constexpr runge_kutta::Weights<4> b{1 / 8.L, 3 / 8.L, 3 / 8.L, 1 / 8.L};
  static constexpr std::array<runge_kutta::Weights<4>, 4> a{
      {{0}, {1 / 3.L}, {-1 / 3.L, 1}, {1, -1, 1}}};
};

/// The sums of the eight conditions up to order four, in the order of the page.
template <runge_kutta::ButcherTableau T>
std::array<double, 8> condition_sums() {
  constexpr int s = T::stages;
  Eigen::Matrix<double, s, s> A;
  Eigen::Matrix<double, s, 1> b, c;
  for (int i = 0; i < s; ++i) {
    b[i] = static_cast<double>(T::b[static_cast<std::size_t>(i)]);
    c[i] = static_cast<double>(T::c[static_cast<std::size_t>(i)]);
    for (int j = 0; j < s; ++j)
      A(i, j) = static_cast<double>(T::a[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]);
  }
  const Eigen::Matrix<double, s, 1> cc = c.cwiseProduct(c), ccc = cc.cwiseProduct(c), Ac = A * c;
  return {b.sum(),       b.dot(c),     b.dot(cc), b.dot(Ac), b.dot(ccc), b.dot(c.cwiseProduct(Ac)),
          b.dot(A * cc), b.dot(A * Ac)};
}

}  // namespace

Table conditions_table() {
  const std::array<std::string, 8> sums{"Σ bᵢ",         "Σ bᵢ cᵢ",        "Σ bᵢ cᵢ²",
                                        "Σ bᵢ aᵢⱼ cⱼ",  "Σ bᵢ cᵢ³",       "Σ bᵢ cᵢ aᵢⱼ cⱼ",
                                        "Σ bᵢ aᵢⱼ cⱼ²", "Σ bᵢ aᵢⱼ aⱼₖ cₖ"};
  const std::array<int, 8> order{1, 2, 3, 3, 4, 4, 4, 4}, one_over{1, 2, 3, 6, 4, 8, 12, 24};
  const std::array all{condition_sums<EulerTableau>(), condition_sums<MidpointTableau>(),
                       condition_sums<Rk4Tableau>(), condition_sums<ThreeEighthsTableau>()};
  Table table({"for order", "sum", "must be", "Euler", "midpoint", "RK4", "3/8 rule"});
  for (std::size_t i = 0; i < sums.size(); ++i) {
    std::vector<std::string> row{number(order[i]), sums[i],
                                 one_over[i] == 1 ? "1" : "1/" + number(one_over[i])};
    for (const std::array<double, 8>& method : all)
      row.push_back(std::abs(method[i] * one_over[i] - 1) < 1e-14 ? "holds" : number(method[i], 3));
    table.add(row);
  }
  return table;
}

// ── One step, with its slopes ──

namespace {

using Scalar = Eigen::Matrix<double, 1, 1>;

/// Growth that meets a limit: a curve that bends both ways.
Scalar logistic(double, const Scalar& y) { return 3 * y.cwiseProduct(Scalar(1) - y); }

constexpr double logistic_start = 0.08, long_step = 0.8;
constexpr double stretch = 1.9;  // of the drawing, upwards

/// Where (t, y) is drawn.
Vec2 drawn(double t, double y) { return {t, stretch * y}; }

constexpr std::array<const char*, 4> subscripts{"₁", "₂", "₃", "₄"};

/// The places (t, y) at which a method looks at the slope.
template <class Method>
std::vector<Vec2> places_of() {
  std::vector<Vec2> places;
  const auto noted = [&](double t, const Scalar& y) {
    places.emplace_back(t, y[0]);
    return logistic(t, y);
  };
  Method::step(noted, 0., Scalar(logistic_start), long_step);
  return places;
}

std::vector<Vec2> exact_curve() {
  std::vector<Vec2> points{drawn(0, logistic_start)};
  integrate_fixed<Rk4>(logistic, Scalar(logistic_start), 0, long_step, 40,
                       [&](double t, const Scalar& y) { points.push_back(drawn(t, y[0])); });
  return points;
}

/// A place, the way to it from the start of the step, and the slope that is found there.
void draw_slope(support::Sketch& sketch, const Vec2& place, const std::string& name) {
  const Vec2 at = drawn(place.x(), place.y());
  const Vec2 along = drawn(1, logistic(0, Scalar(place.y()))[0]).normalized() * 0.08;
  sketch.curve({drawn(0, logistic_start), at}, {"c0", 1, 0.5});
  sketch.curve({at - along, at + along}, {"c0", 3});
  sketch.dot(at, "c0", 3);
  sketch.words(at, name == "k₃" ? Vec2(-24, -7) : Vec2(7, 21), name, "c0");
}

template <class Method>
void draw_step(support::Sketch& sketch, const std::string& name) {
  const Scalar end = Method::step(logistic, 0., Scalar(logistic_start), long_step);
  const Vec2 arrival = drawn(long_step, end[0]);
  sketch.curve(exact_curve(), {"faint", 2.2});
  sketch.curve({drawn(0, logistic_start), arrival}, {"c1", 1.4});
  std::size_t slope = 0;
  for (const Vec2& place : places_of<Method>())
    draw_slope(sketch, place, "k" + std::string(subscripts[slope++]));
  sketch.dot(arrival, "c1", 4.5);
  sketch.words({long_step / 2, 0}, {0, 26}, name, "ink", "middle");
}

}  // namespace

std::string one_step_figure() {
  constexpr double panel = 212;
  support::Sketch sketch(3 * panel, 290, "one step of Euler, midpoint and RK4");
  double x = 22;
  for_each_method([&](const std::string& name, auto method, int) {
    sketch.look({x, 250, 205});
    draw_step<decltype(method)>(sketch, name);
    x += panel;
  });
  return sketch.svg();
}

}  // namespace particles_chapter
