#pragma once
/// @file
/// What the steps take on this machine.

#include <algorithm>
#include <array>
#include <string>

#include "net.hpp"
#include "orbit.hpp"
#include "support/stopwatch.hpp"

namespace particles_chapter {

/// Seconds a step, each from where the last one ended: the least of many batches.
template <class Method, class State, class F>
double seconds_a_step(const F& f, const State& start, int batch) {
  constexpr double h = 1e-9;  // [s], so that nothing moves far
  State y = start;
  const auto many = [&] {
    for (int i = 0; i < batch; ++i) y = Method::step(f, 0., y, h);
    support::keep(y);
  };
  return support::shortest_run(0.01, many) / batch;
}

/// What a step takes: Euler's as a time, the others as a multiple of it. The methods take turns.
template <class State, class F>
void add_times(Table& table, const std::string& what, const F& f, const State& y, int batch) {
  std::array<double, 3> least{1, 1, 1};
  for (int round = 0; round < 6; ++round) {
    std::size_t i = 0;
    for_each_method([&](const std::string&, auto method, int) {
      least[i] = std::min(least[i], seconds_a_step<decltype(method)>(f, y, batch));
      ++i;
    });
  }
  table.add({what, support::duration(least[0]), number(least[1] / least[0], 2) + " ×",
             number(least[2] / least[0], 2) + " ×"});
}

inline Table times_table() {
  Table table({"one step", "Euler", "midpoint", "RK4"});
  const Net net{23, 16, 0.02};
  add_times(table, "satellite, 4 numbers", rhs_from_c(satellite), at_perigee(), 20000);
  add_times(table, "ball in air, 6 numbers", flight(balls[1], 30),
            Flight(flatten(thrown(balls[1].mass, 30))), 20000);
  add_times(table, "net, 2208 numbers", hanging(net), Knots(flatten(level(net))), 200);
  return table;
}

}  // namespace particles_chapter
