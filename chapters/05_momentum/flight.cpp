/// @file
/// A tennis racket that is thrown: what its points do, and what its centre of mass does; and where
/// the centres of mass of things are.

#include <cmath>

#include "common.hpp"
#include "objects/objects.hpp"
#include "objects/racket_lines.hpp"
#include "parts.hpp"
#include "thrown_objects.hpp"
#include "tumble/mass/mesh_mass_properties.hpp"

namespace momentum_chapter {

namespace {

/// From the hand: upwards and away, end over end, and not quite about a principal axis.
auto thrown_racket(int count) {
  const RigidBody<> body(properties_of(racket));
  const Quat raised = exp_quaternion<double>(Vec3(0, -0.6, 0));
  const Quat q = raised * exp_quaternion<double>(Vec3(0.5, 0, 0));
  const Vec3 v(3.3, 0, 4.6), omega(0.6, 14, 0.4);
  const RigidBodyState<> start = state_of_motion<double>(body, Vec3::Zero(), q, v, omega);
  return followed(RigidBodyRhs(body, Weight{}), start, 0.95, count);
}

/// What is seen from the side: x to the right, z up.
Vec2 from_the_side(const Vec3& p) { return {p.x(), p.z()}; }

void draw_racket(support::Sketch& sketch, const Derived<>& now, const Vec3& centre) {
  static const objects::RacketLines lines = objects::racket_lines();
  const auto draw = [&](const std::vector<std::vector<Vec3>>& part, const support::Pen& pen) {
    std::vector<std::vector<Vec2>> seen;
    for (const auto& line : part) {
      seen.emplace_back();
      for (const Vec3& p : line)
        seen.back().push_back(from_the_side(point_position<double>(now, p - centre)));
    }
    sketch.curves(seen, pen);
  };
  draw(lines.strings, {"faint", 0.7});
  draw(lines.frame, {"ink", 2.2});
  draw(lines.throat, {"ink", 2});
  draw(lines.handle, {"ink", 5});
}

}  // namespace

std::string flight_figure() {
  const Vec3 centre = properties_of(racket).centre;
  const Vec3 handle_end = Vec3(-0.52, 0, 0) - centre;
  support::Sketch sketch(760, 360, "A racket in flight: the end of its handle, its centre of mass");
  sketch.look({74, 306, 188});
  std::vector<Vec2> handle, middle;
  for (const Moment& m : thrown_racket(161)) {
    handle.push_back(from_the_side(point_position(m.now, handle_end)));
    middle.push_back(from_the_side(m.now.x));
  }
  const std::vector<Moment> drawn = thrown_racket(8);
  for (const Moment& m : drawn) draw_racket(sketch, m.now, centre);
  sketch.curve(handle, {"c1", 2});
  sketch.curve(middle, {"c0", 2.4});
  for (const Moment& m : drawn) {
    sketch.dot(from_the_side(m.now.x), "c0", 5);
    sketch.dot(from_the_side(point_position(m.now, handle_end)), "c1", 4);
  }
  sketch.words({1.0, 0}, {0, 20}, "centre of mass", "c0");
  sketch.words({1.0, 0}, {0, 42}, "end of the handle", "c1");
  return sketch.svg();
}

Table centres_table() {
  Table table({"object", "mass", "longest side", "off the box's middle"});
  for (std::size_t i = 0; i < object_names.size(); ++i) {
    const objects::Object& object = objects::all[i];
    const MassProperties body = properties_of(object);
    const Eigen::AlignedBox3d box = bounds(object.mesh(object.for_drawings));
    const double off = (body.centre - box.center()).norm();
    table.add({object_names[i], number(1000 * body.mass) + " g",
               number(1000 * box.sizes().maxCoeff()) + " mm",
               off < 1e-9 ? "0" : number(1000 * off) + " mm"});
  }
  return table;
}

}  // namespace momentum_chapter
