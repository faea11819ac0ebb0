/// @file
/// The free symmetric top: its two turns, and what goes wrong with them.

#include "common.hpp"
#include "named_bodies.hpp"
#include "parts.hpp"
#include "support/two_axes.hpp"

namespace scene_chapter {

// ── Wobbles ──

namespace {

/// How often a coin's axis goes round while the coin turns once, for a tilt between axis and L.
double wobbles_a_turn(const SymmetricMoments& top, double tilt) {
  const double round = 1 / top.transverse, own = 1 / top.axial - 1 / top.transverse;
  return round / (round + own * std::cos(tilt));
}

}  // namespace

Table wobble_table() {
  Table table({"body", "C/A", "axis 1° off L", "10° off", "45° off"});
  for (const auto& [name, body] :
       {Named{"plate", plate()}, Named{"gear wheel", gear()}, Named{"coin", coin()},
        Named{"tennis ball", ball()}, Named{"pencil", pencil()}}) {
    const SymmetricMoments top = nearest_symmetric_top(body);
    std::vector<std::string> row{name, number(top.axial / top.transverse, 4)};
    for (const double tilt : {1., 10., 45.})
      row.push_back(number(wobbles_a_turn(top, tilt * degree), 4));
    table.add(row);
  }
  return table;
}

// ── Which side ──

namespace {

/// A top with its axis along its z, and L in the world.
struct TopExample {
  double A = 1, C = 0.4;
  Vec3 L = {1, 2, 3};

  /// How fast it turns about its own axis, L · n being along it.
  double own_rate(double along) const { return (1 / C - 1 / A) * along; }
};

/// A formula for the top's orientation at time t.
struct TopFormula {
  std::string name;
  Quat (*at)(const TopExample& top, const Quat& q0, double t);
};

double along_axis(const TopExample& top, const Quat& q0) { return top.L.dot(q0 * Vec3::UnitZ()); }
Quat about_L(const TopExample& top, double t) { return turn(t / top.A * top.L); }
Quat about_z(const TopExample& top, double along, double t) {
  return turn(t * top.own_rate(along) * Vec3::UnitZ());
}

const std::array<TopFormula, 5> top_formulas{
    TopFormula{"(about L) q₀ (about z)",
               [](const TopExample& top, const Quat& q0, double t) {
                 return about_L(top, t) * q0 * about_z(top, along_axis(top, q0), t);
               }},
    {"(about L) (about z) q₀",
     [](const TopExample& top, const Quat& q0, double t) {
       return about_L(top, t) * about_z(top, along_axis(top, q0), t) * q0;
     }},
    {"(about z) q₀ (about L)",
     [](const TopExample& top, const Quat& q0, double t) {
       return about_z(top, along_axis(top, q0), t) * q0 * about_L(top, t);
     }},
    {"L_z in place of L·n",
     [](const TopExample& top, const Quat& q0, double t) {
       return about_L(top, t) * q0 * about_z(top, top.L.z(), t);
     }},
    {"(about ω at the start) q₀", [](const TopExample& top, const Quat& q0, double t) {
       const double along = along_axis(top, q0);
       const Vec3 omega = top.L / top.A + top.own_rate(along) * (q0 * Vec3::UnitZ());
       return turn(t * omega) * q0;
     }}};

}  // namespace

Table sides_table() {
  Table table({"q(t) =", "started at 0°", "1°", "10°", "90°"});
  const TopExample top;
  const Vec3 axis = Vec3(1, -1, 0.5).normalized();
  for (const TopFormula& formula : top_formulas) {
    std::vector<std::string> row{formula.name};
    for (const double angle : {0., 1., 10., 90.}) {
      const Quat q0 = turn(angle * degree * axis);
      double worst = 0;
      for (int i = 1; i <= 20; ++i)
        worst = std::max(worst, angle_between(formula.at(top, q0, 0.05 * i),
                                              top_formulas[0].at(top, q0, 0.05 * i)));
      row.push_back(worst < 1e-14 ? "right" : number(worst, 2) + " rad");
    }
    table.add(row);
  }
  return table;
}

// ── Two cones ──

namespace {

/// The viewer looks along y, from a little above.
Vec2 seen(const Vec3& p) {
  constexpr double above = 17 * degree;
  return {p.x(), std::cos(above) * p.z() + std::sin(above) * p.y()};
}

/// The rim of a cone from the origin about `axis` through `edge`.
std::vector<Vec2> rim(const Vec3& axis, const Vec3& edge) {
  std::vector<Vec2> points;
  for (int i = 0; i <= 60; ++i)
    points.push_back(seen(exp_rotation(Vec3(2 * pi * i / 60 * axis)) * edge));
  return points;
}

/// The two lines from the origin that touch a rim.
std::vector<std::vector<Vec2>> sides(const std::vector<Vec2>& rim, const Vec2& middle) {
  const auto angle = [&](const Vec2& p) {
    return std::atan2(middle.x() * p.y() - middle.y() * p.x(), middle.dot(p));
  };
  const auto [low, high] = std::minmax_element(
      rim.begin(), rim.end(), [&](const Vec2& a, const Vec2& b) { return angle(a) < angle(b); });
  return {{{0, 0}, *low}, {{0, 0}, *high}};
}

void draw_cone(support::Sketch& sketch, const Vec3& axis, const Vec3& edge,
               const std::string& colour) {
  const std::vector<Vec2> round = rim(axis, edge);
  sketch.curve(round, {colour, 1.6, 1, 0.12});
  sketch.curves(sides(round, seen(axis)), {colour, 1.6});
}

/// A top whose axis is `tilt` off L, with the cone that ω draws in the world and that in the body.
void draw_cones(support::Sketch& sketch, double A, double C, double tilt, const std::string& name) {
  const Vec3 L = Vec3::UnitZ(), n(std::sin(tilt), 0, std::cos(tilt));
  const Vec3 omega = (L / A + (1 / C - 1 / A) * L.dot(n) * n).normalized();
  draw_cone(sketch, L, omega, "c0");
  draw_cone(sketch, n, omega, "c1");
  sketch.arrow({0, 0}, 1.5 * seen(L), {"c0", 2.4});
  sketch.arrow({0, 0}, 1.5 * seen(n), {"c1", 2.4});
  sketch.arrow({0, 0}, 1.32 * seen(omega), {"ink", 2.4});
  sketch.words(1.5 * seen(L), {-8, -4}, "L", "c0", "end");
  sketch.words(1.5 * seen(n), {8, 0}, "n", "c1");
  sketch.words(1.32 * seen(omega), {C < A ? 4.0 : -6.0, -8}, "ω", "ink", C < A ? "start" : "end");
  sketch.words({0, 0}, {0, 30}, name, "ink", "middle");
}

}  // namespace

std::string cones_figure() {
  support::Sketch sketch(760, 336, "The two cones of a free symmetric top", 19);
  sketch.look({170, 280, 150});
  draw_cones(sketch, 1, 0.35, 38 * degree, "long: C < A");
  sketch.look({540, 280, 150});
  draw_cones(sketch, 1, 1.9, 38 * degree, "flat: C > A");
  sketch.look({300, 292, 1});
  support::draw_two_axes(sketch, 36, {"x", "z"});
  sketch.words({0, 0}, {-8, 32}, "y: away from you");
  return sketch.svg();
}

}  // namespace scene_chapter
