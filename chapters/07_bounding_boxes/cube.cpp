/// @file
/// A cube with one vertex more, and what that does to its principal box.

#include "common.hpp"
#include "cube_with_a_vertex.hpp"
#include "parts.hpp"
#include "support/box_edges.hpp"
#include "support/sphere_curves.hpp"

namespace bounding_boxes_chapter {

namespace {

std::vector<std::vector<Vec2>> edges_of(const boxes::OrientedBox& box, const Mat3& view) {
  return support::box_edges(box.centre, box.R * box.size.asDiagonal(), view);
}

}  // namespace

std::string cube_figure() {
  support::Sketch sketch(700, 372, "A cube with eight vertices and with nine", 20);
  const Mat3 view = support::view_from(-62 * degree, 24 * degree);
  const auto draw = [&](double x, const Points& points, const std::string& caption) {
    sketch.look({x, 162, 152});
    sketch.curves(edges_of({Vec3::Zero(), Mat3::Identity(), Vec3::Ones()}, view), {"faint", 1.6});
    const boxes::OrientedBox box = boxes::principal_box(points);
    sketch.curves(edges_of(box, view), {"c1", 2.4});
    for (const Vec3& p : points) sketch.dot((view * p).head<2>(), "ink", 4.5);
    if (points.size() > 8) sketch.dot((view * points[8]).head<2>(), "c6", 8);
    sketch.words({0, 0}, {0, 196}, caption + times(box.volume()), "ink", "middle");
  };
  draw(165, cube_corners(), "8 vertices: volume ");
  draw(515, cube_with_a_vertex(), "9 vertices: volume ");
  const std::array<std::string, 3> names{"x", "y", "z"};
  sketch.look({330, 318, 34});
  for (int i = 0; i < 3; ++i) {
    const Vec2 tip = (view * Vec3::Unit(i)).head<2>();
    sketch.arrow({0, 0}, tip, {"faint", 1.4});
    sketch.words(tip, {4, -3}, names[static_cast<std::size_t>(i)], "faint");
  }
  return sketch.svg();
}

}  // namespace bounding_boxes_chapter
