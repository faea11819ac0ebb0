#pragma once
/// @file
/// The mug as a drawing in lines: rims, foot, two sides and the handle.

#include <vector>

#include "common.hpp"
#include "objects/hanging_mug.hpp"

namespace rigid_body_chapter {

/// The lines of the mug about its centre of mass, in body axes.
/// @param toward the viewer, in body axes: the sides are where the wall turns away
inline std::vector<std::vector<Vec3>> mug_lines(const Vec3& toward) {
  constexpr double radius = 0.041, height = 0.095, middle = 0.053;
  static const Vec3 centre = properties_of(mug_object).centre;
  const auto at = [](double r, double angle, double z) -> Vec3 {
    return Vec3(r * std::cos(angle), r * std::sin(angle), z) - centre;
  };
  std::vector<std::vector<Vec3>> lines(4);
  for (int i = 0; i <= 24; ++i) {
    const double angle = 2 * pi * i / 24, bend = pi * (0.09 + 0.082 * i / 2.4);
    lines[0].push_back(at(radius, angle, 0));
    lines[1].push_back(at(radius, angle, height));
    lines[2].push_back(at(radius - 0.004, angle, height));
    lines[3].push_back(at(radius + 0.030 * std::sin(bend), 0, middle + 0.026 * std::cos(bend)));
  }
  const double side = std::atan2(toward.y(), toward.x());
  for (const double angle : {side + pi / 2, side - pi / 2})
    lines.push_back({at(radius, angle, 0), at(radius, angle, height)});
  return lines;
}

/// @param view from the world's axes to the viewer's
inline void draw_mug(support::Sketch& sketch, const Mat3& view, const Derived<>& now,
                     const support::Pen& pen = {"ink", 1.5}) {
  const Vec3 toward = (view * now.R).transpose() * Vec3::UnitZ();
  std::vector<std::vector<Vec2>> seen;
  for (const std::vector<Vec3>& line : mug_lines(toward)) {
    seen.emplace_back();
    for (const Vec3& p : line)
      seen.back().push_back((view * point_position<double>(now, p)).head<2>());
  }
  sketch.curves(seen, pen);
}

}  // namespace rigid_body_chapter
