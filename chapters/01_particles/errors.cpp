/// @file
/// How the error of a revolution falls with the step, and what it costs.

#include <cmath>
#include <string>
#include <vector>

#include "parts.hpp"
#include "revolutions.hpp"
#include "support/plot.hpp"

namespace particles_chapter {

using support::error_number;
using support::number;

namespace {

/// The state a tenth of a revolution on, where nothing is symmetrical.
Orbit on_the_way(const Orbit& from, double time) {
  return integrate_adaptive<Dop853>(rhs_from_c(satellite), from, 0, time, {1e-14, 1e-9}).y;
}

/// How the error of one step, and of one revolution, falls with the step.
template <class Method>
std::vector<std::string> local_and_global(const std::string& name) {
  const Orbit start = on_the_way(at_perigee(), period() / 10);
  std::vector<double> steps, local, global;
  for (const int count : {1024, 2048, 4096}) {
    const double h = period() / count;
    steps.push_back(h);
    // Of one long step: the error of a short one would be lost in rounding.
    const Orbit one = Method::step(rhs_from_c(satellite), 0., start, 16 * h);
    local.push_back(distance(one, on_the_way(start, 16 * h)));
    global.push_back(distance(after<Method>(1, count), at_perigee()));
  }
  return {name,
          error_number(local[0]) + " m",
          error_number(local[1]) + " m",
          number(runge_kutta::observed_order(steps, local), 3),
          error_number(global[0]) + " m",
          error_number(global[1]) + " m",
          number(runge_kutta::observed_order(steps, global), 3)};
}

template <class Method>
support::Series error_curve(const std::string& name) {
  support::Series series{name, {}, {}};
  for (int steps = 1 << 17; steps >= 64; steps /= 2) {
    series.x.push_back(period() / steps);
    series.y.push_back(distance(after<Method>(1, steps), at_perigee()));
  }
  return series;
}

/// The evaluations that bring the error of a revolution down to `allowed` [m]: between two runs the
/// curve is taken for a straight line on logarithmic axes, and beyond the longest error = C hᵖ is
/// believed.
template <class Method>
double price(double allowed, int evaluations) {
  int steps = 32;
  double coarse = 0, error = distance(after<Method>(1, steps), at_perigee());
  while (error > allowed && steps < 1 << 18) {
    coarse = error;
    error = distance(after<Method>(1, steps *= 2), at_perigee());
  }
  const double order = error > allowed ? Method::order : std::log2(coarse / error);
  return evaluations * steps * std::pow(error / allowed, 1 / order);
}

}  // namespace

Table order_table() {
  Table table({"method", "a step of 1/64 turn", "of 1/128", "order", "a turn in 1024 steps",
               "in 2048", "order"});
  for_each_method([&](const std::string& name, auto method, int) {
    table.add(local_and_global<decltype(method)>(name));
  });
  return table;
}

std::string error_figure() {
  support::Plot plot{"error after one revolution",
                     {"step h [s]", support::Scale::log},
                     {"distance from where it should be [m]", support::Scale::log},
                     {}};
  for_each_method([&](const std::string& name, auto method, int) {
    plot.series.push_back(error_curve<decltype(method)>(name));
  });
  return support::to_svg(plot);
}

Table price_table() {
  Table table({"error of one revolution", "Euler", "midpoint", "RK4"});
  for (const double allowed : {1e5, 1e4, 1e3, 1e2, 1e1, 1e0}) {
    std::vector<std::string> row{
        (allowed < km ? number(allowed) + " m" : number(allowed / km) + " km")};
    for_each_method([&](const std::string&, auto method, int evaluations) {
      row.push_back(count(price<decltype(method)>(allowed, evaluations), 2));
    });
    table.add(row);
  }
  return table;
}

}  // namespace particles_chapter
