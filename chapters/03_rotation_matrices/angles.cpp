/// @file
/// Three angles: in different orders, and near gimbal lock.

#include "common.hpp"
#include "objects/plain_mug.hpp"
#include "parts.hpp"
#include "support/facets.hpp"

namespace rotation_matrices_chapter {

namespace {

const Vec3 three_angles = Vec3(30, 40, 50) * degree;

}  // namespace

Table order_table() {
  const Mat3 first = euler_angles_to_matrix(three_angles, EulerSequence::xyz);
  Table table({"turns by 30°, 40°, 50° about", "the body's x axis ends at", "apart from x, y, z"});
  const auto add = [&](const std::string& name, const Mat3& R) {
    table.add({name, in_brackets(R.col(0)), number(angle_apart(first, R) / degree, 4) + "°"});
  };
  add("rotating x, y, z", first);
  add("rotating z, y, x", euler_angles_to_matrix(three_angles, EulerSequence::zyx));
  add("rotating z, x, z", euler_angles_to_matrix(three_angles, EulerSequence::zxz));
  add("fixed x, y, z", fixed_angles_to_matrix(three_angles, EulerSequence::xyz));
  return table;
}

// ── Gimbal lock ──

namespace {

using support::Pen, support::Sketch, support::SpaceSketch, support::Vec2;

/// A circle about the origin: the half that is nearer to the viewer, or the other one.
struct Ring {
  double radius;
  Vec3 axis;
  Pen pen;

  void draw_half(SpaceSketch& space, const Vec3& toward, bool near) const {
    const Vec3 side = radius * axis.cross(toward).normalized();  // neither near nor far
    space.curve(support::arc(Vec3::Zero(), near ? Vec3(-side) : side, axis, 180 * degree), pen);
  }
};

/// The three axes of the turns by α about x, β about y, γ about z, as the turns have left them.
Mat3 axes_of_turns(double alpha, double beta) {
  Mat3 axes;
  axes << Vec3::UnitX(), axis_rotation(0, alpha).col(1),
      (axis_rotation(0, alpha) * axis_rotation(1, beta)).col(2);
  return axes;
}

/// Two rings, a mug in the inner one, and the axis of each turn.
void draw_gimbals(Sketch& sketch, const Vec2& at, double alpha, double beta) {
  const Mat3 view = support::view_from(-62 * degree, 24 * degree);
  const Mat3 axes = axes_of_turns(alpha, beta);
  const Vec3 first = axes.col(0), second = axes.col(1), third = axes.col(2);
  constexpr double scale = 112;
  sketch.look({at.x(), at.y(), scale});
  SpaceSketch space(sketch, view);
  const std::array<Ring, 2> rings{Ring{1.2, first.cross(second), {"c0", 4}},
                                  {0.95, second.cross(third), {"c1", 4}}};
  const Vec3 toward = view.row(2);
  for (const Ring& ring : rings) ring.draw_half(space, toward, false);
  const Mat3 R = axis_rotation(0, alpha) * axis_rotation(1, beta);
  const Vec3 middle = view * R * Vec3(0, 0, 0.0475);
  constexpr double mug_scale = 720;
  sketch.drawing(support::draw_facets(
      objects::plain_mug(), view * R,
      {at.x() - mug_scale * middle.x(), at.y() + mug_scale * middle.y(), mug_scale}));
  for (const Ring& ring : rings) ring.draw_half(space, toward, true);
  const std::array<const char*, 3> names{"1: x", "2: y", "3: z"}, colours{"c0", "c1", "c2"};
  const std::array<double, 3> inner{1.2, 0.95, 0.55}, outer{1.6, 1.55, 1.5};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 axis = axes.col(static_cast<Eigen::Index>(i));
    const double lift = i == 2 && std::abs(axis.dot(first)) > 0.99 ? -0.2 : 0;
    const Vec3 side = lift * Vec3::UnitZ();
    space.arrow(inner[i] * axis + side, outer[i] * axis + side, {colours[i], 2.6});
    space.name_at_tip(side, outer[i] * axis + side, names[i], colours[i]);
  }
}

}  // namespace

std::string gimbal_figure() {
  Sketch sketch(760, 390, "Two rings and a mug: three axes of turns, and only two of them left",
                17);
  draw_gimbals(sketch, {180, 205}, 0, 0);
  draw_gimbals(sketch, {550, 205}, 0, 90 * degree);
  sketch.look({0, 0, 1});
  sketch.words({190, -370}, {0, 0}, "β = 0: three axes", "ink", "middle");
  sketch.words({570, -370}, {0, 0}, "β = 90°: axis 3 lies along axis 1", "ink", "middle");
  return sketch.svg();
}

Table lock_table() {
  Table table({"β", "a turn by 1° changes α by", "β by", "γ by"});
  for (const double beta : {0., 45., 80., 89., 89.9}) {
    const Vec3 before = Vec3(30, beta, 50) * degree;
    const Mat3 R = euler_angles_to_matrix(before, EulerSequence::xyz);
    const Mat3 axes = axes_of_turns(before[0], before[1]);
    const Vec3 missing = axes.col(0).cross(axes.col(1));
    const Mat3 turned = exp_rotation(Vec3(degree * missing)) * R;
    const Vec3 change = (matrix_to_euler_angles(turned, EulerSequence::xyz) - before) / degree;
    table.add({number(beta) + "°", support::svg_number(change[0], 2) + "°",
               support::svg_number(change[1], 2) + "°", support::svg_number(change[2], 2) + "°"});
  }
  return table;
}

}  // namespace rotation_matrices_chapter
