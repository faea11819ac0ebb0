/// @file
/// A free body, integrated with L in the state or with ω in it: what is conserved, and what it
/// costs.

#include <cmath>

#include "common.hpp"
#include "parts.hpp"
#include "storages.hpp"
#include "support/counted.hpp"
#include "support/plot.hpp"
#include "support/stopwatch.hpp"
#include "thrown_objects.hpp"

namespace momentum_chapter {

namespace {

// ── The free handle ──

using support::Counted;

template <class T>
const RigidBody<T>& subject() {
  static const RigidBody<T> body(properties_of(free_handle));
  return body;
}

constexpr double spin_time = 10;     // [s]
const Vec3 spin_start(6, 0.3, 0.3);  // in body axes, mostly about the stem [rad/s]

/// The same spin about axes at random: each single start favours one storage or another.
const std::vector<Vec3>& spin_starts() {
  static const std::vector<Vec3> starts = [] {
    Random random(5);
    std::vector<Vec3> list;
    for (int i = 0; i < 12; ++i) list.emplace_back(spin_start.norm() * random.direction());
    return list;
  }();
  return starts;
}

struct Spinning {
  Quat q;
  Vec3 omega;
};

template <class Method>
Spinning spun(const Storage<double>& storage, const Vec3& omega, double seconds, int steps) {
  const RigidBody<>& body = subject<double>();
  const Vec3 start = storage.from_omega(body, Mat3::Identity(), omega);
  const Seven<double> y = integrate_fixed<Method>(
      [&](double, const Seven<double>& now) { return storage.rate(body, now); },
      seven<double>(Quat::Identity(), start), 0, seconds, steps);
  const Quat q = orientation_of(y);
  return {q, storage.to_omega(body, to_matrix(q), y.tail<3>())};
}

Vec3 L_of(const Spinning& s) {
  return angular_momentum<double>(subject<double>(), to_matrix(s.q), s.omega);
}

double energy_of(const Spinning& s) { return L_of(s).dot(s.omega) / 2; }

/// The orientation after the spin time, to 12 digits.
Quat exact_end(const Vec3& omega) {
  const RigidBody<>& body = subject<double>();
  const Vec3 L = angular_momentum<double>(body, Mat3::Identity(), omega);
  const Seven<double> start = seven<double>(Quat::Identity(), L);
  const auto rate = [&](double, const Seven<double>& y) { return rate_of_L(body, y); };
  return orientation_of(integrate_adaptive<Dop853>(rate, start, 0, spin_time, {1e-14, 1e-16}).y);
}

const std::vector<Quat>& exact_ends() {
  static const std::vector<Quat> ends = [] {
    std::vector<Quat> list;
    for (const Vec3& omega : spin_starts()) list.push_back(exact_end(omega));
    return list;
  }();
  return ends;
}

/// The error of the orientation [rad], by the mean of its logarithm over all starts.
template <class Method>
double typical_error(const Storage<double>& storage, int steps) {
  double sum = 0;
  for (std::size_t i = 0; i < spin_starts().size(); ++i) {
    const Spinning end = spun<Method>(storage, spin_starts()[i], spin_time, steps);
    sum += std::log(angle_between(exact_ends()[i], end.q));
  }
  return std::exp(sum / static_cast<double>(spin_starts().size()));
}

/// How far what a free body keeps is off in the end, or that nothing finite is left of it.
template <class Method>
void add_kept(Table& table, const std::string& method, double rate, double seconds) {
  const Spinning start{Quat::Identity(), spin_start};
  for (std::size_t i = 0; i < 3; ++i) {
    const Spinning end =
        spun<Method>(storages<double>[i], spin_start, seconds, static_cast<int>(rate * seconds));
    const double L_off = (L_of(end) - L_of(start)).norm() / L_of(start).norm();
    const double energy_off = std::abs(energy_of(end) / energy_of(start) - 1);
    const bool finite = L_off < 1e6;
    table.add({method, number(rate), storages<double>[i].name,
               finite ? error_or_rounding(L_off) : "blows up",
               finite ? error_or_rounding(energy_off) : "blows up"});
  }
}

template <class Method>
void add_work(support::Plot& plot, const std::string& method, int stages) {
  for (std::size_t i = 0; i < 3; ++i) {
    support::Series series{method + ", " + storages<double>[i].name, {}, {}};
    series.colour = "c" + std::to_string(i);  // as L and ω have elsewhere
    for (int steps = 100; steps * stages <= 40000; steps = steps * 3 / 2) {
      const double off = typical_error<Method>(storages<double>[i], steps);
      if (!(off < 1)) continue;
      series.x.push_back(steps * stages);
      series.y.push_back(off);
    }
    plot.series.push_back(series);
  }
}

}  // namespace

Table kept_table() {
  Table table({"method", "steps per second", "stored", "error of L", "error of energy"});
  constexpr double ten_minutes = 600;
  add_kept<runge_kutta::Euler>(table, "Euler", 60, ten_minutes);
  add_kept<runge_kutta::Midpoint>(table, "midpoint", 60, ten_minutes);
  add_kept<Rk4>(table, "RK4", 60, ten_minutes);
  add_kept<Rk4>(table, "RK4", 240, ten_minutes);
  return table;
}

Table longer_table() {
  Table table({"Euler, stored", "energy off after ten minutes", "after fifteen"});
  const double start = energy_of({Quat::Identity(), spin_start});
  for (std::size_t i = 0; i < 2; ++i) {
    const auto off = [&](double seconds) {
      const Spinning end = spun<runge_kutta::Euler>(storages<double>[i], spin_start, seconds,
                                                    static_cast<int>(60 * seconds));
      return error_number(std::abs(energy_of(end) / start - 1));
    };
    table.add({storages<double>[i].name, off(600), off(900)});
  }
  return table;
}

Table stored_table() {
  Table table(
      {"stored", "its rate", "one evaluation", "off, 60 steps/s", "240 steps/s", "960 steps/s"});
  const Seven<Counted> y =
      seven<Counted>(Quaternion<Counted>(1, 0, 0, 0), spin_start.cast<Counted>());
  for (std::size_t i = 0; i < storages<double>.size(); ++i) {
    const Storage<double>& storage = storages<double>[i];
    const auto evaluate = [&] { support::keep(storages<Counted>[i].rate(subject<Counted>(), y)); };
    std::vector<std::string> row{storage.name, storage.law,
                                 support::text_of(support::count(evaluate))};
    for (const double rate : {60., 240., 960.})
      row.push_back(error_number(typical_error<Rk4>(storage, static_cast<int>(rate * spin_time))) +
                    " rad");
    table.add(row);
  }
  return table;
}

std::string stored_figure() {
  support::Plot plot{"ten seconds of a free handle, twelve starts",
                     {"evaluations", support::Scale::log},
                     {"orientation off by [rad]", support::Scale::log},
                     {}};
  add_work<runge_kutta::Midpoint>(plot, "midpoint", 2);
  add_work<Rk4>(plot, "RK4", 4);
  return support::to_svg(plot);
}

}  // namespace momentum_chapter
