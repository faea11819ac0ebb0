/// @file
/// Planes between two boxes: a face against a corner, and an edge against an edge.

#include "common.hpp"
#include "parts.hpp"
#include "support/space_sketch.hpp"
#include "support/two_axes.hpp"
#include "tumble/collide/distance.hpp"
#include "tumble/mass/oriented_box.hpp"
#include "tumble/rotation/exp.hpp"

namespace contact_chapter {

namespace {

using boxes::OrientedBox;

/// Half of the length of a box along a direction.
double reach(const OrientedBox& box, const Vec3& n) {
  return (box.R.transpose() * n).cwiseAbs().dot(box.size) / 2;
}

collide::Distance between(const OrientedBox& a, const OrientedBox& b) {
  using collide::Convex;
  return collide::distance(Convex::box(a.size), {a.centre, a.R}, Convex::box(b.size),
                           {b.centre, b.R});
}

Vec3 corner_of(const OrientedBox& box, int i) {
  const Vec3 signs(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
  return box.centre + box.R * signs.cwiseProduct(box.size) / 2;
}

void draw_edges(support::SpaceSketch& space, const OrientedBox& box, const std::string& colour) {
  for (int i = 0; i < 8; ++i)
    for (const int bit : {1, 2, 4})
      if ((i & bit) == 0) space.curve({corner_of(box, i), corner_of(box, i | bit)}, {colour, 1.8});
}

/// A plane that the viewer sees from its side: a line.
void draw_plane_line(support::SpaceSketch& space, const Vec3& through, const Vec3& along) {
  space.curve({through - along, through + along}, {"ink", 1.4});
}

/// Both boxes, both planes, and what is between them.
void draw_between(Sketch& sketch, const Mat3& view, const OrientedBox& a, const OrientedBox& b) {
  support::SpaceSketch space(sketch, view);
  const collide::Distance plane = between(a, b);
  const Vec3 n = plane.normal, toward = view.row(2).transpose();
  const Vec3 along = 1.25 * toward.cross(n);
  const Vec3 middle = (a.centre + b.centre) / 2;
  // In the first box's plane, opposite to the middle of both.
  const Vec3 foot = middle + n * (n.dot(a.centre - middle) + reach(a, n));
  draw_edges(space, a, "c0");
  draw_edges(space, b, "c2");
  draw_plane_line(space, foot, along);
  draw_plane_line(space, foot + plane.gap * n, along);
  const Vec3 beside = foot + 0.8 * along;
  space.arrow(beside, beside + plane.gap * n, {"c1", 2.2});
  space.words(beside + plane.gap * n, {14, 6}, "gap " + rounded(plane.gap, 2), "c1", "start");
  space.arrow(foot - 0.8 * along, foot - 0.8 * along + 0.6 * n, {"c3", 2.4});
  space.words(foot - 0.8 * along + 0.6 * n, {8, 0}, "n", "c3", "start");
  space.words(a.centre, {0, 5}, "A", "c0");
  space.words(b.centre, {0, 5}, "B", "c2");
}

/// To a viewer who looks along a direction, with z as far up as it can be.
Mat3 view_along(const Vec3& toward) {
  const Vec3 right = Vec3::UnitZ().cross(toward).normalized();
  Mat3 view;
  view << right.transpose(), toward.cross(right).transpose(), toward.transpose();
  return view;
}

Mat3 turned_about(double angle, const Vec3& axis) {
  return exp_rotation<double>(Vec3(angle * axis.normalized()));
}

}  // namespace

std::string plane_figure() {
  Sketch sketch(760, 380, "Two boxes and the plane between them, twice");
  const Mat3 view = view_along(-Vec3::UnitY());
  const Mat3 diamond = turned_about(pi / 4, Vec3::UnitY());
  sketch.look({70, 180, 100});
  draw_between(sketch, view, {{0.6, 0, 0}, turned_about(-0.3, Vec3::UnitY()), {1.2, 1, 1}},
               {{2.1, 0, 0.35}, turned_about(0.75, Vec3::UnitY()), {1, 1, 1.1}});
  sketch.words({1.3, -1.5}, {0, 0}, "n: an edge of A", "ink", "middle");
  sketch.look({450, 180, 100});
  draw_between(sketch, view, {{0.6, 0, 0}, diamond, {1, 1, 1}},
               {{2.25, 0, 0.1},
                turned_about(0.9, Vec3::UnitX()) * turned_about(pi / 4, Vec3::UnitZ()),
                {1, 1, 1}});
  sketch.words({1.4, -1.5}, {0, 0}, "n: an edge of A × one of B", "ink", "middle");
  sketch.look({30, 350, 50});
  support::draw_two_axes(sketch, 1, {"x", "z"});
  return sketch.svg();
}

}  // namespace contact_chapter
