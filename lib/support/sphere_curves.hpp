#pragma once
/// @file
/// Curves on a sphere as a viewer sees them: the ways of L in a body, drawn in chapters 9 and 10.

#include <cmath>
#include <numbers>
#include <vector>

#include "support/sketch.hpp"
#include "tumble/core/types.hpp"

namespace tumble::support {

/// One closed way of L on its sphere, in principal axes, and how it is drawn.
struct Way {
  std::vector<Vec3> points;
  Pen pen;
};

/// The parts of a way that are on the near side of the sphere, or on the far side.
inline std::vector<std::vector<Vec2>> visible(const Way& way, const Mat3& view, bool near) {
  std::vector<std::vector<Vec2>> parts;
  bool pen_down = false;
  for (const Vec3& point : way.points) {
    const Vec3 p = view * point;
    if ((p.z() >= 0) != near) {
      pen_down = false;
      continue;
    }
    if (!pen_down) parts.emplace_back();
    pen_down = true;
    parts.back().push_back(p.head<2>());
  }
  return parts;
}

/// To the axes of a viewer (right, up, towards the viewer) with z up.
/// @param around where the viewer stands, as an angle about z from x [rad]
/// @param above  how far above the plane of x and y [rad]
inline Mat3 view_from(double around, double above) {
  const Vec3 right(-std::sin(around), std::cos(around), 0);
  const Vec3 toward(std::cos(around) * std::cos(above), std::sin(around) * std::cos(above),
                    std::sin(above));
  Mat3 view;
  view << right.transpose(), toward.cross(right).transpose(), toward.transpose();
  return view;
}

/// From principal axes to the viewer's: the middle axis near the front, the largest moment's up.
inline Mat3 sphere_view() {
  constexpr double degree = std::numbers::pi / 180;
  return view_from(56 * degree, 24 * degree);
}

}  // namespace tumble::support
