#pragma once
/// @file
/// A die with its pips, drawn.

#include <string>
#include <vector>

#include "11_when_bodies_meet/thrown_die.hpp"
#include "support/facets.hpp"
#include "support/sketch.hpp"
#include "support/svg_path.hpp"
#include "tumble/body/state.hpp"
#include "tumble/quaternion/convert.hpp"

namespace contact_chapter {

/// One face of a die that a viewer sees, if they see it. A die is convex: no face covers another
/// one.
/// @param sheet  what the sketch looks at
/// @param R      the die's orientation, to the viewer's axes
/// @param centre of the die, on the sheet [m]
inline void draw_face(tumble::support::Sketch& sketch, const tumble::support::Window& sheet,
                      const Mat3& R, const Eigen::Vector2d& centre, int axis, double side) {
  using Vec2 = Eigen::Vector2d;
  const Vec3 normal = side * R.col(axis);
  if (normal.z() <= 0) return;
  const Vec3 right = R.col((axis + 1) % 3), up = R.col((axis + 2) % 3);
  const auto at = [&](double x, double y) -> Vec2 {
    return centre + die_edge / 2 * (normal + x * right + y * up).head<2>();
  };
  tumble::support::SvgPath path;
  for (const Vec2& corner : {at(1, 1), at(-1, 1), at(-1, -1), at(1, -1)})
    path.add(sheet.x + sheet.scale * corner.x(), sheet.y - sheet.scale * corner.y(),
             path.text().empty());
  sketch.drawing(
      tumble::support::draw_facet(path.text() + "Z", tumble::support::shade_of(normal), 6));
  std::vector<Vec2> places;
  for (const Vec2& pip : pips(number_on(axis, side)))
    places.push_back(at(pip.x() / 2, pip.y() / 2));
  sketch.dots(places, "ink", sheet.scale * die_edge * (0.038 + 0.065 * normal.z()));
}

/// @param view to the viewer's axes: right, up, towards the viewer
inline void draw_die(tumble::support::Sketch& sketch, const tumble::support::Window& sheet,
                     const Mat3& view, const RigidBodyState<>& state) {
  const Mat3 R = view * to_matrix(state.q);
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1., 1.})
      draw_face(sketch, sheet, R, (view * state.x).head<2>(), axis, side);
}

}  // namespace contact_chapter
