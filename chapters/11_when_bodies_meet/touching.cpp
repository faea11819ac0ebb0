/// @file
/// When bodies touch: a bullet and a thin plate, and two rods that come together.

#include <algorithm>
#include <functional>

#include "common.hpp"
#include "parts.hpp"
#include "tumble/collide/first_contact.hpp"

namespace contact_chapter {

namespace {

/// Looks at a gap, and counts.
struct Watched {
  std::function<double(double)> gap;
  int evaluations = 0;

  double operator()(double t) {
    ++evaluations;
    return gap(t);
  }
};

constexpr double never_found = -1, touching = 1e-6;  // [s], [m]

double by_steps(Watched& gap, double h, double t1) {
  for (int i = 0; i * h <= t1; ++i)
    if (gap(i * h) <= touching) return i * h;
  return never_found;
}

/// Where two looks one after the other have different signs, half of the way again and again.
double by_bisection(Watched& gap, double h, double t1) {
  for (int i = 1; i * h <= t1; ++i) {
    double low = (i - 1) * h, high = i * h;
    if (gap(high) > 0) continue;
    while (high - low > 1e-12) (gap((low + high) / 2) > 0 ? low : high) = (low + high) / 2;
    return high;
  }
  return never_found;
}

double by_advancement(Watched& gap, double speed, double t1) {
  const collide::FirstContact contact =
      collide::first_contact([&gap](double t) { return gap(t); }, speed, 0, t1, touching);
  return contact.found ? contact.t : never_found;
}

// ── The bullet ──

constexpr double bullet_speed = 1e4, bullet_start = 12.3456789, plate = 1e-3;

/// To the plate from either side.
double bullet_gap(double t) {
  const double x = bullet_speed * t - bullet_start;
  return std::max(-x, x - plate);
}

template <class Find>
void add_tunnel_row(Table& table, const std::string& method, const Find& find) {
  Watched gap{bullet_gap};
  const double t = find(gap);
  const double off = std::abs(t - bullet_start / bullet_speed);
  table.add({method, yes_or_no(t != never_found),
             t == never_found ? "" : (off < 1e-14 ? "< 1e-14" : number(off, 1)),
             std::to_string(gap.evaluations)});
}

}  // namespace

Table tunnel_table() {
  constexpr double t1 = 0.1;
  Table table({"method", "found", "time off [s]", "looks at the gap"});
  for (const double rate : {60., 1e3, 1e7})
    add_tunnel_row(table, (rate < 1e7 ? "steps of 1/" + number(rate, 4) : "steps of 1e-7") + " s",
                   [&](Watched& gap) { return by_steps(gap, 1 / rate, t1); });
  for (const int rate : {60, 1000})
    add_tunnel_row(table, "bisection in steps of 1/" + std::to_string(rate) + " s",
                   [&](Watched& gap) { return by_bisection(gap, 1. / rate, t1); });
  for (const double speed : {1e4, 2e4})
    add_tunnel_row(table, "conservative advancement, speed ≤ " + number(speed / 1000) + " km/s",
                   [&](Watched& gap) { return by_advancement(gap, speed, t1); });
  return table;
}

// ── The rod ──

namespace {

/// A rod of 2 m that turns and sinks: from its lower end to the floor. Its centre sinks with
/// 0.35 m/s, and its ends turn with 5 m/s.
double turning_rod_gap(double t) { return 1.45 - 0.35 * t - std::abs(std::sin(5 * t)); }

constexpr double rod_speed = 0.35 + 5, rod_time = 1.6;

/// On the sheet [px]: 1 s is 415 px wide, 1 m is 230 px high.
Vec2 on_sheet(double t, double gap) { return {415 * t, 230 * gap}; }

std::vector<Vec2> turning_rod_curve() {
  std::vector<Vec2> curve;
  for (double t = 0; turning_rod_gap(t) >= 0; t += 0.002)
    curve.push_back(on_sheet(t, turning_rod_gap(t)));
  return curve;
}

void draw_scales(Sketch& sketch) {
  sketch.arrow({0, 0}, on_sheet(1.58, 0), {"ink", 1.5});
  sketch.arrow({0, 0}, on_sheet(0, 1.6), {"ink", 1.5});
  for (const double at : {0.5, 1., 1.5}) {
    sketch.curve({on_sheet(at, 0), on_sheet(at, -0.02)}, {"ink", 1.5});
    sketch.words(on_sheet(at, 0), {0, 22}, number(at), "ink", "middle");
    sketch.curve({on_sheet(0, at), on_sheet(-0.01, at)}, {"ink", 1.5});
    sketch.words(on_sheet(0, at), {-10, 5}, number(at), "ink", "end");
  }
  sketch.words({0, 0}, {-10, 22}, "0", "ink", "middle");
  sketch.words(on_sheet(0.75, 0), {0, 42}, "time [s]", "ink", "middle");
  sketch.words(on_sheet(0, 1.6), {12, 4}, "gap [m]");
}

}  // namespace

std::string staircase_figure() {
  Sketch sketch(760, 450, "Conservative advancement: from gap to gap, to the contact", 15);
  sketch.look({48, 392, 1});
  std::vector<std::vector<Vec2>> worst;
  std::vector<Vec2> looks;
  Watched gap{[&](double t) {
    const double distance = turning_rod_gap(t), next = t + distance / rod_speed;
    looks.push_back(on_sheet(t, distance));
    worst.push_back(
        {on_sheet(t, distance), on_sheet(next, 0), on_sheet(next, turning_rod_gap(next))});
    return distance;
  }};
  by_advancement(gap, rod_speed, rod_time);
  draw_scales(sketch);
  sketch.curves(worst, {"c1", 1.3});
  sketch.curve(turning_rod_curve(), {"c0", 2.4});
  sketch.dots(looks, "c1", 3.6);
  sketch.words(on_sheet(0.66, 1.22), {0, 0}, "the gap", "c0");
  sketch.words(on_sheet(0.13, 1.22), {0, 0}, "at most this fast", "c1");
  sketch.words(looks.back(), {6, -12}, "contact", "ink");
  return sketch.svg();
}

}  // namespace contact_chapter
