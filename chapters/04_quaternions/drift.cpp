/// @file
/// Four numbers and nine under the same steps.

#include "common.hpp"
#include "parts.hpp"
#include "rates.hpp"
#include "support/plot.hpp"
#include "tumble/ode.hpp"

namespace quaternions_chapter {

namespace {

/// What of a rotation q p q̄ is not: ‖RᵀR − 1‖ of the matrix |q|² R.
double shape_error(const Quat& q) {
  return std::sqrt(3.0) * std::abs(std::pow(q.squaredNorm(), 2) - 1);
}

template <class Method>
void add_drift(Table& table, const std::string& name, int seconds) {
  const int steps = 60 * seconds;
  const Quat exact = exp_quaternion<double>(omega * (h * steps));
  const auto four = rate_of_four<double>(steady);
  const Mat3 R =
      stepped<Method>(rate_of_nine<double>(steady), nine_start, h, steps, as_it_is).reshaped(3, 3);
  const Quat q = from_coefficients(stepped<Method>(four, four_start, h, steps, as_it_is));
  const Quat r = from_coefficients(stepped<Method>(four, four_start, h, steps, normalised));
  const auto add = [&](const std::string& what, double shape, double off) {
    table.add(
        {name, number(seconds) + " s", what, error_or_rounding(shape), error_number(off) + " rad"});
  };
  add("nine numbers", rotation::orthonormality_error(R),
      angle_apart(to_matrix(exact), nearest_rotation(R)));
  add("four numbers", shape_error(q), angle_between(exact, q));
  add("four, normalised", shape_error(r), angle_between(exact, r));
}

/// ‖RᵀR − 1‖ at moments evenly spread over a log axis.
template <class Method, class State, class Rate, class Shape>
support::Series drift_series(const std::string& name, const Rate& rate, State y, Shape&& shape) {
  support::Series series{name, {}, {}};
  int next = 1;
  for (int i = 1; i <= 60 * 600; ++i) {
    y = Method::step(rate, i * h, y, h);
    if (i != next) continue;
    next = std::max(next + 1, next * 3 / 2);
    series.x.push_back(i * h);
    series.y.push_back(shape(y));
  }
  return series;
}

}  // namespace

Table drift_table() {
  Table table({"method", "after", "orientation as", "‖RᵀR − 1‖", "orientation off by"});
  add_drift<runge_kutta::Euler>(table, "Euler", 10);
  add_drift<runge_kutta::Midpoint>(table, "midpoint", 600);
  add_drift<Rk4>(table, "RK4", 600);
  return table;
}

std::string drift_figure() {
  support::Plot plot{"drift of four and of nine numbers",
                     {"time [s]", support::Scale::log},
                     {"‖RᵀR − 1‖", support::Scale::log},
                     {}};
  const auto of_four = [](const Four<double>& y) { return shape_error(from_coefficients(y)); };
  const auto of_nine = [](const Nine<double>& y) {
    return rotation::orthonormality_error(y.reshaped(3, 3));
  };
  const auto four = rate_of_four<double>(steady);
  const auto nine = rate_of_nine<double>(steady);
  plot.series = {drift_series<runge_kutta::Euler>("Euler, nine", nine, nine_start, of_nine),
                 drift_series<runge_kutta::Euler>("Euler, four", four, four_start, of_four),
                 drift_series<runge_kutta::Midpoint>("midpoint, nine", nine, nine_start, of_nine),
                 drift_series<runge_kutta::Midpoint>("midpoint, four", four, four_start, of_four),
                 drift_series<Rk4>("RK4, nine", nine, nine_start, of_nine),
                 drift_series<Rk4>("RK4, four", four, four_start, of_four)};
  return support::to_svg(plot);
}

Table big_steps_table() {
  Table table({"to turn by", "Euler turns by", "midpoint", "RK4", "|q|: Euler", "midpoint", "RK4"});
  const auto four = rate_of_four<double>([](double) { return Vec3(0, 0, 1); });
  for (const double angle : {0.1, 0.5, 1.0, 2.0, 3.0, 6.0}) {
    const Quat e = from_coefficients(runge_kutta::Euler::step(four, 0.0, four_start, angle));
    const Quat m = from_coefficients(runge_kutta::Midpoint::step(four, 0.0, four_start, angle));
    const Quat r = from_coefficients(Rk4::step(four, 0.0, four_start, angle));
    const auto turn = [](const Quat& q) {
      return number(2 * std::atan2(q.z(), q.w()) + (q.z() < 0 ? 2 * pi : 0), 5);
    };
    table.add({number(angle) + " rad", turn(e), turn(m), turn(r), number(e.norm(), 5),
               number(m.norm(), 5), number(r.norm(), 5)});
  }
  return table;
}

}  // namespace quaternions_chapter
