/// @file
/// What error a step buys, against operations and against time.

#include <functional>

#include "counted_steps.hpp"
#include "parts.hpp"
#include "support/plot.hpp"
#include "support/stopwatch.hpp"
#include "tumble/ode.hpp"

namespace quaternions_chapter {

// ── Error against cost ──

namespace {

/// A body that spins about an axis of its own, which goes round the vertical: a top.
constexpr double lean = 0.6, precession = 2, own = 5;  // [rad], [rad/s], [rad/s]
constexpr double span = 10;                            // [s]

Quat top_orientation(double t) {
  return from_axis_angle(Vec3::UnitZ(), precession * t) * from_axis_angle(Vec3::UnitX(), lean) *
         from_axis_angle(Vec3::UnitZ(), own * t);
}

/// ω(t) of the top, in world axes.
Vec3 top_spin(double t) {
  const double s = std::sin(lean), c = std::cos(lean);
  return {own * s * std::sin(precession * t), -own * s * std::cos(precession * t),
          precession + own * c};
}

template <class Method>
double error_of_four(int steps) {
  const Four<double> y =
      stepped<Method>(rate_of_four<double>(top_spin), coefficients(top_orientation(0)),
                      span / steps, steps, as_it_is);
  return angle_between(top_orientation(span), from_coefficients(y));
}

template <class Method>
double error_of_nine(int steps) {
  const Nine<double> y = stepped<Method>(rate_of_nine<double>(top_spin),
                                         Nine<double>(to_matrix(top_orientation(0)).reshaped()),
                                         span / steps, steps, as_it_is);
  return angle_apart(to_matrix(top_orientation(span)), nearest_rotation(y.reshaped(3, 3)));
}

/// One turn about the ω in the middle of the step.
Quat turn_step(const Quat& q, const Vec3& middle, double step) {
  return exp_quaternion<double>(step * middle) * q;
}

double error_of_turns(int steps) {
  Quat q = top_orientation(0);
  const double step = span / steps;
  for (int i = 0; i < steps; ++i) q = turn_step(q, top_spin((i + 0.5) * step), step);
  return angle_between(top_orientation(span), q);
}

/// How many steps an error takes; 0 for more than 200,000.
double steps_for(double target, const std::function<double(int)>& error) {
  double before = error(32);
  for (int steps = 64; steps <= 1 << 18; steps *= 2) {
    const double now = error(steps);
    if (now < target)
      return 0.5 * steps * std::pow(2, std::log(before / target) / std::log(before / now));
    before = now;
  }
  return 0;
}

/// A large number, rounded to two digits and written in full.
std::string two_digits(double value) {
  const double unit = std::pow(10, std::floor(std::log10(value)) - 1);
  return number(std::round(value / unit) * unit, 9);
}

template <class Method, class State, class Rate>
auto steps_of(const Rate& rate, State y) {
  return [rate, y]() mutable {
    y = Method::step(rate, 0.0, y, 1e-3);
    support::keep(y);
  };
}

}  // namespace

std::string work_figure() {
  support::Plot plot{"error against work",
                     {"multiplications for 10 s", support::Scale::log},
                     {"orientation off by [rad]", support::Scale::log},
                     {}};
  const auto add = [&](const std::string& name, auto&& error, const support::Operations& each) {
    support::Series series{name, {}, {}};
    for (int steps = 128; steps <= 65536; steps *= 2) {
      const double off = error(steps);
      if (off < 1e-11 || off > 0.5) continue;
      series.x.push_back(1.0 * steps * each.multiplications);
      series.y.push_back(off);
    }
    plot.series.push_back(series);
  };
  add("Euler, nine", error_of_nine<runge_kutta::Euler>, step_of_nine<runge_kutta::Euler>());
  add("Euler, four", error_of_four<runge_kutta::Euler>, step_of_four<runge_kutta::Euler>());
  add("midpoint, nine", error_of_nine<runge_kutta::Midpoint>,
      step_of_nine<runge_kutta::Midpoint>());
  add("midpoint, four", error_of_four<runge_kutta::Midpoint>,
      step_of_four<runge_kutta::Midpoint>());
  add("RK4, nine", error_of_nine<Rk4>, step_of_nine<Rk4>());
  add("RK4, four", error_of_four<Rk4>, step_of_four<Rk4>());
  return support::to_svg(plot);
}

Table reach_table() {
  const auto four = rate_of_four<double>(steady);
  const auto nine = rate_of_nine<double>(steady);
  support::Stopwatch stopwatch;
  std::vector<std::function<double(int)>> errors;
  const auto add = [&](const std::string& name, auto step, std::function<double(int)> error) {
    stopwatch.add(name, step);
    errors.push_back(std::move(error));
  };
  add("Euler, nine", steps_of<runge_kutta::Euler>(nine, nine_start),
      error_of_nine<runge_kutta::Euler>);
  add("Euler, four", steps_of<runge_kutta::Euler>(four, four_start),
      error_of_four<runge_kutta::Euler>);
  add("midpoint, nine", steps_of<runge_kutta::Midpoint>(nine, nine_start),
      error_of_nine<runge_kutta::Midpoint>);
  add("midpoint, four", steps_of<runge_kutta::Midpoint>(four, four_start),
      error_of_four<runge_kutta::Midpoint>);
  add("RK4, nine", steps_of<Rk4>(nine, nine_start), error_of_nine<Rk4>);
  add("RK4, four", steps_of<Rk4>(four, four_start), error_of_four<Rk4>);
  add(
      "turns about ω, four",
      [q = Quat::Identity()]() mutable { support::keep(q = turn_step(q, steady(0), 1e-3)); },
      error_of_turns);

  const std::vector<support::Timing> timings = stopwatch.timings();
  Table table({"method", "a step", "steps to 1e-4 rad", "time", "to 1e-8 rad", "time"});
  for (std::size_t i = 0; i < timings.size(); ++i) {
    std::vector<std::string> row{timings[i].name, support::duration(timings[i].seconds)};
    for (const double target : {1e-4, 1e-8}) {
      const double steps = steps_for(target, errors[i]);
      row.push_back(steps > 0 ? two_digits(steps) : "> 200000");
      row.push_back(steps > 0 ? support::duration(steps * timings[i].seconds) : "");
    }
    table.add(row);
  }
  return table;
}

Table times_table() {
  support::Stopwatch stopwatch;
  const auto add = [&](const std::string& name, auto&& action) {
    stopwatch.add(name, [action] { support::keep(action()); });
  };
  static Quat q = top_orientation(1), r = top_orientation(1.2);
  static Mat3 R = to_matrix(q);
  static Vec3 p(1, 2, 3);
  const auto fresh = [](auto& value) -> auto& { return support::keep(value), value; };
  add("normalise four numbers", [=] { return rotation::normalize(fresh(q)); });
  add("one Newton step for nine", [=] { return rotation::newton_rotation_step(fresh(R)); });
  add("Gram–Schmidt for nine", [=] { return rotation::gram_schmidt(fresh(R)); });
  add("turn a point by four numbers", [=] { return Vec3(fresh(q) * fresh(p)); });
  add("turn a point by nine", [=] { return Vec3(fresh(R) * fresh(p)); });
  add("matrix from quaternion", [=] { return to_matrix(fresh(q)); });
  add("quaternion from matrix", [=] { return from_matrix(fresh(R)); });
  add("four numbers mixed, normalised",
      [=] { return rotation::normalize(mix_four(fresh(q), fresh(r), 0.3)); });
  add("slerp", [=] { return slerp(fresh(q), fresh(r), 0.3); });
  Table table({"what", "time"});
  for (const support::Timing& each : stopwatch.timings())
    table.add({each.name, support::duration(each.seconds)});
  return table;
}

}  // namespace quaternions_chapter
