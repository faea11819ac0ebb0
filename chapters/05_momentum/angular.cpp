/// @file
/// Angular momentum and angular velocity: how far apart they point, and what each has of a motion.

#include <array>
#include <cmath>

#include "common.hpp"
#include "parts.hpp"
#include "thrown_objects.hpp"

namespace momentum_chapter {

// ── Two masses on a rod ──

namespace {

/// At the angle from the axle that it is welded to, in the plane of the picture.
constexpr double lean = 45 * degree;

/// An arrow along the line of sight: its point, or its feathers.
void draw_arrow_mark(support::Sketch& sketch, const Vec2& p, bool towards_viewer,
                     const std::string& colour = "c2") {
  sketch.curve(circle(p, 0.12), {colour, 2});
  if (towards_viewer) {
    sketch.dot(p, colour, 3);
  } else {
    const double d = 0.085;
    sketch.curves({{p + Vec2(-d, -d), p + Vec2(d, d)}, {p + Vec2(-d, d), p + Vec2(d, -d)}},
                  {colour, 2});
  }
}

/// Seen from the side, the axle upright; `side` is +1 or, half a turn later, −1.
void draw_dumbbell(support::Sketch& sketch, double side, const std::string& caption) {
  const Vec2 along(side * std::sin(lean), std::cos(lean));
  const Vec2 L(-side * std::cos(lean), std::sin(lean));
  sketch.curve({{0, -1.45}, {0, 1.15}}, {"faint", 6});
  sketch.curve({-along, along}, {"ink", 3});
  for (const double end : {-1., 1.}) {
    sketch.disc(end * along, 0.15, "solid");
    draw_arrow_mark(sketch, end * along * 1.34, end * side < 0);
  }
  sketch.arrow({0, 0}, {0, 1.45}, {"c1", 3});
  sketch.words({0, 1.45}, {8, 4}, "ω", "c1");
  const std::string outside = side > 0 ? "end" : "start";
  sketch.arrow({0, 0}, 1.3 * L, {"c0", 3});
  sketch.words(0.75 * L, {side > 0 ? -8. : 8., 20}, "L", "c0", outside);
  draw_arrow_mark(sketch, 1.5 * L, side > 0, "c3");
  sketch.words(1.5 * L, {side > 0 ? -20. : 20., 6}, "ω × L", "c3", outside);
  sketch.words({0, -1.45}, {0, 26}, caption, "ink", "middle");
}

}  // namespace

std::string askew_figure() {
  support::Sketch sketch(760, 390, "Two masses on a leaning rod: L is not along ω");
  sketch.look({250, 178, 112});
  draw_dumbbell(sketch, 1, "now");
  sketch.look({510, 178, 112});
  draw_dumbbell(sketch, -1, "half a turn later");
  sketch.look({40, 360, 1});
  sketch.arrow({0, 0}, {44, 0}, {"ink", 1.5});
  sketch.words({44, 0}, {8, 5}, "x");
  sketch.arrow({0, 0}, {0, 44}, {"ink", 1.5});
  sketch.words({0, 44}, {0, -8}, "z", "ink", "middle");
  return sketch.svg();
}

// ── How far apart they can point ──

Table apart_table() {
  Table table({"object", "principal moments [kg m²]", "as a ratio", "L and ω apart, at worst"});
  for (std::size_t i = 0; i < object_names.size(); ++i) {
    const Vec3 moments = principal_axes(properties_of(objects::all[i]).inertia).moments;
    const Vec3 ratio = moments / moments[0];
    const auto three = [](const Vec3& v, int digits) {
      return number(v[0], digits) + ", " + number(v[1], digits) + ", " + number(v[2], digits);
    };
    table.add({object_names[i], three(moments, 2),
               "1 : " + support::svg_number(ratio[1], 2) + " : " + support::svg_number(ratio[2], 2),
               degrees(std::asin((ratio[2] - 1) / (ratio[2] + 1)), 2)});
  }
  return table;
}

// ── Of the centre, and about it ──

namespace {

/// Something that goes round on a circle, and spins.
struct Circling {
  std::string name;
  double mass, radius, period;  ///< of the way of its centre [kg], [m], [s]
  double inertia, day;          ///< about its own axis [kg m²], and the time of a turn [s]
};

}  // namespace

Table split_table() {
  constexpr double earth = 5.972e24, earth_radius = 6.378e6, moon = 7.346e22, moon_radius = 1.737e6;
  constexpr double sidereal_day = 86164, year = 365.256 * 86400, month = 27.3217 * 86400;
  const std::array<Circling, 3> list{
      Circling{"hammer, 7.26 kg, about the thrower", 7.26, 1.8, 0.4, 0.0105, 0.4},
      {"Moon about the Earth", moon, 3.844e8, month, 0.393 * moon * moon_radius * moon_radius,
       month},
      {"Earth about the Sun", earth, 1.496e11, year, 0.3307 * earth * earth_radius * earth_radius,
       sidereal_day}};
  Table table({"what goes round", "x × P [kg m²/s]", "L [kg m²/s]", "½ P·v [J]", "½ L·ω [J]"});
  for (const Circling& body : list) {
    const double v = 2 * pi * body.radius / body.period, omega = 2 * pi / body.day;
    const auto text = [](double value) { return number(value, 2); };
    table.add({body.name, text(body.radius * body.mass * v), text(body.inertia * omega),
               text(body.mass * v * v / 2), text(body.inertia * omega * omega / 2)});
  }
  return table;
}

}  // namespace momentum_chapter
