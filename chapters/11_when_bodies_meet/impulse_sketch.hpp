#pragma once
/// @file
/// The plane of all impulses that a rod's tip could get, with those of two laws and of a reader.

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "11_when_bodies_meet/impulse_plane.hpp"
#include "11_when_bodies_meet/laws.hpp"
#include "support/sketch.hpp"

namespace contact_chapter::impulses_figure {

/// What two laws make of an impact, and a reader's function if it was asked.
struct Answers {
  PlanarResult usual, ours;
  double usual_left, ours_left;  ///< of ½ uᵀK⁻¹u
  std::optional<PlanarResult> readers = {};
  double readers_left = 0;

  /// Where the usual law has more energy than there was, it is drawn in red.
  std::string usual_colour() const { return usual_left > 1 + 1e-9 ? "c6" : "c1"; }
};

/// @param readers the impulse of the reader's function, if there is one
inline Answers answers_of(const PlanarImpact& impact, const std::optional<Vec2>& readers) {
  const PlanarResult usual = usual_law(impact), ours = stronge_law(impact);
  const auto left = [&, stake = energy_at_stake(impact)](const PlanarResult& result) {
    return 1 + energy_change(impact, result) / stake;
  };
  Answers answers{usual, ours, left(usual), left(ours)};
  if (!readers) return answers;
  answers.readers = with_impulse(impact, *readers);
  answers.readers_left = left(*answers.readers);
  return answers;
}

constexpr const char* readers_colour = "c5";
constexpr double plane_left = 420, plane_right = 745, plane_top = 40, plane_bottom = 395;

/// All of the curve and both ends, as large as there is room.
inline support::Window window_of(const std::vector<Vec2>& curve, const Answers& answers) {
  Extent all{curve[0], curve[0]};
  for (const Vec2& point : curve) all.hold(point);
  for (const Vec2& point : {Vec2(0, 0), answers.usual.impulse, answers.ours.impulse})
    all.hold(point);
  if (answers.readers) all.hold(answers.readers->impulse);
  const Vec2 room(plane_right - plane_left - 40, plane_bottom - plane_top - 40);
  const double scale = room.cwiseQuotient(all.size()).minCoeff();
  const Vec2 middle = scale * all.middle();
  return {(plane_left + plane_right) / 2 - middle.x(), (plane_top + plane_bottom) / 2 + middle.y(),
          scale};
}

/// The part of the plane that is seen.
inline Extent seen(const support::Window& window) {
  return {{(plane_left - window.x) / window.scale, (window.y - plane_bottom) / window.scale},
          {(plane_right - window.x) / window.scale, (window.y - plane_top) / window.scale}};
}

/// Where nothing slips, and where the bodies come together no more.
inline void draw_lines(support::Sketch& sketch, const PlanarImpact& impact, const Extent& seen) {
  const std::vector<Vec2> sticking = line_within(impact.K.row(0), impact.u.x(), seen),
                          closest = line_within(impact.K.row(1), impact.u.y(), seen);
  if (!sticking.empty()) {
    sketch.curve(sticking, {"c0", 1.6});
    const Vec2& top = sticking[0].y() > sticking[1].y() ? sticking[0] : sticking[1];
    sketch.words(top, {22, -8}, "sticking", "c0", "end");
  }
  if (!closest.empty()) {
    sketch.curve(closest, {"c3", 1.6});
    const Vec2& right = closest[0].x() > closest[1].x() ? closest[0] : closest[1];
    sketch.words(right, {-4, 22}, "compressed", "c3", "end");
  }
}

/// Friction can't be more than μ times the normal impulse.
inline void draw_cone(support::Sketch& sketch, double mu, const Extent& seen) {
  const double high = seen.high.y(), right = std::min(mu * high, seen.high.x()),
               left = std::max(-mu * high, seen.low.x());
  std::vector<Vec2> cone{{0, 0}};
  if (mu * high > seen.high.x()) cone.emplace_back(right, right / mu);
  cone.insert(cone.end(), {{right, high}, {left, high}});
  if (-mu * high < seen.low.x()) cone.emplace_back(left, -left / mu);
  cone.emplace_back(0, 0);
  sketch.curve(cone, {"c4", 1.2, 1, 0.1});
  if (mu > 0) sketch.words({(left + right) / 2, high}, {0, 20}, "cone", "c4", "middle");
}

/// The library's impulse while it grows, with a dot where the slip ends.
inline void draw_path(support::Sketch& sketch, const PlanarImpact& impact,
                      const PlanarResult& ours) {
  const ContactPath path(impact);
  const double end = ours.impulse.y();
  std::vector<Vec2> points{{0, 0}};
  if (path.rest() < end) points.push_back(path.impulse(path.rest()));
  points.push_back(ours.impulse);
  sketch.curve(points, {"c2", 3});
  if (points.size() == 3) sketch.dot(points[1], "ink", 4);
  sketch.dot(ours.impulse, "c2", 6);
}

inline void draw_plane(support::Sketch& sketch, const PlanarImpact& impact,
                       const Answers& answers) {
  const std::vector<Vec2> curve = lossless(impact);
  const support::Window window = window_of(curve, answers);
  const Extent extent = seen(window);
  sketch.look(window);
  sketch.frame(extent.low, extent.high, {"grid", 1});
  sketch.curves(
      {{{extent.low.x(), 0}, {extent.high.x(), 0}}, {{0, extent.low.y()}, {0, extent.high.y()}}},
      {"faint", 1});
  draw_cone(sketch, impact.mu, extent);
  sketch.curve(curve, {"ink", 1.6, 0.8});
  draw_lines(sketch, impact, extent);
  sketch.curve({{0, 0}, answers.usual.impulse}, {answers.usual_colour(), 2, 0.8});
  draw_path(sketch, impact, answers.ours);
  sketch.dot(answers.usual.impulse, answers.usual_colour(), 6);
  if (answers.readers) sketch.dot(answers.readers->impulse, readers_colour, 4);
  sketch.look({0, 0, 1});
  sketch.words({plane_left, -plane_top}, {0, -8}, "↑ normal", "faint");
  sketch.words({plane_right, -plane_bottom}, {0, 22}, "impulse along the floor →", "faint", "end");
}

}  // namespace contact_chapter::impulses_figure
