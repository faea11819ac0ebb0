/// @file
/// A face and its shadow, and the walk round a square with a dent.

#include <cmath>

#include "common.hpp"
#include "dented_square.hpp"
#include "parts.hpp"
#include "support/space_sketch.hpp"

namespace mirtich_chapter {

namespace {

using support::Pen, support::Sketch, support::SpaceSketch;

Vec3 on_the_floor(const Vec3& p) { return {p.x(), p.y(), 0}; }

/// A triangle that leans, its shadow along γ, and its normal with the part along γ.
void draw_face_and_shadow(SpaceSketch& space) {
  const std::vector<Vec3> face{{0.35, 0.25, 0.7}, {1.9, 0.45, 1.3}, {0.75, 1.75, 1.3}};
  std::vector<Vec3> outline = face, shadow;
  outline.push_back(face.front());
  for (const Vec3& p : outline) shadow.push_back(on_the_floor(p));
  space.curve(shadow, {"c1", 1.6, 1, 0.3});
  for (const Vec3& p : face) space.curve({p, on_the_floor(p)}, {"faint", 1});
  space.curve(outline, {"c0", 1.8, 1, 0.3});
  for (std::size_t k = 0; k < 3; ++k) {  // which way round
    const Vec3 &p = outline[k], &q = outline[k + 1];
    space.arrow(p, p + 0.55 * (q - p), {"c0", 1.8});
    space.arrow(on_the_floor(p), on_the_floor(p + 0.55 * (q - p)), {"c1", 1.6});
  }
  const Vec3 middle = (face[0] + face[1] + face[2]) / 3,
             n = mirtich::vector_area(face).normalized();
  const Vec3 up(0, 0, n.z());
  space.curve({middle + n, middle + up}, {"faint", 1});
  space.arrow(middle, middle + up, {"c2", 2.6});
  space.words(middle + up, {10, 4}, "n_γ", "c2", "start");
  space.arrow(middle, middle + n, {"ink", 2.6});
  space.words(middle + n, {-8, -4}, "n", "ink", "end");
  space.words(on_the_floor(middle), {0, 6}, "shadow", "c1");
  space.words(face[1], {10, 4}, "face", "c0", "start");
}

/// The same from the side: lengths a, and a/n_γ over it.
void draw_from_the_side(Sketch& sketch) {
  const Vec2 low(0, 0.7), high(1.5, 1.8), along = (high - low).normalized();
  const Vec2 n(-along.y(), along.x()), foot = low + 0.35 * (high - low);
  const Vec2 a = low + 0.55 * (high - low), b = low + 0.8 * (high - low);
  sketch.curve({{-0.15, 0}, {1.75, 0}}, {"faint", 1.2});
  for (const Vec2& p : {a, b}) sketch.curve({p, {p.x(), 0}}, {"faint", 1});
  sketch.curve({low, high}, {"c0", 1.8});
  sketch.curve({a, b}, {"c0", 5});
  sketch.curve({{a.x(), 0}, {b.x(), 0}}, {"c1", 5});
  sketch.words((a + b) / 2, {30, 30}, "dA", "c0");
  sketch.words({(a.x() + b.x()) / 2, 0}, {0, 26}, "n_γ dA", "c1", "middle");
  const Vec2 tip = foot + 0.9 * n, up = foot + Vec2(0, 0.9 * n.y());
  sketch.curve({tip, up}, {"faint", 1});
  sketch.arrow(foot, up, {"c2", 2.6});
  sketch.words(up, {9, 2}, "n_γ", "c2");
  sketch.arrow(foot, tip, {"ink", 2.6});
  sketch.words(tip, {-6, -5}, "n", "ink", "end");
}

/// One edge of the walk: blue up, orange down, grey level.
void draw_edge(Sketch& sketch, std::size_t k) {
  const auto [p, q] = edge_of_dented_square(k);
  const double rise = q.y() - p.y();
  const std::string colour = rise > 0 ? "c0" : rise < 0 ? "c1" : "faint";
  sketch.curve({p, q}, {colour, 3});
  sketch.arrow(p, p + 0.56 * (q - p), {colour, 3});
  const std::string sign = rise > 0 ? "+" : rise < 0 ? "−" : "";
  const Vec2 beside = rise < 0 ? Vec2(-14, 5) : rise > 0 ? Vec2(18, 5) : Vec2(0, k == 0 ? 26 : -12);
  sketch.words((p + q) / 2, beside, "Δβ = " + sign + number(std::abs(rise)), colour,
               rise < 0   ? "end"
               : rise > 0 ? "start"
                          : "middle");
}

/// Where a corner's coordinates are [px].
void name_corner(Sketch& sketch, const Vec2& p) {
  const bool left = p.x() == 0, low = p.y() == 0;
  sketch.dot(p, "ink", 4);
  if (p.x() == 2) return sketch.words(p, {-10, 6}, corner_text(p), "ink", "end");
  sketch.words(p, {left ? -8.0 : 8.0, low ? 18.0 : -6.0}, corner_text(p), "ink",
               left ? "end" : "start");
}

}  // namespace

std::string shadow_figure() {
  Sketch sketch(760, 420, "A face and its shadow, in space and from the side", 19);
  sketch.look({120, 320, 132});
  SpaceSketch space(sketch, support::view_from(-62 * degree, 24 * degree));
  draw_face_and_shadow(space);
  const Pen pen{"ink", 1.5};
  space.axes(Vec3::Zero(), Vec3(2.1, 0.6, 2.1).asDiagonal(), {"α", "β", "γ"}, {pen, pen, pen});
  sketch.look({515, 350, 140});
  draw_from_the_side(sketch);
  return sketch.svg();
}

std::string walk_figure() {
  Sketch sketch(680, 380, "Once round a square with a dent", 19);
  sketch.look({150, 320, 66});
  std::vector<Vec2> outline = dented_square;
  outline.push_back(outline.front());
  sketch.curve(outline, {"faint", 0.5, 1, 0.15});
  for (std::size_t k = 0; k < dented_square.size(); ++k) draw_edge(sketch, k);
  for (const Vec2& p : dented_square) name_corner(sketch, p);
  sketch.look({560, 320, 1});
  sketch.arrow({0, 0}, {52, 0}, {"ink", 1.5});
  sketch.arrow({0, 0}, {0, 52}, {"ink", 1.5});
  sketch.words({52, 0}, {8, 5}, "α");
  sketch.words({0, 52}, {-4, -8}, "β");
  return sketch.svg();
}

}  // namespace mirtich_chapter
