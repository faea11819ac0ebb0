/// @file
/// One step of each method as a picture.

#include <array>
#include <string>
#include <vector>

#include "methods.hpp"
#include "parts.hpp"
#include "support/sketch.hpp"

namespace particles_chapter {

using support::Vec2;

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
void draw_slope(support::Sketch& sketch, const Vec2& place) {
  const Vec2 at = drawn(place.x(), place.y());
  const Vec2 along = drawn(1, logistic(0, Scalar(place.y()))[0]).normalized() * 0.08;
  sketch.curve({drawn(0, logistic_start), at}, {"c3", 1, 0.5});
  sketch.curve({at - along, at + along}, {"c3", 3});
  sketch.dot(at, "c3", 3);
}

/// The names of the slopes, above all that is drawn.
void name_slopes(support::Sketch& sketch, const std::vector<Vec2>& places) {
  for (std::size_t i = 0; i < places.size(); ++i)
    sketch.words(drawn(places[i].x(), places[i].y()), i == 2 ? Vec2(-24, -7) : Vec2(7, 21),
                 "k" + std::string(subscripts[i]), "c3");
}

/// The axis of time, with the three moments at which a method may look.
void draw_time(support::Sketch& sketch) {
  sketch.arrow({0, 0}, {1.12 * long_step, 0}, {"faint", 1.2});
  const std::array<const char*, 3> names{"t", "t + h/2", "t + h"};
  for (std::size_t i = 0; i < 3; ++i) {
    const double t = long_step * static_cast<double>(i) / 2;
    sketch.curve({{t, -0.015}, {t, 0.015}}, {"faint", 1.2});
    sketch.words({t, 0}, {0, 19}, names[i], "ink", "middle");
  }
}

template <class Method>
void draw_step(support::Sketch& sketch, const std::string& name) {
  const Scalar end = Method::step(logistic, 0., Scalar(logistic_start), long_step);
  const Vec2 arrival = drawn(long_step, end[0]);
  draw_time(sketch);
  sketch.curve(exact_curve(), {"faint", 2.2});
  sketch.curve({drawn(0, logistic_start), arrival}, {colour_of(name), 1.6});
  const std::vector<Vec2> places = places_of<Method>();
  for (const Vec2& place : places) draw_slope(sketch, place);
  sketch.dot(arrival, colour_of(name), 4.5);
  name_slopes(sketch, places);
  sketch.words({0, 1.08}, {0, 0}, name, colour_of(name));
}

}  // namespace

std::string one_step_figure() {
  constexpr double panel = 232;
  support::Sketch sketch(3 * panel, 290, "One step of Euler, midpoint and RK4", 15);
  double x = 22;
  for_each_method([&](const std::string& name, auto method, int) {
    sketch.look({x, 250, 205});
    draw_step<decltype(method)>(sketch, name);
    x += panel;
  });
  return sketch.svg();
}

}  // namespace particles_chapter
