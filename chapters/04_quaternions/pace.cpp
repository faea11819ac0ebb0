/// @file
/// The pace on the way: chord and arc, and what a mixture is off by.

#include <utility>
#include <vector>

#include "parts.hpp"
#include "support/plot.hpp"
#include "support/sketch.hpp"
#include "ways.hpp"

namespace quaternions_chapter {

// ── Why the pace differs ──

namespace {

/// A circle with the arc and the chord between two orientations, each in eight equal parts.
void arc_and_chord(support::Sketch& sketch, double angle, const std::string& title) {
  const auto on_circle = [](double a) { return Vec2(std::sin(a), std::cos(a)); };
  std::vector<Vec2> arc;
  for (int i = 0; i <= 90; ++i) arc.push_back(on_circle(angle * (i / 90.0 - 0.5)));
  const Vec2 a = arc.front(), b = arc.back();
  sketch.curve(arc, {"c0", 2});
  sketch.curve({a, b}, {"c1", 2});
  std::vector<std::vector<Vec2>> rays;
  for (int i = 0; i <= 8; ++i) {
    const Vec2 p = a + (b - a) * i / 8.0;
    rays.push_back({Vec2(0, 0), p.normalized()});
  }
  sketch.curves(rays, {"c1", 1, 0.6});
  for (int i = 0; i <= 8; ++i) {
    const Vec2 p = a + (b - a) * i / 8.0;
    sketch.dot(p, "c1", 3.5);
    sketch.dot(p.normalized(), "c1", 3.5);
    sketch.dot(on_circle(angle * (i / 8.0 - 0.5)) * 1.05, "c0", 3.5);
  }
  sketch.dot({0, 0}, "ink", 3);
  sketch.words({0, 0}, {0, 24}, title, "ink", "middle");
}

}  // namespace

std::string chord_figure() {
  support::Sketch sketch(520, 250, "Equal parts of the chord, unequal parts of the arc", 14);
  sketch.look({130, 200, 122});
  arc_and_chord(sketch, whole_turn / 2, "four numbers: 75° apart");
  sketch.look({390, 200, 122});
  arc_and_chord(sketch, whole_turn, "nine numbers: 150° apart");
  sketch.words({0, 0}, {-380, -180}, "equal parts of the arc", "c0");
  sketch.words({0, 0}, {-380, -162}, "equal parts of the chord, and where they point", "c1");
  return sketch.svg();
}

std::string pace_figure() {
  support::Plot plot{"pace on the way", {"t"}, {"angular speed [150° per unit of t]"}, {}};
  // In the colours of the tracks on the globe.
  const std::vector<std::pair<std::size_t, std::string>> shown{
      {4, "slerp"}, {1, "nine numbers"}, {3, "four numbers"}, {2, "three angles"}};
  for (const auto& [w, name] : shown) {
    support::Series series{name, {}, {}};
    for (int i = 0; i <= 100; ++i) {
      series.x.push_back(i / 100.0);
      series.y.push_back(speed(ways[w], i / 100.0) / whole_turn);
    }
    plot.series.push_back(series);
  }
  return support::to_svg(plot);
}

Table pace_table() {
  Table table({"turn", "four: fastest / slowest", "off by", "nine: fastest / slowest", "off by"});
  const Quat a = Quat::Identity();
  for (const double angle : {5., 30., 90., 150., 179.}) {
    const Quat b = from_axis_angle({2, -1, 2}, angle * degree);
    double off_four = 0, off_nine = 0;
    for (int i = 0; i <= 1000; ++i) {
      const double t = i / 1000.0;
      const Quat exact = slerp(a, b, t);
      const Mat3 nine = nearest_rotation((1 - t) * to_matrix(a) + t * to_matrix(b));
      off_four = std::max(off_four, angle_between(exact, mix_four(a, b, t)));
      off_nine = std::max(off_nine, angle_apart(to_matrix(exact), nine));
    }
    const auto ratio = [](double between) { return number(1 / std::pow(std::cos(between), 2), 5); };
    table.add({number(angle) + "°", ratio(angle * degree / 4), degrees(off_four, 2),
               ratio(angle * degree / 2), degrees(off_nine, 2)});
  }
  return table;
}

}  // namespace quaternions_chapter
