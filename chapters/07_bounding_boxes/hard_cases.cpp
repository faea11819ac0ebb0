/// @file
/// Bodies that are bad for boxes.

#include "common.hpp"
#include "cube_with_a_vertex.hpp"
#include "parts.hpp"

namespace bounding_boxes_chapter {

namespace {

/// A ball of 10 cm with a thin tail of 1 m on it, of one density.
MassProperties ball_with_tail(double length) {
  constexpr double density = 1000, radius = 0.05, thickness = 0.001;
  const MassProperties tail = mass_properties(Cylinder{thickness, length}, density);
  return combine(mass_properties(Ball{radius}, density),
                 translated(tail, {0, 0, radius + length / 2}));
}

boxes::OrientedBox box_of_ball_with_tail(double length) {
  return {{0, 0, length / 2}, Mat3::Identity(), {0.1, 0.1, 0.1 + length}};
}

}  // namespace

Table hard_table() {
  Table table({"body", "box", "its volume", "off centre", "true mass", "true volume"});
  const auto add = [&](const std::string& name, const std::string& kind, const MassProperties& body,
                       double volume, const boxes::OrientedBox& box) {
    const MassProperties full = boxes::box_mass_properties(box, body.mass),
                         shrunk =
                             boxes::box_mass_properties(boxes::shrunk_to(box, volume), body.mass);
    table.add({name, kind, times(box.volume() / volume),
               percent((box.centre - body.centre).norm() / box.size.norm()),
               percent(inertia_error(full.inertia, body.inertia)),
               percent(inertia_error(shrunk.inertia, body.inertia))});
  };
  for (const double length : {0.1, 0.3, 1.0}) {
    const MassProperties body = ball_with_tail(length);
    add("ball, tail of " + number(100 * length) + " cm", "upright", body, body.mass / 1000,
        box_of_ball_with_tail(length));
  }
  Points stray = mug().points();
  stray.emplace_back(0, 0, 1);
  add("mug, a vertex 1 m up", "upright", mug().truth, mug().volume(), boxes::aligned_box(stray));
  const Vec3 sheet(0.297, 0.21, 0.0001);
  const MassProperties paper = mass_properties(Box{sheet}, 800);
  Points corners;
  for (const Vec3& p : cube_corners()) corners.push_back(p.cwiseProduct(sheet));
  add("sheet of paper", "askew by 45°", paper, sheet.prod(),
      askew_box(corners, axis_rotation(0, pi / 4)));
  add("sheet of paper", "askew by 1°", paper, sheet.prod(),
      askew_box(corners, axis_rotation(0, pi / 180)));
  const MassProperties cube = mass_properties(Box{Vec3::Ones()}, 1);
  add("cube, 9 vertices", "principal", cube, 1, boxes::principal_box(cube_with_a_vertex()));
  return table;
}

}  // namespace bounding_boxes_chapter
