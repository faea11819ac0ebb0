/// @file
/// Infinitely many bounces in a finite time.

#include "common.hpp"
#include "parts.hpp"

namespace contact_chapter {

namespace {

constexpr double zeno_height = 1;

double zeno_first() { return std::sqrt(2 * zeno_height / gravity); }

/// The time of the k-th contact: t₀ (1 + 2e + 2e² + … + 2eᵏ⁻¹).
double zeno_contact(double e, int k) {
  double t = zeno_first(), flight = 2 * t;
  for (int i = 1; i < k; ++i) t += flight *= e;
  return t;
}

double zeno_end(double e) { return zeno_first() * (1 + e) / (1 - e); }

/// How high it rises after the k-th contact.
double zeno_rise(double e, int k) { return zeno_height * std::pow(e, 2 * k); }

}  // namespace

Table zeno_table() {
  Table table(
      {"contact", "e = 0.5: time [s]", "then rises [m]", "e = 0.8: time [s]", "then rises [m]"});
  for (const int k : {1, 2, 3, 5, 10, 20, 50})
    table.add({std::to_string(k), rounded(zeno_contact(0.5, k), 4), number(zeno_rise(0.5, k), 2),
               rounded(zeno_contact(0.8, k), 4), number(zeno_rise(0.8, k), 2)});
  table.add({"t₀ (1 + e)/(1 − e)", rounded(zeno_end(0.5), 4), "0", rounded(zeno_end(0.8), 4), "0"});
  return table;
}

namespace {

/// Height over time: of each flight a few points of its parabola. Flights that are too low to see
/// would only push the name at their end against the other ball's path.
Series zeno_path(double e) {
  constexpr double lowest = 1e-4;  // [m]
  Series path{"e = " + number(e), {}, {}};
  for (int k = 0; zeno_rise(e, k) > lowest; ++k) {
    const double speed = std::sqrt(2 * gravity * zeno_rise(e, k)), flight = 2 * speed / gravity;
    // It begins at the top of a flight.
    const double start = k == 0 ? -zeno_first() : zeno_contact(e, k);
    for (int i = k == 0 ? 16 : 0; i <= 32; ++i) {
      const double t = flight * i / 32;
      path.x.push_back(start + t);
      path.y.push_back(speed * t - gravity * t * t / 2);
    }
  }
  return path;
}

/// How high it will rise: a step down at each contact.
Series zeno_stairs(double e) {
  Series stairs{"e = " + number(e), {0}, {zeno_height}};
  for (int k = 1; zeno_rise(e, k - 1) > 1e-9; ++k) {
    const double t = zeno_contact(e, k);
    stairs.x.insert(stairs.x.end(), {t, t});
    stairs.y.insert(stairs.y.end(), {zeno_rise(e, k - 1), zeno_rise(e, k)});
  }
  return stairs;
}

/// The time after which it rests, from the floor of the plot nearly to its top: the name at its end
/// is below the grid's last line.
Series zeno_wall(double e, double low, const std::string& colour) {
  constexpr double high = 0.3;
  return {e == 0.5 ? "" : "t₀ (1 + e)/(1 − e)",  // the line beside it is another of the kind
          {zeno_end(e), zeno_end(e)},           {low, high}, support::Look::dashed, colour, 1.2};
}

}  // namespace

std::string zeno_figure() {
  Plot heights{"the height", {"time [s]"}, {"height [m]"}, {}};
  Plot rises{"how high it will rise", {"time [s]"}, {"rise [m]", support::Scale::log}, {}};
  heights.series = {zeno_path(0.5), zeno_path(0.8)};
  rises.series = {zeno_stairs(0.5), zeno_stairs(0.8), zeno_wall(0.5, 1e-10, "c5"),
                  zeno_wall(0.8, 1e-10, "c5")};
  return support::to_svg("A ball that bounces infinitely often in a finite time", {heights, rises},
                         {});
}

}  // namespace contact_chapter
