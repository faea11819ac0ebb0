/// @file
/// Turns as quaternions, a length that is not 1, and the way back from a matrix.

#include "common.hpp"
#include "parts.hpp"
#include "plane.hpp"
#include "support/plot.hpp"
#include "support/sketch.hpp"

namespace quaternions_chapter {

// ── Turns as quaternions ──

Table turns_table() {
  Table table({"turn", "(w, x, y, z)"});
  const auto add = [&](const std::string& name, const Vec3& axis, double angle) {
    table.add({name, four_numbers(from_axis_angle(axis, angle * degree))});
  };
  add("none", Vec3::UnitZ(), 0);
  add("1° about z", Vec3::UnitZ(), 1);
  add("90° about z", Vec3::UnitZ(), 90);
  add("180° about z", Vec3::UnitZ(), 180);
  add("360° about z", Vec3::UnitZ(), 360);
  add("120° about the diagonal (1, 1, 1)", Vec3::Ones(), 120);
  return table;
}

Table order_table() {
  Table table({"first", "then", "product (w, x, y, z)", "the angle", "about"});
  const Quat x = from_axis_angle(Vec3::UnitX(), 90 * degree);
  const Quat z = from_axis_angle(Vec3::UnitZ(), 90 * degree);
  const auto add = [&](const char* first, const char* then, const Quat& q) {
    const Vec3 turn = log_quaternion(q);
    const Vec3 axis = turn / turn.cwiseAbs().maxCoeff();
    table.add({first, then, four_numbers(q), degrees(turn.norm()),
               "(" + number(axis[0]) + ", " + number(axis[1]) + ", " + number(axis[2]) + ")"});
  };
  add("90° about x", "90° about z", z * x);
  add("90° about z", "90° about x", x * z);
  return table;
}

std::string circle_figure() {
  support::Sketch sketch(520, 520, "The same orientation at opposite points of the circle", 14);
  sketch.look({260, 260, 110});
  std::vector<Vec2> ring;
  for (int i = 0; i <= 90; ++i)
    ring.emplace_back(std::cos(4 * i * degree), std::sin(4 * i * degree));
  sketch.curve(ring, {"c0", 2});
  std::string planes;
  for (int i = 0; i < 8; ++i) {
    const double turn = 90.0 * i, half = turn / 2 * degree;
    const Vec2 p(std::cos(half), std::sin(half));
    if (i < 4) sketch.curve({p, -p}, {"faint", 1});
    sketch.dot(p, "c0", 5);
    const Vec2 at = 1.75 * p;
    planes += support::draw_mesh(paper_plane(),
                                 axis_rotation(0, -20 * degree) * axis_rotation(2, turn * degree),
                                 {260 + 110 * at.x(), 260 - 110 * at.y(), 70});
    const Vec2 beside(std::cos(half + 0.25), std::sin(half + 0.25));
    sketch.words(0.76 * beside, {0, 5}, number(turn) + "°", "ink", "middle");
  }
  sketch.look({34, 490, 1});
  sketch.arrow({0, 0}, {34, 0}, {"ink", 1.5});
  sketch.words({34, 0}, {8, 5}, "x");
  sketch.arrow({0, 0}, {0, 34}, {"ink", 1.5});
  sketch.words({0, 34}, {8, 2}, "y");
  sketch.words({440, 0}, {0, 5}, "the planes, seen from above", "ink", "end");
  sketch.look({260, 260, 110});
  sketch.words({0, 0}, {-252, -236}, "to the right: w = cos ½θ", "c0");
  sketch.words({0, 0}, {-252, -218}, "up: z = sin ½θ", "c0");
  return with_planes(sketch, planes);
}

// ── A length that is not 1 ──

Table length_table() {
  Table table({"|q|", "formula", "perpendicular: length", "turned by", "along the axis: length"});
  const Vec3 perpendicular = Vec3::UnitX(), along = Vec3::UnitZ();
  const auto add = [&](double size, const std::string& formula, auto&& rotate) {
    const Vec3 a = rotate(perpendicular);
    table.add({number(size), formula, number(a.norm(), 4), degrees(std::atan2(a.y(), a.x())),
               number(rotate(along).norm(), 4)});
  };
  for (const double size : {1., 1.1}) {
    const Quat q(Eigen::Vector4d(size * from_axis_angle(along, 60 * degree).coeffs()));
    add(size, "q p q⁻¹", [&](const Vec3& p) { return Vec3(to_matrix(q) * p); });
    add(size, "q p conjugate(q)", [&](const Vec3& p) -> Vec3 {
      return (q * Quat(0, p.x(), p.y(), p.z()) * q.conjugate()).vec();
    });
    add(size, "Eigen's q * p", [&](const Vec3& p) { return Vec3(q * p); });
  }
  return table;
}

// ── From a matrix, close to a half turn ──

namespace {

/// Everything divided by w, as if w were never small.
Quat through_w(const Mat3& R) {
  const double w = std::sqrt(std::max(0.0, 1 + R.trace())) / 2;
  const Vec3 v = Vec3(R(2, 1) - R(1, 2), R(0, 2) - R(2, 0), R(1, 0) - R(0, 1)) / (4 * w);
  return {w, v.x(), v.y(), v.z()};
}

}  // namespace

std::string half_turn_figure() {
  support::Plot plot{"quaternion of a matrix",
                     {"180° − angle [rad]", support::Scale::log},
                     {"error of the four numbers, at worst", support::Scale::log},
                     {}};
  support::Series one{"one case: by w", {}, {}}, four{"four cases", {}, {}};
  for (int power = -30; power <= 0; ++power) {
    const double short_of = std::ldexp(1.0, power);
    double worst_one = 0, worst_four = 0;
    for (int i = 0; i < 50; ++i) {
      const Vec3 axis(std::sin(1.0 + i), std::cos(2.0 + 3 * i), std::sin(0.5 + 7 * i));
      const Quat exact = from_axis_angle(axis, pi - short_of);
      const Mat3 R = to_matrix(exact);
      const auto off = [&](const Quat& q) {
        const double side = q.dot(exact) < 0 ? -1 : 1;
        return (side * q.coeffs() - exact.coeffs()).norm();
      };
      const double error = off(through_w(R));
      worst_one = std::max(worst_one, std::isfinite(error) ? error : 1.0);
      worst_four = std::max(worst_four, off(from_matrix(R)));
    }
    one.x.push_back(short_of), four.x.push_back(short_of);
    one.y.push_back(worst_one), four.y.push_back(worst_four);
  }
  plot.series = {one, four};
  return support::to_svg(plot);
}

}  // namespace quaternions_chapter
