#pragma once
/// @file
/// A net of knots and springs, nailed at two corners, that falls and swings.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "balls.hpp"
#include "support/sketch.hpp"
#include "support/table.hpp"
#include "tumble/particles.hpp"

namespace particles_chapter {

using support::error_number;
using support::Vec2;

/// What a net is made of.
struct Net {
  int columns, rows;
  double damping;           // of a thread [N s/m]
  double mesh = 0.1;        // from knot to knot, and the threads' rest length [m]
  double mass = 0.005;      // of a knot [kg]
  double stiffness = 1000;  // of a thread [N/m]

  int knots() const { return columns * rows; }
  int knot(int column, int row) const { return row * columns + column; }
};

/// Level, at rest; rows run away from the nails at the ends of row 0.
inline std::vector<Particle<double>> level(const Net& net) {
  std::vector<Particle<double>> particles;
  for (int row = 0; row < net.rows; ++row)
    for (int column = 0; column < net.columns; ++column)
      particles.push_back({net.mass, Vec3(column, row, 0) * net.mesh, Vec3::Zero()});
  return particles;
}

inline std::vector<Spring> threads(const Net& net) {
  std::vector<Spring> springs;
  const auto tie = [&](int i, int j) {
    springs.push_back({i, j, net.stiffness, net.damping, net.mesh});
  };
  for (int row = 0; row < net.rows; ++row)
    for (int column = 0; column < net.columns; ++column) {
      if (column + 1 < net.columns) tie(net.knot(column, row), net.knot(column + 1, row));
      if (row + 1 < net.rows) tie(net.knot(column, row), net.knot(column, row + 1));
    }
  return springs;
}

/// All springs as one force.
struct Springs {
  std::vector<Spring> list;

  void operator()(double t, const ParticlesView<double>& particles,
                  const Push<double>& push) const {
    for (const Spring& spring : list) spring(t, particles, push);
  }
};

using Knots = Eigen::VectorXd;

/// Where a knot's position starts in the state; its velocity is three places on.
inline Eigen::Index place(int knot) { return 6 * static_cast<Eigen::Index>(knot); }

inline auto forces_on(const Net& net) {
  return ParticleSystem(level(net), UniformGravity{{0, 0, -g}}, Springs{threads(net)});
}

/// The net's right-hand side. A knot that is nailed down does not change: its rates are 0.
inline auto hanging(const Net& net) {
  return [system = forces_on(net), net](double t, const Knots& y) -> Knots {
    Knots ydot = system.dydt(t, y);
    for (const int nailed : {net.knot(0, 0), net.knot(net.columns - 1, 0)})
      ydot.segment<6>(place(nailed)).setZero();
    return ydot;
  };
}

/// Kinetic, of height, and of stretched threads [J].
inline double energy(const Net& net, const Knots& y) {
  double sum = 0;
  for (int i = 0; i < net.knots(); ++i)
    sum += net.mass * (y.segment<3>(place(i) + 3).squaredNorm() / 2 + g * y[place(i) + 2]);
  for (const Spring& thread : threads(net)) {
    const double length = (y.segment<3>(place(thread.i)) - y.segment<3>(place(thread.j))).norm();
    sum += net.stiffness * (length - net.mesh) * (length - net.mesh) / 2;
  }
  return sum;
}

// ── The net in six moments ──

/// Seen from a little above and from the left, without perspective.
inline Vec2 seen(const Vec3& p) {
  constexpr double sin_a = 0.479, cos_a = 0.878, sin_b = 0.389, cos_b = 0.921;
  return {cos_a * p.x() + sin_a * p.y(), cos_b * p.z() + sin_b * (cos_a * p.y() - sin_a * p.x())};
}

inline std::vector<std::vector<Vec2>> lines_of(const Net& net, const Knots& y) {
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

inline std::string net_figure() {
  constexpr int steps_a_second = 2000;
  const Net net{23, 16, 0.02};
  support::Sketch sketch(690, 420, "a net of springs falls and swings");
  const auto f = hanging(net);
  Knots y = flatten(level(net));
  double then = 0;
  int panel = 0;
  for (const double now : {0., 0.35, 0.55, 0.75, 0.95, 1.2}) {
    if (now > then)
      y = integrate_fixed<Rk4>(f, y, then, now,
                               static_cast<int>(std::lround((now - then) * steps_a_second)));
    then = now;
    const int row = panel / 3, column = panel % 3;
    sketch.look({14. + 230 * column, 72. + 185 * row, 78});
    sketch.curves(lines_of(net, y), {"c0", 0.9});
    for (const int nailed : {net.knot(0, 0), net.knot(net.columns - 1, 0)})
      sketch.dot(seen(y.segment<3>(place(nailed))), "c1", 3.5);
    sketch.words({0, 0}, {-8, -24}, number(now) + " s");
    ++panel;
  }
  return sketch.svg();
}

// ── Energy as a check ──

/// An energy gained [J], if it is one still; below 1e-10 J it is rounding.
inline std::string energy_text(double gained) {
  if (!(std::abs(gained) < 1000)) return "exploded";
  return std::abs(gained) < 1e-10 ? "< 1e-10 J" : error_number(gained) + " J";
}

inline Table net_table() {
  Table table({"steps a second", "Euler", "midpoint", "RK4"});
  const Net net{9, 7, 0};
  const auto f = hanging(net);
  const Knots start = flatten(level(net));
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
