/// @file
/// What steps make of a ball that is dropped, and what flights make of it.

#include "dropped_ball.hpp"
#include "parts.hpp"

namespace contact_chapter {

namespace {

constexpr double ball_time = 20;

void add_ball_row(Table& table, const std::string& method, int work, const Falling& ball) {
  const Falling truth = in_truth(ball_time);
  const double energy = energy_of(ball) / energy_of(truth) - 1;
  const double off = std::abs(ball.z - truth.z);
  table.add({method, std::to_string(work), off < 1e-12 ? error_or_rounding(off) : rounded(off, 2),
             std::abs(energy) < 1e-12 ? error_or_rounding(energy) : percent(energy)});
}

/// Both ways to turn the velocity round.
void add_stepped_rows(Table& table, int rate, const std::string& how,
                      Falling (*step)(const Falling&, double, Turn)) {
  for (const Turn turn : {Turn::when_below, Turn::before_it_would_pass}) {
    Falling ball{dropped_from, 0};
    const int steps = static_cast<int>(ball_time) * rate;
    for (int i = 0; i < steps; ++i) ball = step(ball, 1. / rate, turn);
    const std::string name =
        turn == Turn::when_below ? "turn v below the floor" : "turn v before it passes";
    add_ball_row(table, std::to_string(rate) + " Hz" + how + ": " + name, steps, ball);
  }
}

}  // namespace

Table ball_table() {
  Table table({"method", "steps or contacts", "place off [m]", "energy off"});
  add_stepped_rows(table, 60, "", game_step_with_floor);
  add_stepped_rows(table, 3840, "", game_step_with_floor);
  add_stepped_rows(table, 60, ", exact flights", exact_step_with_floor);
  int contacts = 0;
  const Falling ball = by_flights(ball_time, contacts);
  add_ball_row(table, "closed form, time of contact exact", contacts, ball);
  return table;
}

std::string dropped_figure() {
  Plot plot{"dropped from 5 m, e = 1", {"time [s]"}, {"height [m]"}, {}};
  Series exact{"closed form", {}, {}, support::Look::dashed};
  Series below{"60 Hz: when below", {}, {}}, before{"60 Hz: before", {}, {}};
  Falling a{dropped_from, 0}, b{dropped_from, 0};
  for (int i = 0; i <= 20 * 60; ++i) {
    const double t = i / 60.;
    for (Series* series : {&exact, &below, &before}) series->x.push_back(t);
    exact.y.push_back(in_truth(t).z), below.y.push_back(a.z), before.y.push_back(b.z);
    a = game_step_with_floor(a, 1. / 60, Turn::when_below);
    b = game_step_with_floor(b, 1. / 60, Turn::before_it_would_pass);
  }
  plot.series = {exact, below, before};
  return support::to_svg(plot);
}

}  // namespace contact_chapter
