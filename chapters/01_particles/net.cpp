/// @file
/// A net of knots and springs, nailed at two corners, that falls and swings.

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "hanging_net.hpp"
#include "methods.hpp"
#include "parts.hpp"
#include "support/sketch.hpp"
#include "thrown_ball.hpp"
#include "tumble/particles.hpp"

namespace particles_chapter {

using support::error_number;
using support::number;
using support::Vec2;

namespace {

/// Kinetic, of height, and of stretched threads [J].
double energy(const Net& net, const Knots& y) {
  double sum = 0;
  for (int i = 0; i < net.knots(); ++i)
    sum += net.mass * (y.segment<3>(place(i) + 3).squaredNorm() / 2 + g * y[place(i) + 2]);
  for (const particles::Spring& thread : threads(net)) {
    const double length = (y.segment<3>(place(thread.i)) - y.segment<3>(place(thread.j))).norm();
    sum += net.stiffness * (length - net.mesh) * (length - net.mesh) / 2;
  }
  return sum;
}

// ── The net in six moments ──

/// Seen from a little above and from the left, without perspective.
Vec2 seen(const Vec3& p) {
  constexpr double sin_a = 0.479, cos_a = 0.878, sin_b = 0.389, cos_b = 0.921;
  return {cos_a * p.x() + sin_a * p.y(), cos_b * p.z() + sin_b * (cos_a * p.y() - sin_a * p.x())};
}

/// Three short arrows below the first moment.
void draw_axes(support::Sketch& sketch) {
  const Vec3 corner(0.1, 0, -1.15);
  const std::array<const char*, 3> names{"x", "y", "z"};
  for (Eigen::Index i = 0; i < 3; ++i) {
    const Vec2 tip = seen(corner + 0.4 * Vec3::Unit(i));
    sketch.arrow(seen(corner), tip, {"faint", 1.5});
    sketch.words(tip, {5, 4}, names[static_cast<std::size_t>(i)]);
  }
}

std::vector<std::vector<Vec2>> lines_of(const Net& net, const Knots& y) {
  std::vector<std::vector<Vec2>> rows(static_cast<std::size_t>(net.rows)),
      columns(static_cast<std::size_t>(net.columns));
  for (int i = 0; i < net.knots(); ++i) {
    const Vec2 point = seen(y.segment<3>(place(i)));
    rows[static_cast<std::size_t>(i / net.columns)].push_back(point);
    columns[static_cast<std::size_t>(i % net.columns)].push_back(point);
  }
  rows.insert(rows.end(), columns.begin(), columns.end());
  return rows;
}

}  // namespace

std::string net_figure() {
  constexpr int steps_per_second = 2000;
  const Net net{23, 16, 0.02};
  support::Sketch sketch(690, 420, "a net of springs falls and swings");
  const auto f = hanging(net);
  Knots y = particles::flatten(level(net));
  double then = 0;
  int panel = 0;
  for (const double now : {0., 0.35, 0.55, 0.75, 0.95, 1.2}) {
    if (now > then)
      y = integrate_fixed<Rk4>(f, y, then, now,
                               static_cast<int>(std::lround((now - then) * steps_per_second)));
    then = now;
    const int row = panel / 3, column = panel % 3;
    sketch.look({14. + 230 * column, 72. + 185 * row, 78});
    sketch.curves(lines_of(net, y), {"c0", 0.9});
    for (const int nailed : {net.knot(0, 0), net.knot(net.columns - 1, 0)})
      sketch.dot(seen(y.segment<3>(place(nailed))), "c1", 3.5);
    sketch.words({0, 0}, {-8, -24}, number(now) + " s");
    if (panel == 0) draw_axes(sketch);
    ++panel;
  }
  return sketch.svg();
}

// ── Energy as a check ──

namespace {

/// An energy gained [J], if it is one still; below 1e-10 J it is rounding.
std::string energy_text(double gained) {
  if (!(std::abs(gained) < 1000)) return "exploded";
  return std::abs(gained) < 1e-10 ? "< 1e-10 J" : error_number(gained) + " J";
}

}  // namespace

Table net_table() {
  Table table({"steps per second", "Euler", "midpoint", "RK4"});
  const Net net{9, 7, 0};
  const auto f = hanging(net);
  const Knots start = particles::flatten(level(net));
  for (const int steps : {250, 500, 1000, 2000, 4000, 8000, 16000}) {
    std::vector<std::string> row{number(steps, 5)};
    for_each_method([&](const std::string&, auto method, int) {
      const Knots end = integrate_fixed<decltype(method)>(f, start, 0, 0.5, steps / 2);
      const double gained = energy(net, end) - energy(net, start);
      row.push_back(energy_text(gained));
    });
    table.add(row);
  }
  return table;
}

}  // namespace particles_chapter
