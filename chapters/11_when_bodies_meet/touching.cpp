/// @file
/// When bodies touch: a bullet and a thin plate, and two rods that come together.

#include <functional>

#include "common.hpp"
#include "parts.hpp"

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

/// Conservative advancement; `see` gets each time and gap.
template <class See>
double by_advancement(Watched& gap, double speed, double t1, const See& see) {
  for (double t = 0; t <= t1;) {
    const double distance = gap(t);
    see(t, distance);
    if (distance <= touching) return t;
    t += distance / speed;
  }
  return never_found;
}

// ── The bullet ──

constexpr double bullet_speed = 1e4, bullet_start = 12.34, plate = 1e-3;

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
    add_tunnel_row(
        table, "conservative advancement, speed ≤ " + number(speed / 1000) + " km/s",
        [&](Watched& gap) { return by_advancement(gap, speed, t1, [](double, double) {}); });
  return table;
}

}  // namespace contact_chapter
