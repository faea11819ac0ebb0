#pragma once
/// @file
/// The ways of the tip of L on its sphere, in the body: polhodes.

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "reference/polhode_round.hpp"
#include "support/sphere_curves.hpp"

namespace rigid_body_chapter {

using namespace tumble;
using support::sphere_view;
using support::Vec2;
using support::visible;
using support::Way;

/// The way that leads through a direction of L.
inline std::vector<Vec3> way_through(const Vec3& moments, const Vec3& direction) {
  return reference::polhode_round(moments, direction, 72, 0.5);
}

/// The two circles through the middle axis that part the ways, L₁²(1/A − 1/B) = L₃²(1/B − 1/C).
inline std::vector<Way> parting_circles(const Vec3& moments) {
  const Vec3 inverse = moments.cwiseInverse();
  const double slope = std::sqrt((inverse[0] - inverse[1]) / (inverse[1] - inverse[2]));
  std::vector<Way> ways;
  for (const double sign : {1., -1.}) {
    const Vec3 across = Vec3(1, 0, sign * slope).normalized();
    Way way{{}, {"c1", 2.4}};
    for (int i = 0; i <= 72; ++i) {
      const double angle = 2 * std::numbers::pi * i / 72;
      way.points.push_back(std::cos(angle) * Vec3::UnitY() + std::sin(angle) * across);
    }
    ways.push_back(way);
  }
  return ways;
}

/// Ways about the least axis (blue) and about the largest (green), and what parts them.
inline std::vector<Way> ways_of(const Vec3& moments) {
  std::vector<Way> ways;
  for (const double side : {1., -1.})
    for (const double angle : {18., 36., 54., 72., 85.}) {
      // From the least axis towards the middle one: all of them are about the least axis.
      const double a = angle * std::numbers::pi / 180;
      ways.push_back({way_through(moments, {side * std::cos(a), std::sin(a), 0}), {"c0", 1.5}});
      ways.push_back({way_through(moments, {0, std::sin(a), side * std::cos(a)}), {"c2", 1.5}});
    }
  for (const Way& way : parting_circles(moments)) ways.push_back(way);
  return ways;
}

inline void draw_sphere(support::Sketch& sketch, const Vec3& moments, const std::string& name) {
  const Mat3 view = sphere_view();
  std::vector<Vec2> rim;
  for (int i = 0; i <= 90; ++i)
    rim.emplace_back(std::cos(2 * std::numbers::pi * i / 90),
                     std::sin(2 * std::numbers::pi * i / 90));
  const std::vector<Way> ways = ways_of(moments);
  for (const Way& way : parting_circles(moments))
    sketch.curves(visible(way, view, false), {"c1", 1, 0.35});
  sketch.curve(rim, {"faint", 1.2, 1, 0.05});
  for (const Way& way : ways) sketch.curves(visible(way, view, true), way.pen);
  const std::array<std::string, 3> names{"least", "middle", "largest"};
  for (Eigen::Index i = 0; i < 3; ++i) {
    const Vec2 tip = (view * Vec3::Unit(i)).head<2>();
    sketch.dot(tip, "ink", 4);
    sketch.words(tip, {8, -8}, names[static_cast<std::size_t>(i)]);
  }
  sketch.words({0, -1}, {0, 32}, name, "ink", "middle");
}

}  // namespace rigid_body_chapter
