/// @file
/// A thrown die, drawn at equal times.

#include <algorithm>

#include "objects/shapes.hpp"
#include "parts.hpp"
#include "support/facets.hpp"
#include "support/space_sketch.hpp"
#include "tumble/mass/solids/box.hpp"
#include "tumble/quaternion.hpp"

namespace contact_chapter {

namespace {

constexpr double die_edge = 0.016;  // [m]

/// A die of plastic over the floor z = 0.
contact::ContactScene thrown_die() {
  const Vec3 size = Vec3::Constant(die_edge);
  const RigidBody<> body(mass_properties(Box{size}, 1200));
  const auto start = state_of_motion<double>(
      body, {0, 0, 0.09}, Quat(0.9, 0.3, 0.2, 0.25).normalized(), {0.45, 0, 0}, {10, 30, 4});
  return {{{"die", body, collide::Convex::box(size), start}},
          {collide::HalfSpace{Vec3::Zero(), Vec3::UnitZ()}},
          Vec3(0, 0, -gravity),
          0.85,
          0.1};
}

/// The pips of a face in units of a quarter of an edge, by their number.
std::vector<Vec2> pips(int number) {
  std::vector<Vec2> all;
  if (number % 2 == 1) all.emplace_back(0, 0);
  if (number >= 2) all.insert(all.end(), {{1, 1}, {-1, -1}});
  if (number >= 4) all.insert(all.end(), {{1, -1}, {-1, 1}});
  if (number == 6) all.insert(all.end(), {{1, 0}, {-1, 0}});
  return all;
}

/// One face of the die, if the viewer sees it. Opposite faces add up to seven.
void draw_face(Sketch& sketch, const Mat3& R, const Vec2& centre, int axis, double side) {
  const Vec3 normal = side * R.col(axis);
  if (normal.z() < 0.05) return;
  const int number = side > 0 ? axis + 1 : 6 - axis;
  const Vec3 right = R.col((axis + 1) % 3), up = R.col((axis + 2) % 3);
  for (const Vec2& pip : pips(number)) {
    const Vec3 p = die_edge * (normal / 2 + (pip.x() * right + pip.y() * up) / 4);
    sketch.dot(centre + p.head<2>(), "ink", 1 + 2 * normal.z());
  }
}

/// Where the origin is drawn, and how large the world [px], [px/m].
constexpr double sheet_x = 60, sheet_y = 350, sheet_scale = 3200;

void draw_die(Sketch& sketch, const Mat3& view, const RigidBodyState<>& state) {
  const Mat3 R = view * to_matrix(state.q);
  const Vec2 centre = (view * state.x).head<2>();
  const double half = die_edge / 2;
  sketch.drawing(support::draw_facets(
      shapes::box(Vec3::Constant(-half), Vec3::Constant(half)), R,
      {sheet_x + sheet_scale * centre.x(), sheet_y - sheet_scale * centre.y(), sheet_scale}, 6));
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1., 1.}) draw_face(sketch, R, centre, axis, side);
}

/// The floor, as lines along x.
void draw_lines_of_floor(support::SpaceSketch& space) {
  for (const double y : {-0.025, -0.01, 0.005, 0.02})
    space.curve({{-0.012, y, 0}, {0.215, y, 0}}, {"faint", 1});
}

}  // namespace

std::string strip_figure() {
  Sketch sketch(760, 430, "A thrown die, drawn at equal times");
  sketch.look({sheet_x, sheet_y, sheet_scale});
  const Mat3 view = support::view_from(-76 * degree, 14 * degree);
  support::SpaceSketch space(sketch, view);
  draw_lines_of_floor(space);
  constexpr double between = 0.04;  // [s]
  constexpr int fine = 20, count = 12;
  const contact::ContactScene scene = thrown_die();
  const contact::ContactRun run =
      contact::simulate_contacts(scene, {.until = between * (count - 1)});
  std::vector<Vec2> path;
  std::vector<RigidBodyState<>> pictures;
  for (int i = 0; i <= fine * (count - 1); ++i) {
    const RigidBodyState<> state = run.state(scene, 0, std::min(between * i / fine, run.t));
    path.push_back((view * state.x).head<2>());
    if (i % fine == 0) pictures.push_back(state);
  }
  for (const RigidBodyState<>& state : pictures) draw_die(sketch, view, state);
  sketch.curve(path, {"c1", 1.6});
  space.world_axes({0.2, 0, 0.07}, 0.018);
  return sketch.svg();
}

}  // namespace contact_chapter
