/// @file
/// The rod: how its tip answers to impulses, and what two laws make of the same impact.

#include "common.hpp"
#include "laws.hpp"
#include "parts.hpp"
#include "rod_sketch.hpp"
#include "support/two_axes.hpp"

namespace contact_chapter {

namespace {

/// All that K makes of impulses of one size.
std::vector<Vec2> answers_to_circle(const Mat2& K, double size) {
  std::vector<Vec2> points;
  for (int i = 0; i <= 120; ++i) {
    const double angle = 2 * pi * i / 120;
    points.emplace_back(K * Vec2(size * std::cos(angle), size * std::sin(angle)));
  }
  return points;
}

}  // namespace

std::string answers_figure() {
  Sketch sketch(760, 440, "A rod is hit at its end: the end's velocity changes by K j");
  sketch.look({330, 240, 170});
  const Mat2 K = tip_of_rod(30 * degree);
  constexpr double size = 0.3;
  draw_rod(sketch, 30 * degree);
  sketch.curve(answers_to_circle(Mat2::Identity(), size), {"c1", 1.4, 1, 0.08});
  sketch.curve(answers_to_circle(K, size), {"c0", 1.6, 1, 0.06});
  const Vec2 j(0, size), answer = K * j;
  sketch.arrow({0, 0}, answer, {"c0", 2.8});
  sketch.words(answer, {8, -10}, "K j", "c0");
  sketch.arrow({0, 0}, j, {"c1", 2.8});
  sketch.words(j, {9, 24}, "j", "c1");
  sketch.words({std::sqrt(3.), 1}, {16, 6}, "rod", "ink");
  sketch.words({0.9, -0.75}, {0, 0}, "all j of the same size", "c1");
  sketch.words({0.9, -0.92}, {0, 0}, "and what they do: K j", "c0");
  sketch.look({60, 400, 60});
  support::draw_two_axes(sketch, 1, {"x", "z"});
  return sketch.svg();
}

namespace {

/// A velocity at the tip, with two lines of words beside its end.
void draw_velocity(Sketch& sketch, const Vec2& u, const std::string& colour,
                   const std::string& first, const std::string& second) {
  sketch.arrow({0, 0}, u, {colour, 2.8});
  const bool beside = std::abs(u.x()) < 0.5;  // else above its end
  const Vec2 offset(beside ? 14 : 0, beside ? -8 : -30);
  sketch.words(u, offset, first, colour, beside ? "start" : "middle");
  sketch.words(u, offset + Vec2(0, 20), second, colour, beside ? "start" : "middle");
}

}  // namespace

std::string rod_figure() {
  Sketch sketch(760, 430, "A rod hits the floor: the velocity of its tip, before and after");
  sketch.look({330, 225, 170});
  const PlanarImpact rod = hook_rod();
  const double stake = energy_at_stake(rod);
  const auto gain = [&](const PlanarResult& after) {
    return "energy " + percent(energy_change(rod, after) / stake);
  };
  const PlanarResult usual = usual_law(rod), ours = stronge_law(rod);
  draw_floor(sketch, -1.7, 2.3);
  draw_rod(sketch, 30 * degree);
  draw_velocity(sketch, rod.u, "ink", "u, before", "(0.2, −1) m/s");
  draw_velocity(sketch, usual.u, "c6", "tutorials", gain(usual));
  draw_velocity(sketch, ours.u, "c2", "slip followed", gain(ours));
  sketch.look({60, 400, 60});
  support::draw_two_axes(sketch, 1, {"x", "z"});
  return sketch.svg();
}

}  // namespace contact_chapter
