/// @file
/// Steps along the tangent: from curve to curve, and out of a circle.

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "corner.hpp"
#include "methods.hpp"
#include "parts.hpp"

namespace particles_chapter {

namespace {

/// ẏ = y, whose solutions through (0, start) are start eᵗ.
std::vector<Vec2> growth_curve(double start, double from, double to) {
  std::vector<Vec2> line;
  for (int i = 0; i <= 40; ++i) {
    const double t = from + (to - from) * i / 40;
    line.emplace_back(t, start * std::exp(t));
  }
  return line;
}

/// Three steps of Euler's method for ẏ = y, and the solutions that they leave one after the other.
void draw_tangents(Sketch& sketch) {
  constexpr double h = 0.5, start = 0.6;
  double y = start;
  sketch.arrow({0, 0}, {1.75, 0}, {"faint", 1.2});
  sketch.arrow({0, 0}, {0, 2.75}, {"faint", 1.2});
  sketch.words({1.75, 0}, {6, 5}, "t");
  sketch.words({0, 2.75}, {-4, -6}, "y");
  sketch.curve(growth_curve(start, 0, 1.5), {"ink", 2.2});
  sketch.words({1.5, start * std::exp(1.5)}, {8, 6}, "exact");
  for (int i = 0; i < 3; ++i) {
    const double t = h * i, next = y * (1 + h);
    if (i > 0) sketch.curve(growth_curve(y * std::exp(-t), t, 1.5), {"faint", 1.2});
    sketch.curve({{t, y}, {t + h, next}}, {colour_of("Euler"), 2.4});
    sketch.dot({t, y}, colour_of("Euler"), 4);
    y = next;
  }
  sketch.dot({3 * h, y}, colour_of("Euler"), 4);
  sketch.words({3 * h, y}, {8, 12}, "Euler", colour_of("Euler"));
  for (const double t : {0., h, 2 * h, 3 * h}) sketch.curve({{t, 0}, {t, 0.06}}, {"faint", 1.2});
  sketch.words({h / 2, 0}, {0, 20}, "h", "ink", "middle");
}

/// The same for a mass on a spring, in the plane of ω x and v: each tangent leads outwards.
void draw_spiral(Sketch& sketch) {
  std::vector<Vec2> circle;
  for (int i = 0; i <= 80; ++i) {
    const double angle = std::numbers::pi * i / 40;
    circle.emplace_back(std::cos(angle), std::sin(angle));
  }
  sketch.curve(circle, {"ink", 2.2});
  draw_corner(sketch, {-1.5, -1.2}, 0.36, "ω x", "v");
  constexpr double turn = 0.5;  // h ω
  Vec2 at(1, 0);
  sketch.curve({{0, 0}, at}, {"faint", 1.5});
  sketch.words({0.5, 0}, {0, 18}, "1", "ink", "middle");
  for (int i = 0; i < 4; ++i) {
    const Vec2 next = at + turn * Vec2(at.y(), -at.x());
    sketch.curve({at, next}, {colour_of("Euler"), 2.4});
    sketch.dot(at, colour_of("Euler"), 4);
    if (i == 0) {
      sketch.curve({{0, 0}, next}, {"faint", 1.5});
      sketch.words((at + next) / 2, {8, 5}, "h ω", colour_of("Euler"));
      sketch.curve({{0.91, 0}, {0.91, -0.09}, {1, -0.09}}, {"faint", 1.2});
    }
    at = next;
  }
  sketch.dot(at, colour_of("Euler"), 4);
}

}  // namespace

std::string tangents_figure() {
  Sketch sketch(760, 340, "Steps along the tangent, from curve to curve and out of a circle", 16);
  sketch.look({46, 300, 102});
  draw_tangents(sketch);
  sketch.look({560, 168, 112});
  draw_spiral(sketch);
  return sketch.svg();
}

}  // namespace particles_chapter
