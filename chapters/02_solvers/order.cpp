/// @file
/// The order that a method is seen to have.

#include <cmath>

#include "mild_orbit.hpp"
#include "parts.hpp"
#include "problems.hpp"
#include "support/plot.hpp"
#include "tumble/ode.hpp"

namespace solvers_chapter {

using support::error_number;
using support::number;

// ── Observed order ──

namespace {

/// What Richardson makes of the ends after n and 2n steps.
Vec4 extrapolated(const Vec4& coarse, const Vec4& fine, int order) {
  return fine + (fine - coarse) / (std::pow(2.0, order) - 1);
}

double order_of(double coarse, double fine) {
  const std::array<double, 2> h{2, 1}, errors{coarse, fine};
  return runge_kutta::observed_order(h, errors);
}

}  // namespace

Table order_table() {
  Table table(
      {"method", "order", "steps", "error", "with exact", "without", "Richardson", "its order"});
  const auto add = [&]<class Method>(const std::string& name, int n, Method) {
    const Vec4 y1 = mild_end<Method>(n), y2 = mild_end<Method>(2 * n), y4 = mild_end<Method>(4 * n);
    const Vec4 better2 = extrapolated(y1, y2, Method::order),
               better4 = extrapolated(y2, y4, Method::order);
    table.add({name, std::to_string(Method::order), std::to_string(4 * n),
               error_number(mild_error(y4)), number(order_of(mild_error(y2), mild_error(y4)), 3),
               number(order_of((y1 - y2).norm(), (y2 - y4).norm()), 3),
               error_number(mild_error(better4)),
               number(order_of(mild_error(better2), mild_error(better4)), 3)});
  };
  add("Euler", 4096, runge_kutta::Euler{});
  add("midpoint", 1024, runge_kutta::Midpoint{});
  add("RK4", 128, Rk4{});
  add("DP 5(4)", 24, DormandPrince54{});
  add("DOP853", 8, Dop853{});
  add("backward Euler", 4096, runge_kutta::BackwardEuler{});
  add("Radau5", 32, Radau5{});
  return table;
}

std::string order_figure() {
  support::Plot plot{"four tenths of a mild orbit",
                     {"step [a]", support::Scale::log},
                     {"error at the end", support::Scale::log},
                     {}};
  const auto add = [&]<class Method>(const std::string& name, int most, Method) {
    support::Series series{name, {}, {}};
    for (int steps = most; steps >= 4; steps /= 2) {
      try {
        const double error = mild_error(mild_end<Method>(steps));
        if (!(error < 100)) continue;
        series.x.push_back(order_time / steps);
        series.y.push_back(error);
      } catch (const std::runtime_error&) {
        continue;
      }
    }
    std::reverse(series.x.begin(), series.x.end());
    std::reverse(series.y.begin(), series.y.end());
    plot.series.push_back(series);
  };
  constexpr int most = 1 << 16;
  add("Euler", most, runge_kutta::Euler{});
  add("midpoint", most, runge_kutta::Midpoint{});
  add("RK4", most, Rk4{});
  add("DP 5(4)", most, DormandPrince54{});
  add("DOP853", most / 4, Dop853{});
  return support::to_svg(plot);
}

}  // namespace solvers_chapter
