/// @file
/// Rays through the wall of a mug, and a triangle as a ray sees it.

#include "common.hpp"
#include "outline.hpp"
#include "parts.hpp"
#include "signs.hpp"

namespace point_sampling_chapter {

namespace {

using support::Sketch;

constexpr double sign_half = 0.02;  // as large as words at the scales of both figures

/// A mug cut open, without its handle; anticlockwise, in its own heights.
const Outline& profile() {
  static const Outline outline{{0, 0},       {1, 0},       {1, 1.1},    {0.86, 1.1},
                               {0.86, 0.16}, {0.14, 0.16}, {0.14, 1.1}, {0, 1.1}};
  return outline;
}

/// The ray, a mark at each crossing, and the sum behind it.
void draw_ray(Sketch& sketch, const Vec2& p, const std::string& where) {
  constexpr double end = 1.18;
  sketch.arrow(p, {end, p.y()}, {"ink", 1.6});
  sketch.dot(p, "ink", 5);
  std::string sum;
  int winding = 0;
  Crossings met;
  add_crossings(met, profile(), p, EdgeRule::one);
  for (const auto& [x, sign] : met) {
    const Vec2 crossing(x, p.y());
    sketch.dot(crossing, colour_of_sign(sign > 0), 5);
    draw_sign(sketch, crossing + Vec2(0.05, 0.05), sign_half, sign > 0);
    sum += (sum.empty() ? "" : " ") + std::string(sign > 0 ? "+" : "−");
    winding += sign;
  }
  sketch.words({end, p.y()}, {12, 6}, sum + "  =  " + number(winding) + ": " + where);
}

void draw_two_axes(Sketch& sketch, const Vec2& corner, double length, const std::string& up) {
  sketch.arrow(corner, corner + Vec2(length, 0), {"faint", 1.4});
  sketch.arrow(corner, corner + Vec2(0, length), {"faint", 1.4});
  sketch.words(corner + Vec2(length, 0), {5, 5}, "x", "faint");
  sketch.words(corner + Vec2(0, length), {-5, -6}, up, "faint");
}

/// Twice the area of a, b, p; positive if they go round anticlockwise.
double turn_of(const Vec2& a, const Vec2& b, const Vec2& p) {
  return (b - a).x() * (p - a).y() - (b - a).y() * (p - a).x();
}

/// The triangle, and the three small ones that the point makes with its edges.
void draw_sides(Sketch& sketch, const std::array<Vec2, 3>& v, const Vec2& p) {
  const std::array<std::string, 3> names{"v₁", "v₂", "v₃"};
  const std::array<Vec2, 3> beside{Vec2(-20, 14), Vec2(8, 14), Vec2(-4, -10)};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2 &a = v[i], &b = v[(i + 1) % 3];
    sketch.curve({a, b, p, a}, {colour_of_sign(turn_of(a, b, p) > 0), 1, 1, 0.2});
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2 &a = v[i], &b = v[(i + 1) % 3];
    draw_sign(sketch, (a + b + p) / 3, sign_half, turn_of(a, b, p) > 0);
    sketch.curve({a, b}, {"ink", 2.2});
    sketch.arrow(a, a + 0.56 * (b - a), {"ink", 2.2});
    sketch.words(a, beside[i], names[i]);
  }
  sketch.dot(p, "ink", 5);
  sketch.words(p, {9, -6}, "p");
}

}  // namespace

std::string rays_figure() {
  Sketch sketch(760, 372, "Three rays and a mug that is cut open");
  sketch.look({168, 336, 280});
  sketch.curve(closed(profile()), {"ink", 1.6, 1, 0.07});
  draw_ray(sketch, {0.07, 0.93}, "in the wall");
  draw_ray(sketch, {0.45, 0.66}, "in the air");
  draw_ray(sketch, {-0.22, 0.39}, "outside");
  draw_ray(sketch, {0.5, 0.08}, "in the bottom");
  draw_two_axes(sketch, {-0.5, 0}, 0.16, "z");
  return sketch.svg();
}

std::string sides_figure() {
  Sketch sketch(760, 330, "On which sides of a triangle's edges a point lies, from above");
  const std::array<Vec2, 3> corners{Vec2(0, 0), Vec2(1.1, 0.15), Vec2(0.45, 1)};
  sketch.look({84, 290, 240});
  draw_sides(sketch, corners, {0.5, 0.42});
  sketch.look({430, 290, 240});
  draw_sides(sketch, corners, {1.12, 0.55});
  draw_two_axes(sketch, {-0.2, 0.72}, 0.16, "y");
  return sketch.svg();
}

}  // namespace point_sampling_chapter
