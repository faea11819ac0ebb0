/// @file
/// What a formula cannot show: the column y and its rates, who asks whom, and a spring.

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "corner.hpp"
#include "parts.hpp"

namespace particles_chapter {

// ── y as a column ──

namespace {

/// Three boxes below each other and, if given, what holds their places.
void draw_triple(Sketch& sketch, const Vec2& top, const std::string& name,
                 const std::string& colour, int first_place) {
  constexpr double width = 74, height = 27;
  for (int i = 0; i < 3; ++i) {
    const Vec2 low = top - Vec2(0, height * (i + 1));
    sketch.frame(low, low + Vec2(width, height), {colour, 1.5, 1, 0.1});
    sketch.words(low + Vec2(width / 2, height / 2), {0, 5}, name + std::string(" ") + "xyz"[i],
                 "ink", "middle");
    if (first_place >= 0)
      sketch.words(low + Vec2(0, height / 2), {-8, 5}, std::to_string(first_place + i), "faint",
                   "end");
  }
}

/// A particle with the arrows of its position and velocity.
void draw_particle(Sketch& sketch, const Vec2& at, const Vec2& velocity, const std::string& index,
                   const Vec2& beside) {
  sketch.arrow({0, 0}, at, {"c0", 2.2});
  sketch.words(at / 2, beside, "x" + index, "c0", "middle");
  sketch.arrow(at, at + velocity, {"c1", 2.2});
  sketch.words(at + velocity, {8, 4}, "v" + index, "c1");
  sketch.dot(at, "ink", 6);
}

}  // namespace

std::string column_figure() {
  Sketch sketch(760, 420, "Two particles, their numbers in one column, and the rates of these", 16);
  sketch.look({52, 362, 1});
  draw_corner(sketch, {0, 0}, 64, "x", "z");
  draw_particle(sketch, {96, 226}, {74, 36}, "₀", {-16, -2});
  draw_particle(sketch, {214, 92}, {50, -56}, "₁", {2, 22});
  sketch.look({0, 0, 1});
  const std::array<const char*, 4> numbers{"x₀", "v₀", "x₁", "v₁"},
      rates{"v₀", "F₀/m₀ ", "v₁", "F₁/m₁ "};
  for (int i = 0; i < 4; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double y = -48. - 88 * i;
    draw_triple(sketch, {430, y}, numbers[k], i % 2 == 0 ? "c0" : "c1", 3 * i);
    draw_triple(sketch, {610, y}, rates[k], i % 2 == 0 ? "c1" : "c2", -1);
    sketch.arrow({600, y - 40}, {512, y - 40}, {"faint", 1.4});
    sketch.words({556, y - 40}, {0, -7}, "rate of", "faint", "middle");
  }
  sketch.words({467, -48}, {0, -14}, "y", "ink", "middle");
  sketch.words({647, -48}, {0, -14}, "ẏ", "ink", "middle");
  return sketch.svg();
}

// ── Who asks whom ──

namespace {

void draw_box(Sketch& sketch, const Vec2& low, const Vec2& high, const std::string& title,
              const std::string& below, const std::string& colour) {
  sketch.frame(low, high, {colour, 1.8, 1, 0.08});
  sketch.words((low + high) / 2, {0, -4}, title, "ink", "middle");
  sketch.words((low + high) / 2, {0, 18}, below, colour, "middle");
}

void draw_flow(Sketch& sketch, const Vec2& from, const Vec2& to, const Vec2& offset,
               const std::string& words, const std::string& anchor) {
  sketch.arrow(from, to, {"ink", 1.8});
  sketch.words((from + to) / 2, offset, words, "ink", anchor);
}

}  // namespace

std::string asks_figure() {
  Sketch sketch(760, 250, "A solver and a right-hand side", 16);
  sketch.look({0, 250, 1});
  draw_box(sketch, {190, 156}, {570, 226}, "solver: Euler, midpoint, RK4 …",
           "knows columns of numbers, and no physics", "c0");
  draw_box(sketch, {190, 24}, {570, 94}, "dydt: weight, drag, springs …",
           "knows the physics, and no steps", "c1");
  draw_flow(sketch, {24, 191}, {186, 191}, {0, -9}, "y now, and h", "middle");
  draw_flow(sketch, {574, 191}, {736, 191}, {0, -9}, "y after the step", "middle");
  draw_flow(sketch, {320, 154}, {320, 98}, {-10, 5}, "t, y", "end");
  draw_flow(sketch, {440, 98}, {440, 154}, {10, 5}, "ẏ", "start");
  sketch.words({380, 125}, {0, 5}, "how fast?", "faint", "middle");
  return sketch.svg();
}

// ── A spring ──

namespace {

/// A coil with straight ends.
std::vector<Vec2> coil(const Vec2& from, const Vec2& to, int turns, double width) {
  const Vec2 along = to - from, aside = Vec2(-along.y(), along.x()).normalized() * width;
  std::vector<Vec2> line{from};
  for (int i = 0; i <= 24 * turns; ++i) {
    const double part = i / (24. * turns);
    line.push_back(from + along * (0.12 + 0.76 * part) +
                   aside * std::sin(2 * std::numbers::pi * turns * part));
  }
  line.push_back(to);
  return line;
}

const Vec2 spring_j(0, 0), spring_i(2.4, 1.2);

/// The two ends and the coil between them.
void draw_spring(Sketch& sketch) {
  sketch.curve(coil(spring_j, spring_i, 9, 0.1), {"faint", 1.6});
  sketch.dot(spring_j, "ink", 6);
  sketch.dot(spring_i, "ink", 6);
}

void named_arrow(Sketch& sketch, const Vec2& from, const Vec2& along, const std::string& colour,
                 const std::string& name, const Vec2& beside) {
  sketch.arrow(from, from + along, {colour, 2.4});
  sketch.words(from + along, beside, name, colour, "middle");
}

}  // namespace

std::string spring_figure() {
  Sketch sketch(760, 340, "A stretched spring: its vector, its direction and its forces", 16);
  const Vec2 u = (spring_i - spring_j).normalized(), aside(-u.y(), u.x());
  sketch.look({84, 250, 96});
  draw_corner(sketch, {-0.45, -0.7}, 0.4, "x", "z");
  draw_spring(sketch);
  sketch.words(spring_j, {-16, -6}, "j", "ink", "middle");
  sketch.words(spring_i, {16, 2}, "i", "ink", "middle");
  named_arrow(sketch, spring_j + 0.3 * aside, spring_i - spring_j, "c0", "l", {-16, -2});
  named_arrow(sketch, spring_j + 0.62 * aside, 0.85 * u, "c2", "u", {-10, -6});
  named_arrow(sketch, spring_j - 0.28 * aside, 0.75 * u, "c1", "+T u", {4, 26});
  named_arrow(sketch, spring_i - 0.28 * aside, -0.75 * u, "c1", "−T u", {24, 26});
  sketch.look({425, 250, 96});
  draw_spring(sketch);
  sketch.words(spring_j, {-16, -6}, "j", "ink", "middle");
  sketch.words(spring_i, {4, 26}, "i", "ink", "middle");
  const Vec2 rate = 0.62 * u + 0.8 * aside;
  sketch.curve({spring_i + 0.62 * u, spring_i + rate, spring_i + 0.8 * aside}, {"faint", 1.2});
  sketch.arrow(spring_i, spring_i + 0.8 * aside, {"c5", 2.4});
  sketch.words(spring_i + 0.8 * aside, {-8, 6}, "only turns", "c5", "end");
  sketch.arrow(spring_i, spring_i + 0.62 * u, {"c2", 2.4});
  sketch.words(spring_i + 0.62 * u, {8, 33}, "stretches", "c2", "middle");
  sketch.arrow(spring_i, spring_i + rate, {"c3", 2.4});
  sketch.words(spring_i + rate, {0, -8}, "vᵢ − vⱼ", "c3", "middle");
  return sketch.svg();
}

}  // namespace particles_chapter
