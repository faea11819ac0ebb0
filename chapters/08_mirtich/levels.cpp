/// @file
/// Rods through a body, and shadows that are cast along the wrong axis.

#include <cmath>

#include "common.hpp"
#include "parts.hpp"

namespace mirtich_chapter {

// ── Rods ──

namespace {

/// An outline with dents, counter-clockwise.
std::vector<Vec2> potato() {
  std::vector<Vec2> line;
  for (int i = 0; i <= 120; ++i) {
    const double t = 3 * degree * i;
    const double r = 1 + 0.30 * std::cos(2 * t + 2.6) + 0.22 * std::sin(3 * t + 0.7);
    line.emplace_back(1.25 * r * std::cos(t), r * std::sin(t));
  }
  return line;
}

/// Where the outline crosses the height y, and whether a rod along x leaves the body there.
struct RodEnd {
  double x;
  bool leaves;
};

std::vector<RodEnd> rod_ends(const std::vector<Vec2>& line, double y) {
  std::vector<RodEnd> ends;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Vec2 &p = line[i - 1], &q = line[i];
    if ((p.y() < y) == (q.y() < y)) continue;
    ends.push_back({p.x() + (q.x() - p.x()) * (y - p.y()) / (q.y() - p.y()), q.y() > p.y()});
  }
  std::sort(ends.begin(), ends.end(), [](const RodEnd& a, const RodEnd& b) { return a.x < b.x; });
  return ends;
}

void draw_rods(support::Sketch& sketch) {
  const std::vector<Vec2> line = potato();
  sketch.curve(line, {"ink", 2, 1, 0.06});
  constexpr double half = 0.05;
  for (const double y : {-0.85, -0.5, -0.15, 0.2, 0.55, 0.9}) {
    const std::vector<RodEnd> ends = rod_ends(line, y);
    for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
      const double a = ends[i].x, b = ends[i + 1].x;
      sketch.curve({{a, y - half}, {b, y - half}, {b, y + half}, {a, y + half}, {a, y - half}},
                   {"faint", 0.8, 1, 0.25});
    }
    for (const RodEnd& end : ends) sketch.dot({end.x, y}, end.leaves ? "c0" : "c1", 5.5);
  }
  sketch.words({-1.75, -1.62}, {0, 0}, "enters: − F(x)", "c1");
  sketch.words({0.1, -1.62}, {0, 0}, "leaves: + F(x)", "c0");
}

/// The end of one rod, enlarged: a piece of the surface that leans.
void draw_rod_end(support::Sketch& sketch) {
  const Vec2 low(0.15, -0.5), high(-0.35, 0.5), along = high - low;
  sketch.curve({{-1.6, -0.5}, low, high, {-1.6, 0.5}}, {"faint", 1, 1, 0.25});
  sketch.curve({low - 0.5 * along, high + 0.5 * along}, {"ink", 2});
  sketch.curve({low, high}, {"c0", 4});
  const Vec2 middle = (low + high) / 2, n = Vec2(along.y(), -along.x()).normalized();
  sketch.arrow(middle, middle + 0.85 * n, {"c0", 2});
  sketch.words(middle + 0.85 * n, {6, 4}, "n", "c0");
  sketch.curve({{-1.75, -0.5}, {-1.75, 0.5}}, {"ink", 1.5});
  sketch.words({-1.75, 0}, {-8, 6}, "dy", "ink", "end");
  sketch.words(low, {14, 0}, "dA", "c0");
  sketch.words({-0.75, -1.15}, {0, 0}, "dy = n_x dA", "ink", "middle");
}

}  // namespace

std::string rods_figure() {
  support::Sketch sketch(760, 400, "A body cut into rods along x", 19);
  sketch.look({235, 175, 125});
  draw_rods(sketch);
  sketch.look({665, 185, 85});
  draw_rod_end(sketch);
  sketch.look({470, 378, 1});
  sketch.arrow({0, 0}, {46, 0}, {"ink", 1.5});
  sketch.arrow({0, 0}, {0, 46}, {"ink", 1.5});
  sketch.words({46, 0}, {8, 5}, "x");
  sketch.words({0, 46}, {-4, -8}, "y");
  return sketch.svg();
}

// ── The wrong axis ──

namespace {

/// The largest relative error of ∬ zᵏ dA, k = 1, 2, 3, when shadows are cast along z, over some
/// triangles whose normal has n_z = lean. Along x the same integrals are right to rounding.
std::array<double, 3> worst_errors(double lean) {
  Random random(8);
  std::array<double, 3> worst{};
  for (int i = 0; i < 50; ++i) {
    const Vec3 n(std::sqrt(1 - lean * lean), 0, lean), across = Vec3::UnitY();
    const Vec3 down = n.cross(across), middle(2, 1, 3);
    std::vector<Vec3> corners;
    for (int k = 0; k < 3; ++k) {
      const double angle = 120 * degree * k + random.uniform(0, 1), r = random.uniform(0.5, 1);
      corners.push_back(middle + r * (std::cos(angle) * across + std::sin(angle) * down));
    }
    const mirtich::Plane plane = mirtich::plane_of(corners, mirtich::vector_area(corners));
    const auto along = [&](int axis) {
      return mirtich::face_integrals(mirtich::projection_integrals(corners, axis), plane, axis);
    };
    const auto z = along(2), x = along(0);  // z is γ for the one, β for the other
    const std::array<double, 3> errors{z.c / x.b - 1, z.cc / x.bb - 1, z.ccc / x.bbb - 1};
    for (std::size_t k = 0; k < 3; ++k) worst[k] = std::max(worst[k], std::abs(errors[k]));
  }
  return worst;
}

}  // namespace

Table axis_table() {
  Table table({"n_z", "∬ z dA", "∬ z² dA", "∬ z³ dA"});
  for (const double lean : {0.5, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5}) {
    const std::array<double, 3> worst = worst_errors(lean);
    table.add({number(lean), error_or_rounding(worst[0]), error_or_rounding(worst[1]),
               error_or_rounding(worst[2])});
  }
  return table;
}

}  // namespace mirtich_chapter
