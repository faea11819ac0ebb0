/// @file
/// Steps: their order, what they keep, and what is lost when the forces are asked too seldom.

#include "common.hpp"
#include "momenta_first.hpp"
#include "mug_end.hpp"
#include "parts.hpp"

namespace rigid_body_chapter {

namespace {

/// What is asked once, where the step begins, pushes until it ends.
template <class Method, class Rhs>
RigidBodyState<> with_stale_forces(const Rhs& motion, const RigidBodyState<>& start,
                                   double duration, int steps) {
  const double h = duration / steps;
  PackedState<double> y = pack(start);
  for (int i = 0; i < steps; ++i) {
    const PackedState<double> asked = motion(i * h, y);
    const auto f = [&](double t, const PackedState<double>& z) -> PackedState<double> {
      PackedState<double> rate = motion(t, z);
      rate.tail<6>() = asked.tail<6>();
      return rate;
    };
    y = Method::step(f, i * h, y, h);
  }
  return unpack<double>(y);
}

// ── The order ──

/// A row of errors at 60, 120, 240 … steps per second, and the order that the last two show.
template <class End>
void add_orders(Table& table, std::vector<std::string> row, const End& end) {
  std::vector<double> errors;
  for (const int rate : {60, 120, 240, 480}) {
    errors.push_back(turned_apart(end(rate), mug_end()));
    row.push_back(error_number(errors.back()) + " rad");
  }
  row.push_back(order_text(errors[2], errors[3]));
  table.add(row);
}

}  // namespace

Table steps_table() {
  Table table({"method", "slopes", "60 steps per second", "120", "240", "480", "order"});
  const auto add = [&]<class Method>(const std::string& name, const std::string& slopes, Method) {
    add_orders(table, {name, slopes}, [](int rate) {
      return stepped<Method>(hanging_mug(), mug_start(), mug_time,
                             static_cast<int>(rate * mug_time));
    });
  };
  add("Euler", "1", runge_kutta::Euler{});
  add("momenta first", "1", MomentaFirst{});
  add("midpoint", "2", runge_kutta::Midpoint{});
  add("RK4", "4", Rk4{});
  return table;
}

Table stale_table() {
  Table table({"RK4, forces evaluated", "60 steps per second", "120", "240", "480", "order"});
  const auto add = [&](const std::string& name, auto&& end) { add_orders(table, {name}, end); };
  add("four times per step", [](int rate) {
    return stepped<Rk4>(hanging_mug(), mug_start(), mug_time, static_cast<int>(rate * mug_time));
  });
  add("once per step", [](int rate) {
    return with_stale_forces<Rk4>(hanging_mug(), mug_start(), mug_time,
                                  static_cast<int>(rate * mug_time));
  });
  return table;
}

// ── Against the closed form ──

Table free_table() {
  Table table(
      {"steps per second", "after 1 s", "order", "after 10 s", "order", "energy after 10 s"});
  const FreeTrajectory exact(handle(), handle_start());
  const double energy = kinetic_energy(handle(), handle_start());
  double before1 = 0, before10 = 0;
  for (const int rate : {30, 60, 120, 240, 480, 960}) {
    const auto end = [&](int seconds) {
      return stepped<Rk4>(RigidBodyRhs(handle()), handle_start(), seconds, seconds * rate);
    };
    const double off1 = turned_apart(end(1), exact.at(1));
    const double off10 = turned_apart(end(10), exact.at(10));
    const auto order = [](double before, double now) {
      return before > 0 ? order_text(before, now) : std::string();
    };
    table.add({std::to_string(rate), error_number(off1) + " rad", order(before1, off1),
               error_number(off10) + " rad", order(before10, off10),
               error_number(kinetic_energy(handle(), end(10)) / energy - 1)});
    before1 = off1;
    before10 = off10;
  }
  return table;
}

// ── What is kept ──

namespace {

/// The energy of the free handle over time, with as many evaluations per second for every method.
template <class Method>
support::Series energy_series(const std::string& name, int rate) {
  const RigidBodyRhs motion(handle());
  const double energy = kinetic_energy(handle(), handle_start());
  support::Series series{name, {}, {}};
  int next = 1, i = 0;
  double worst = 0;
  integrate_fixed<Method>(motion, pack(handle_start()), 0, 200, 200 * rate,
                          [&](double t, const PackedState<double>& y) {
                            const double now = kinetic_energy(handle(), unpack<double>(y));
                            worst = std::max(worst, std::abs(now / energy - 1));
                            if (++i != next) return;
                            next = std::max(next + 1, next * 4 / 3);
                            series.x.push_back(t);
                            series.y.push_back(std::max(worst, 1e-16));
                          });
  return series;
}

}  // namespace

std::string energy_figure() {
  support::Plot plot{"a free handle, 240 evaluations per second",
                     {"time [s]", support::Scale::log},
                     {"largest error of the energy so far", support::Scale::log},
                     {}};
  plot.series = {energy_series<runge_kutta::Euler>("Euler, 240 steps/s", 240),
                 energy_series<runge_kutta::Midpoint>("midpoint, 120", 120),
                 energy_series<Rk4>("RK4, 60", 60), energy_series<Dop853>("DOP853, 20", 20)};
  return support::to_svg(plot);
}

}  // namespace rigid_body_chapter
