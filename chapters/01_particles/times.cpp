/// @file
/// What the steps take on this machine.

#include <string>
#include <vector>

#include "hanging_net.hpp"
#include "methods.hpp"
#include "parts.hpp"
#include "satellite.hpp"
#include "support/stopwatch.hpp"
#include "thrown_ball.hpp"

namespace particles_chapter {

using support::number;

namespace {

constexpr double short_step = 1e-9;  // [s], so that nothing moves far

/// What a step takes: Euler's as a time, the others as a multiple of it.
template <class State, class F>
void add_times(Table& table, const std::string& what, const F& f, const State& start, int batch) {
  support::Stopwatch stopwatch;
  for_each_method([&](const std::string& name, auto method, int) {
    const auto step = [&f, y = start]() mutable {
      y = decltype(method)::step(f, 0., y, short_step);
      support::keep(y);
    };
    stopwatch.add(name, step, batch);
  });
  std::vector<std::string> row{what};
  const std::vector<support::Timing> timings = stopwatch.timings();
  for (const support::Timing& each : timings)
    row.push_back(row.size() == 1 ? support::duration(each.seconds)
                                  : support::times(each.seconds / timings[0].seconds));
  table.add(row);
}

}  // namespace

Table times_table() {
  Table table({"one step", "Euler", "midpoint", "RK4"});
  const Net net{23, 16, 0.02};
  add_times(table, "satellite, 4 numbers", rhs_from_c(satellite), at_perigee(), 20000);
  add_times(table, "ball in air, 6 numbers", flight(balls[1], 30),
            Flight(particles::flatten(thrown(balls[1].mass, 30))), 20000);
  add_times(table, "net, 2208 numbers", hanging(net), Knots(particles::flatten(level(net))), 200);
  return table;
}

}  // namespace particles_chapter
