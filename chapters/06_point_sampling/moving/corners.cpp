/// @file
/// Figure 6.5: a mug that is cut open, and a ray that the reader drags onto its corners.

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "06_point_sampling/moving_figures.hpp"
#include "06_point_sampling/outline.hpp"
#include "06_point_sampling/signs.hpp"

namespace point_sampling_chapter::corners_figure {

namespace {

using tumble::support::Control;
using tumble::support::Drag;
using tumble::support::Settings;
using tumble::support::Sketch;

enum Which { start_x, start_z, rule };
constexpr std::array<Control, 3> controls{
    {{"x", "the ray starts at x", "mm", -18, 112, 1, 36},
     {"z", "and at z", "mm", 1, 95, 1, 32},
     {"rule", "a ray through a corner", "", 0, 2, 1, 0,
      "counts for both segments|counts for none|counts for the upper one"}}};

/// What there is in whole millimetres, so that the ray can hit a corner exactly: the mug with its
/// handle, and the hole of the handle.
const std::array<Outline, 2>& section() {
  static const std::array<Outline, 2> outlines{
      Outline{{14, 0},
              {62, 0},
              {74, 12},
              {76, 28},
              {94, 35},
              {106, 52},
              {98, 72},
              {76, 80},
              {78, 96},
              {67, 96},
              {63, 32},
              {52, 17},
              {24, 17},
              {13, 24},
              {9, 96},
              {-2, 96},
              {2, 12}},
      Outline{{77, 44}, {78, 66}, {91, 62}, {96, 53}, {89, 43}}};
  return outlines;
}

Crossings crossings(const Vec2& p, EdgeRule by) {
  Crossings all;
  for (const Outline& outline : section()) add_crossings(all, outline, p, by);
  return all;
}

bool inside(const Vec2& p, EdgeRule by) { return crossings(p, by).size() % 2 == 1; }

/// The corners on the ray from p.
std::vector<Vec2> corners_on(const Vec2& p) {
  std::vector<Vec2> list;
  for (const Outline& outline : section())
    for (const Vec2& corner : outline)
      if (corner.y() == p.y() && corner.x() > p.x()) list.push_back(corner);
  return list;
}

constexpr tumble::support::Window window{110, 505, 5};
constexpr double right_end = 122;  // of what is shown [mm]

void draw_section(Sketch& sketch) {
  std::vector<std::vector<Vec2>> lines;
  for (const Outline& outline : section()) lines.push_back(closed(outline));
  sketch.curves(lines, {"ink", 1.6, 1, 0.07});
}

/// Points on a grid: blue dots are inside, red ones are put on the wrong side by the rule.
void draw_grid(Sketch& sketch, EdgeRule by) {
  constexpr int spacing = 4;
  std::vector<Vec2> kept, wrong;
  for (int z = spacing; z < 96; z += spacing)
    for (int x = -18; x < 112; x += spacing) {
      const Vec2 p(x, z);
      const bool in = inside(p, EdgeRule::one);
      if (inside(p, by) != in)
        wrong.push_back(p);
      else if (in)
        kept.push_back(p);
    }
  sketch.specks(kept, "c0", 1.8);
  sketch.specks(wrong, "c6", 3.6);
}

/// The ray, and a mark at each crossing: two where a corner counts twice.
void draw_ray(Sketch& sketch, const Vec2& p, const Crossings& met) {
  sketch.arrow(p, {right_end, p.y()}, {"ink", 1.8});
  double last = p.x();
  int here = 0;
  for (const auto& [x, sign] : met) {
    here = x == last ? here + 1 : 0;
    last = x;
    const Vec2 crossing(x, p.y()), beside(3 + 3.2 * here, 2.6);  // clear of rings and wall
    sketch.dot(crossing, colour_of_sign(sign > 0), 5);
    draw_sign(sketch, crossing + beside, 1.2, sign > 0);
  }
  sketch.dot(p, "ink", 7);
}

/// Red rings around the corners that the ray meets.
void draw_rings(Sketch& sketch, const Vec2& p) {
  constexpr double radius = 2.4;  // [mm]
  for (const Vec2& corner : corners_on(p)) {
    std::vector<Vec2> ring;
    for (int i = 0; i <= 24; ++i) {
      const double angle = 2 * std::numbers::pi * i / 24;
      ring.emplace_back(corner + radius * Vec2(std::cos(angle), std::sin(angle)));
    }
    sketch.curve(ring, {"c6", 2});
  }
}

/// What is counted, and whether it is true.
void draw_count(Sketch& sketch, const Vec2& p, EdgeRule by, const Crossings& met) {
  std::string signs;
  int winding = 0;
  for (const auto& [x, sign] : met) {
    signs += sign > 0 ? "+ " : "− ";
    winding += sign;
  }
  const std::string sum = winding < 0 ? "−" + std::to_string(-winding) : std::to_string(winding);
  const bool odd = met.size() % 2 == 1, truth = inside(p, EdgeRule::one);
  sketch.look({0, 0, 1});
  const bool single = met.size() == 1;
  const std::string count =
      met.empty() ? "no" : signs + (single ? "is " : "are ") + std::to_string(met.size());
  sketch.words({110, -545}, {0, 0},
               count + (single ? " crossing, " : " crossings, ") +
                   (odd ? "odd: inside" : "even: outside") + "; the signs add up to " + sum);
  const bool wrong = by != EdgeRule::one && odd != truth;
  sketch.words({110, -573}, {0, 0},
               std::string(wrong ? "Wrong: " : "Right: ") + "the point is " +
                   (truth ? "in the clay." : "not in the clay."),
               wrong ? "c6" : "ink");
}

std::string draw(Settings now) {
  Sketch sketch(760, 590, "A ray through a mug that is cut open, counted by three rules", 18);
  const Vec2 p(now[start_x], now[start_z]);
  const auto by = static_cast<EdgeRule>(now[rule]);
  const Crossings met = crossings(p, by);
  sketch.look(window);
  draw_section(sketch);
  draw_grid(sketch, by);
  draw_ray(sketch, p, met);
  sketch.grip({p});
  draw_rings(sketch, p);
  draw_count(sketch, p, by, met);
  return sketch.svg();
}

void drag(std::span<double> settings, const Drag& pointer) {
  settings[start_x] = allowed(controls[start_x], (pointer.x - window.x) / window.scale);
  settings[start_z] = allowed(controls[start_z], (window.y - pointer.y) / window.scale);
}

}  // namespace
}  // namespace point_sampling_chapter::corners_figure

const tumble::support::MovingFigure tumble::figures::corners{
    "corners", point_sampling_chapter::corners_figure::controls,
    point_sampling_chapter::corners_figure::draw, point_sampling_chapter::corners_figure::drag};
