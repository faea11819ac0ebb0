/// @file
/// A stiff problem, and the step that does not care.

#include <cmath>

#include "drawing.hpp"
#include "parts.hpp"
#include "problems.hpp"
#include "support/plot.hpp"
#include "tumble/ode.hpp"

namespace solvers_chapter {

using support::error_number;
using support::number;

namespace {

constexpr Tolerances dust_tolerances{1e-6, 1e-6};

const std::vector<double> radii{100e-6, 30e-6, 10e-6, 3e-6, 1e-6};

std::string micrometres(double radius) { return number(1e6 * radius) + " µm"; }

template <class Method>
OdeSolution<Vec4> fly(double radius, const Tolerances& tolerances = dust_tolerances) {
  const Dust f = dust_of_radius(radius);
  return integrate_adaptive<Method>(f, dust_start(), 0.0, dust_time, tolerances);
}

/// Where the air itself goes.
Path streamline(const Vec2& from, double seconds) {
  Path path{from};
  integrate_fixed<Rk4>([](double, const Vec2& x) -> Vec2 { return wind(x); }, from, 0.0, seconds,
                       static_cast<int>(10 * seconds),
                       [&](double, const Vec2& x) { path.push_back(x); });
  return path;
}

}  // namespace

Table dust_table() {
  const auto steps = [](const OdeSolution<Vec4>& s) {
    return std::to_string(s.steps) + " + " + std::to_string(s.rejected);
  };
  Table table({"radius", "τ", "10 s / (3.3 τ)", "DP 5(4) steps", "Radau5 steps", "apart by"});
  for (const double radius : radii) {
    const auto explicit_one = fly<DormandPrince54>(radius);
    const auto implicit_one = fly<Radau5>(radius);
    const double tau = dust_of_radius(radius).tau;
    table.add({micrometres(radius), number(1000 * tau) + " ms",
               std::to_string(std::lround(dust_time / (3.3 * tau))), steps(explicit_one),
               steps(implicit_one),

               error_number((explicit_one.y - implicit_one.y).head<2>().norm()) + " m"});
  }
  return table;
}

Table indifferent_table() {
  Table table({"tolerance", "DP 5(4): kept", "rejected", "evaluations", "Radau5: kept", "rejected",
               "evaluations"});
  for (const double tolerance : {1e-2, 1e-4, 1e-6, 1e-8}) {
    const auto explicit_one = fly<DormandPrince54>(1e-6, {tolerance, tolerance});
    const auto implicit_one = fly<Radau5>(1e-6, {tolerance, tolerance});
    table.add({number(tolerance), std::to_string(explicit_one.steps),
               std::to_string(explicit_one.rejected), std::to_string(explicit_one.evaluations),
               std::to_string(implicit_one.steps), std::to_string(implicit_one.rejected),
               std::to_string(implicit_one.evaluations)});
  }
  return table;
}

std::string dust_figure() {
  support::Sketch sketch(760, 452, "specks of dust in the wind");
  look_at(sketch, {{-1.03, -0.02}, {2.03, 2.02}, 10, 10, 210});
  for (const double x : {-0.5, 0.5, 1.5})
    for (const double y : {0.5, 1.5})
      for (const double r : {0.1, 0.2, 0.3, 0.4, 0.47})
        sketch.curve(streamline({x, y - r}, r < 0.45 ? 5 + 5 * r : 11), {"faint", 1, 0.45});
  const std::vector<std::pair<double, std::string>> specks{
      {100e-6, "c1"}, {30e-6, "c3"}, {10e-6, "c2"}, {1e-6, "c0"}};
  double row = 50;  // of the names, right of the drawing [px]
  for (const auto& [radius, colour] : specks) {
    Track track;
    const auto solution = integrate_adaptive<Radau5>(dust_of_radius(radius), dust_start(), 0.0,
                                                     dust_time, dust_tolerances, track);
    sketch.curve(track.places, {colour, 1.6});
    sketch.dots(track.places, colour, 2.2);
    const Vec2 corner(2.03, 2.02);
    sketch.words(corner, {10, row}, micrometres(radius), colour);
    sketch.words(corner, {10, row + 21}, std::to_string(solution.steps) + " steps", colour);
    row += 60;
  }
  return sketch.svg();
}

std::string stiffness_figure() {
  support::Plot plot{"ten seconds of dust",
                     {"1/τ [1/s]", support::Scale::log},
                     {"evaluations of dydt", support::Scale::log},
                     {}};
  support::Series dp54{"DP 5(4)", {}, {}}, dop853{"DOP853", {}, {}}, radau{"Radau5", {}, {}};
  for (double radius = 100e-6; radius > 0.99e-6; radius /= std::sqrt(std::sqrt(10.0))) {
    for (support::Series* series : {&dp54, &dop853, &radau})
      series->x.push_back(1 / dust_of_radius(radius).tau);
    dp54.y.push_back(fly<DormandPrince54>(radius).evaluations);
    dop853.y.push_back(fly<Dop853>(radius).evaluations);
    radau.y.push_back(fly<Radau5>(radius).evaluations);
  }
  plot.series = {dp54, dop853, radau};
  return support::to_svg(plot);
}

// ── Implicit steps ──

Table newton_table() {
  const Dust dust = dust_of_radius(3e-6);
  const Vec4 y = fly<Radau5>(3e-6).y;
  constexpr double h = 0.1;
  std::vector<Vec4> tried;
  const auto watched = [&](double t, const Vec4& z) {
    tried.push_back(z);
    return dust(t, z);
  };
  const auto dfdy = [&](double t, const Vec4& z) {
    return detail::jacobian(dust, t, z, dust(t, z), h);
  };
  const Vec4 y1 = runge_kutta::backward_euler_step(with_jacobian(watched, dfdy), 0.0, y, h);

  Table table({"iteration", "fixed-point iteration", "Newton's method"});
  Vec4 z = y;
  for (std::size_t i = 0; i < tried.size(); ++i) {
    table.add({std::to_string(i), error_number((z - y1).norm()),
               error_or_rounding((tried[i] - y1).norm())});
    z = y + h * dust(h, z);
  }
  return table;
}

}  // namespace solvers_chapter
