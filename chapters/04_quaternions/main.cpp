/// @file
/// Chapter 4: what four numbers do better than nine. Ways between two orientations, drift, what a
/// step costs and what error it buys, and the places where a formula loses its digits.
#include <cmath>
#include <functional>
#include <numbers>

#include "support/chapter.hpp"
#include "support/counted.hpp"
#include "support/plot.hpp"
#include "support/sketch.hpp"
#include "support/stopwatch.hpp"
#include "support/view.hpp"
#include "tumble/ode.hpp"
#include "tumble/quaternion.hpp"
#include "tumble/rotation.hpp"

namespace {

using namespace tumble;
using support::error_number;
using support::number;
using support::Table;
using support::Vec2;

constexpr double pi = std::numbers::pi, degree = pi / 180;

/// How far apart two orientations are [rad].
double angle_apart(const Mat3& A, const Mat3& B) { return log_rotation(A.transpose() * B).norm(); }

std::string degrees(double angle, int digits = 4) { return number(angle / degree, digits) + "°"; }

/// An error, or that there is none but rounding.
std::string error_or_rounding(double error) {
  if (std::isnan(error)) return "not a number";
  return error < 1e-14 ? "< 1e-14" : error_number(error);
}

std::string four_numbers(const Quat& q) {
  std::string text;
  for (const double x : coefficients(q))
    text += (text.empty() ? "" : ", ") + support::svg_number(x, 4);
  return "(" + text + ")";
}

// ── A paper plane ──

/// Nose along x, left wing along y, both sides of the paper.
PolygonMesh paper_plane() {
  PolygonMesh mesh;
  mesh.vertices = {{0.6, 0, 0.01},       {-0.45, 0.42, 0.1},   {-0.45, 0.04, 0.02},
                   {-0.45, -0.42, 0.1},  {-0.45, -0.04, 0.02}, {-0.45, 0, -0.22},
                   {-0.42, 0.04, 0.019}, {-0.42, -0.04, 0.019}};
  const auto add_sheet = [&](int a, int b, int c) {
    mesh.add_face({a, b, c});
    mesh.add_face({a, c, b});
  };
  add_sheet(0, 1, 2);
  add_sheet(0, 4, 3);
  add_sheet(0, 2, 5);
  add_sheet(0, 5, 4);
  return mesh;
}

/// From the viewer's side: the world's x to the right, z up, seen from a little above.
const Mat3 viewer = axis_rotation(0, -65 * degree) * axis_rotation(2, -20 * degree);

/// Drawings of the plane go in before the figure's end.
std::string with_planes(const support::Sketch& sketch, const std::string& planes) {
  std::string svg = sketch.svg();
  return svg.insert(svg.rfind("</svg>"), planes);
}

// ── From one orientation to another ──

const Mat3 start = Mat3::Identity();
constexpr double whole_turn = 150 * degree;
const Mat3 goal = exp_rotation(Vec3(whole_turn * Vec3(0.3, -1, 0.25).normalized()));

/// A way from `start` at t = 0 to `goal` at t = 1. Not every step of it need be a rotation.
struct Way {
  std::string name;
  std::function<Mat3(double)> at;
};

Mat3 mix_nine(double t) { return (1 - t) * start + t * goal; }

/// Each angle the short way round.
Mat3 mix_angles(double t) {
  const Vec3 a = matrix_to_euler_angles(start, EulerSequence::zyx);
  Vec3 way = matrix_to_euler_angles(goal, EulerSequence::zyx) - a;
  for (double& angle : way) angle = std::remainder(angle, 2 * pi);
  return euler_angles_to_matrix(a + t * way, EulerSequence::zyx);
}

Quat mix_four(const Quat& a, const Quat& b, double t) {
  const double side = a.dot(b) < 0 ? -1 : 1;
  return Quat(Eigen::Vector4d((1 - t) * a.coeffs() + t * side * b.coeffs()));
}

const std::vector<Way> ways{
    {"nine numbers mixed", mix_nine},
    {"… and repaired", [](double t) { return nearest_rotation(mix_nine(t)); }},
    {"three angles mixed", mix_angles},
    {"four numbers mixed, normalised",
     [](double t) { return to_matrix(mix_four(from_matrix(start), from_matrix(goal), t)); }},
    {"slerp", [](double t) { return to_matrix(slerp(from_matrix(start), from_matrix(goal), t)); }}};

/// Angular speed along a way [rad per unit of t].
double speed(const Way& way, double t) {
  constexpr double d = 1e-4;
  return angle_apart(nearest_rotation(way.at(t - d)), nearest_rotation(way.at(t + d))) / (2 * d);
}

Table ways_table() {
  Table table({"way", "turns in all", "fastest / slowest", "smallest volume"});
  constexpr int parts = 400;
  for (const Way& way : ways) {
    double turned = 0, fastest = 0, slowest = 1e9, volume = 1;
    for (int i = 0; i <= parts; ++i) {
      const double t = 1.0 * i / parts, v = speed(way, t);
      turned += v / parts * (i == 0 || i == parts ? 0.5 : 1);
      fastest = std::max(fastest, v);
      slowest = std::min(slowest, v);
      volume = std::min(volume, way.at(t).determinant());
    }
    table.add({way.name, degrees(turned), number(fastest / slowest, 3), number(volume, 3)});
  }
  return table;
}

std::string between_figure() {
  constexpr double cell = 104, row = 150;
  support::Sketch sketch(5 * cell, 3 * row, "From one orientation to another", 14);
  std::string planes;
  const PolygonMesh mesh = paper_plane();
  double y = 0;
  for (const std::size_t w : {0u, 2u, 4u}) {
    sketch.words({0, 0}, {8, y + 18}, ways[w].name);
    for (int i = 0; i < 5; ++i) {
      const Mat3 R = ways[w].at(i / 4.0);
      const double x = cell * (i + 0.5);
      planes += support::draw_mesh(mesh, viewer * R, {x, y + 76, 82});
      const std::string volume = "volume " + number(R.determinant(), 2);
      sketch.words({0, 0}, {x, y + 138}, w == 0 ? volume : "t = " + number(i / 4.0), "ink",
                   "middle");
    }
    y += row;
  }
  return with_planes(sketch, planes);
}

// ── Tracks of the nose on a globe ──

/// The part of a curve in space that is in front of the globe's middle plane, or behind it.
std::vector<std::vector<Vec2>> seen(const std::vector<Vec3>& curve, bool front) {
  std::vector<std::vector<Vec2>> pieces;
  bool down = false;
  for (const Vec3& p : curve) {
    if ((p.z() >= 0) == front) {
      if (!down) pieces.emplace_back();
      pieces.back().emplace_back(p.head<2>());
    }
    down = (p.z() >= 0) == front;
  }
  return pieces;
}

const Mat3 globe = axis_rotation(0, -60 * degree) * axis_rotation(2, 20 * degree);

void draw_globe(support::Sketch& sketch) {
  const auto ring = [&](auto&& point) {
    std::vector<Vec3> curve;
    for (int i = 0; i <= 90; ++i) curve.emplace_back(globe * point(4 * i * degree));
    sketch.curves(seen(curve, true), {"grid", 1.2});
  };
  for (const double latitude : {-60., -30., 0., 30., 60.}) {
    const double c = std::cos(latitude * degree), s = std::sin(latitude * degree);
    ring([&](double a) { return Vec3(c * std::cos(a), c * std::sin(a), s); });
  }
  for (int i = 0; i < 6; ++i) {
    const double c = std::cos(30 * i * degree), s = std::sin(30 * i * degree);
    ring([&](double a) { return Vec3(c * std::cos(a), s * std::cos(a), std::sin(a)); });
  }
  std::vector<Vec2> rim;
  for (int i = 0; i <= 90; ++i)
    rim.emplace_back(std::cos(4 * i * degree), std::sin(4 * i * degree));
  sketch.curve(rim, {"faint", 1.2});
}

std::string tracks_figure() {
  support::Sketch sketch(520, 520, "Where the nose points on the way", 14);
  sketch.look({260, 215, 200});
  draw_globe(sketch);
  const std::array<std::string, 5> colours{"c1", "", "c3", "c2", "c0"};
  double line = 208;
  for (const std::size_t w : {0u, 2u, 3u, 4u}) {
    std::vector<Vec3> curve;
    for (int i = 0; i <= 160; ++i) curve.emplace_back(globe * ways[w].at(i / 160.0).col(0));
    sketch.curves(seen(curve, false), {colours[w], 2, 0.35});
    sketch.curves(seen(curve, true), {colours[w], 2});
    for (int i = 0; i <= 8; ++i)
      sketch.dot(globe.topRows<2>() * ways[w].at(i / 8.0).col(0), colours[w], 3.5);
    sketch.words({0, 0}, {-250, line += 18}, ways[w].name, colours[w]);
  }
  return sketch.svg();
}

// ── Why the pace differs ──

/// A circle with the arc and the chord between two orientations, each in eight equal parts.
void arc_and_chord(support::Sketch& sketch, double angle, const std::string& title) {
  const auto on_circle = [](double a) { return Vec2(std::sin(a), std::cos(a)); };
  std::vector<Vec2> arc;
  for (int i = 0; i <= 90; ++i) arc.push_back(on_circle(angle * (i / 90.0 - 0.5)));
  const Vec2 a = arc.front(), b = arc.back();
  sketch.curve(arc, {"c0", 2});
  sketch.curve({a, b}, {"c1", 2});
  std::vector<std::vector<Vec2>> rays;
  for (int i = 0; i <= 8; ++i) {
    const Vec2 p = a + (b - a) * i / 8.0;
    rays.push_back({Vec2(0, 0), p.normalized()});
  }
  sketch.curves(rays, {"c1", 1, 0.6});
  for (int i = 0; i <= 8; ++i) {
    const Vec2 p = a + (b - a) * i / 8.0;
    sketch.dot(p, "c1", 3.5);
    sketch.dot(p.normalized(), "c1", 3.5);
    sketch.dot(on_circle(angle * (i / 8.0 - 0.5)) * 1.05, "c0", 3.5);
  }
  sketch.dot({0, 0}, "ink", 3);
  sketch.words({0, 0}, {0, 24}, title, "ink", "middle");
}

std::string chord_figure() {
  support::Sketch sketch(520, 250, "Equal parts of the chord, unequal parts of the arc", 14);
  sketch.look({130, 200, 122});
  arc_and_chord(sketch, whole_turn / 2, "four numbers: 75° apart");
  sketch.look({390, 200, 122});
  arc_and_chord(sketch, whole_turn, "nine numbers: 150° apart");
  sketch.words({0, 0}, {-380, -180}, "equal parts of the arc", "c0");
  sketch.words({0, 0}, {-380, -162}, "equal parts of the chord, and where they point", "c1");
  return sketch.svg();
}

std::string pace_figure() {
  support::Plot plot{"pace on the way", {"t"}, {"angular speed [150° per unit of t]"}, {}};
  for (const std::size_t w : {1u, 2u, 3u, 4u}) {
    support::Series series{w == 1 ? "nine numbers" : ways[w].name, {}, {}};
    if (w == 3) series.name = "four numbers";
    if (w == 2) series.name = "three angles";
    for (int i = 0; i <= 100; ++i) {
      series.x.push_back(i / 100.0);
      series.y.push_back(speed(ways[w], i / 100.0) / whole_turn);
    }
    plot.series.push_back(series);
  }
  return support::to_svg(plot);
}

/// How uneven the pace of a mixture is, and how far it is from where slerp is, at worst.
Table pace_table() {
  Table table({"turn", "four: fastest / slowest", "off by", "nine: fastest / slowest", "off by"});
  const Quat a = Quat::Identity();
  for (const double angle : {5., 30., 90., 150., 179.}) {
    const Quat b = from_axis_angle({2, -1, 2}, angle * degree);
    double off_four = 0, off_nine = 0;
    for (int i = 0; i <= 1000; ++i) {
      const double t = i / 1000.0;
      const Quat exact = slerp(a, b, t);
      const Mat3 nine = nearest_rotation((1 - t) * to_matrix(a) + t * to_matrix(b));
      off_four = std::max(off_four, angle_between(exact, mix_four(a, b, t)));
      off_nine = std::max(off_nine, angle_apart(to_matrix(exact), nine));
    }
    const auto ratio = [](double between) { return number(1 / std::pow(std::cos(between), 2), 5); };
    table.add({number(angle) + "°", ratio(angle * degree / 4), degrees(off_four, 2),
               ratio(angle * degree / 2), degrees(off_nine, 2)});
  }
  return table;
}

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
  const Quat y = from_axis_angle(Vec3::UnitY(), 90 * degree);
  const auto add = [&](const char* first, const char* then, const Quat& q) {
    const Vec3 turn = log_quaternion(q);
    const Vec3 axis = turn / turn.cwiseAbs().maxCoeff();
    table.add({first, then, four_numbers(q), degrees(turn.norm()),
               "(" + number(axis[0]) + ", " + number(axis[1]) + ", " + number(axis[2]) + ")"});
  };
  add("90° about x", "90° about y", y * x);
  add("90° about y", "90° about x", x * y);
  return table;
}

/// The plane at eight moments of a turn about the vertical that goes round twice; the quaternion
/// goes round once.
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
  sketch.words({0, 0}, {-252, -236}, "to the right: w = cos ½θ", "c0");
  sketch.words({0, 0}, {-252, -218}, "up: z = sin ½θ", "c0");
  return with_planes(sketch, planes);
}

// ── A length that is not 1 ──

Table length_table() {
  Table table({"|q|", "formula", "across the axis: length", "turned by", "along it: length"});
  const Vec3 across = Vec3::UnitX(), along = Vec3::UnitZ();
  const auto add = [&](double size, const std::string& formula, auto&& rotate) {
    const Vec3 a = rotate(across);
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

/// Everything divided by w, as if w were never small.
Quat through_w(const Mat3& R) {
  const double w = std::sqrt(std::max(0.0, 1 + R.trace())) / 2;
  const Vec3 v = Vec3(R(2, 1) - R(1, 2), R(0, 2) - R(2, 0), R(1, 0) - R(0, 1)) / (4 * w);
  return {w, v.x(), v.y(), v.z()};
}

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

// ── Drift ──

/// The same steady turn as in chapter 3, whose exact orientation is known.
const Vec3 omega = 2 * Vec3(2, -1, 2).normalized();  // [rad/s]
constexpr double h = 1.0 / 60;                       // a frame of a game [s]

template <class T>
using Four = Eigen::Matrix<T, 4, 1>;
template <class T>
using Nine = Eigen::Matrix<T, 9, 1>;

/// q̇ = ½ ⟨0, ω⟩ q as a right-hand side, for an angular velocity ω(t).
template <class T, class Spin>
auto rate_of_four(Spin spin) {
  return [spin](const T& t, const Four<T>& y) -> Four<T> {
    return coefficients(quaternion_dot<T>(from_coefficients<T>(y), spin(t)));
  };
}

/// Ṙ = [ω]× R.
template <class T, class Spin>
auto rate_of_nine(Spin spin) {
  return [spin](const T& t, const Nine<T>& y) -> Nine<T> {
    return rotation_dot<T>(y.reshaped(3, 3), spin(t)).reshaped();
  };
}

const auto as_it_is = [](const auto& y) { return y; };
const auto normalised = [](const Four<double>& y) {
  return coefficients(normalize(from_coefficients(y)));
};

/// The state after so many steps, repaired by `repair` after each.
template <class Method, class State, class Rate, class Repair>
State stepped(const Rate& rate, State y, double step, int steps, Repair&& repair) {
  for (int i = 0; i < steps; ++i) y = repair(Method::step(rate, i * step, y, step));
  return y;
}

const Four<double> four_start = coefficients(Quat::Identity());
const Nine<double> nine_start = Mat3(Mat3::Identity()).reshaped();

/// What of a rotation q p q̄ is not: ‖RᵀR − 1‖ of the matrix |q|² R.
double shape_error(const Quat& q) {
  return std::sqrt(3.0) * std::abs(std::pow(q.squaredNorm(), 2) - 1);
}

Vec3 steady(double) { return omega; }

template <class Method>
void add_drift(Table& table, const std::string& name, int seconds) {
  const int steps = 60 * seconds;
  const Quat exact = exp_quaternion<double>(omega * (h * steps));
  const auto four = rate_of_four<double>(steady);
  const Mat3 R =
      stepped<Method>(rate_of_nine<double>(steady), nine_start, h, steps, as_it_is).reshaped(3, 3);
  const Quat q = from_coefficients(stepped<Method>(four, four_start, h, steps, as_it_is));
  const Quat r = from_coefficients(stepped<Method>(four, four_start, h, steps, normalised));
  const auto add = [&](const std::string& what, double shape, double off) {
    table.add(
        {name, number(seconds) + " s", what, error_or_rounding(shape), error_number(off) + " rad"});
  };
  add("nine numbers", orthonormality_error(R), angle_apart(to_matrix(exact), nearest_rotation(R)));
  add("four numbers", shape_error(q), angle_between(exact, q));
  add("four, normalised", shape_error(r), angle_between(exact, r));
}

Table drift_table() {
  Table table({"method", "after", "orientation as", "‖RᵀR − 1‖", "orientation off by"});
  add_drift<Euler>(table, "Euler", 10);
  add_drift<Midpoint>(table, "midpoint", 600);
  add_drift<Rk4>(table, "RK4", 600);
  return table;
}

/// ‖RᵀR − 1‖ at moments evenly spread over a log axis.
template <class Method, class State, class Rate, class Shape>
support::Series drift_series(const std::string& name, const Rate& rate, State y, Shape&& shape) {
  support::Series series{name, {}, {}};
  int next = 1;
  for (int i = 1; i <= 60 * 600; ++i) {
    y = Method::step(rate, i * h, y, h);
    if (i != next) continue;
    next = std::max(next + 1, next * 3 / 2);
    series.x.push_back(i * h);
    series.y.push_back(shape(y));
  }
  return series;
}

std::string drift_figure() {
  support::Plot plot{"drift of four and of nine numbers",
                     {"time [s]", support::Scale::log},
                     {"‖RᵀR − 1‖", support::Scale::log},
                     {}};
  const auto of_four = [](const Four<double>& y) { return shape_error(from_coefficients(y)); };
  const auto of_nine = [](const Nine<double>& y) { return orthonormality_error(y.reshaped(3, 3)); };
  const auto four = rate_of_four<double>(steady);
  const auto nine = rate_of_nine<double>(steady);
  plot.series = {drift_series<Euler>("Euler, nine", nine, nine_start, of_nine),
                 drift_series<Euler>("Euler, four", four, four_start, of_four),
                 drift_series<Midpoint>("midpoint, nine", nine, nine_start, of_nine),
                 drift_series<Midpoint>("midpoint, four", four, four_start, of_four),
                 drift_series<Rk4>("RK4, nine", nine, nine_start, of_nine),
                 drift_series<Rk4>("RK4, four", four, four_start, of_four)};
  return support::to_svg(plot);
}

/// One step of a turn that is large for it.
Table big_steps_table() {
  Table table({"asked for", "Euler turns by", "midpoint", "RK4", "|q|: Euler", "midpoint", "RK4"});
  const auto four = rate_of_four<double>([](double) { return Vec3(0, 0, 1); });
  for (const double angle : {0.1, 0.5, 1.0, 2.0, 3.0, 6.0}) {
    const Quat e = from_coefficients(Euler::step(four, 0.0, four_start, angle));
    const Quat m = from_coefficients(Midpoint::step(four, 0.0, four_start, angle));
    const Quat r = from_coefficients(Rk4::step(four, 0.0, four_start, angle));
    const auto turn = [](const Quat& q) {
      return number(2 * std::atan2(q.z(), q.w()) + (q.z() < 0 ? 2 * pi : 0), 5);
    };
    table.add({number(angle) + " rad", turn(e), turn(m), turn(r), number(e.norm(), 5),
               number(m.norm(), 5), number(r.norm(), 5)});
  }
  return table;
}

// ── What a step costs ──

using support::Counted;

std::string operations(const support::Operations& done) {
  return number(done.multiplications) + " ×, " + number(done.additions) + " +" +
         (done.functions > 0 ? ", " + number(done.functions) + " √" : "");
}

const Quaternion<Counted> counted_q(0.5, 0.5, 0.5, 0.5);
const Vector3<Counted> counted_v(0.1, 0.2, 0.3);

Vector3<Counted> counted_spin(const Counted&) { return counted_v; }

template <class Method>
support::Operations step_of_four() {
  const Four<Counted> y = coefficients(counted_q);
  const auto rate = rate_of_four<Counted>(counted_spin);
  return support::count([&] { Method::step(rate, Counted(0), y, Counted(0.1)); });
}

template <class Method>
support::Operations step_of_nine() {
  const Nine<Counted> y = to_matrix(counted_q).reshaped();
  const auto rate = rate_of_nine<Counted>(counted_spin);
  return support::count([&] { Method::step(rate, Counted(0), y, Counted(0.1)); });
}

Table counts_table() {
  Table table({"what", "four numbers", "nine numbers"});
  const Quaternion<Counted>& q = counted_q;
  const Vector3<Counted>& v = counted_v;
  const Matrix3<Counted> R = to_matrix(q);
  const auto count = [](auto&& action) {
    return operations(support::count([&] { support::keep(action()); }));
  };
  table.add({"compose two", count([&] { return Quaternion<Counted>(q * q); }),
             count([&] { return Matrix3<Counted>(R * R); })});
  table.add({"turn a point", count([&] { return Vector3<Counted>(q * v); }),
             count([&] { return Vector3<Counted>(R * v); })});
  table.add({"rate of change", count([&] { return quaternion_dot<Counted>(q, v); }),
             count([&] { return rotation_dot<Counted>(R, v); })});
  table.add(
      {"one step of Euler", operations(step_of_four<Euler>()), operations(step_of_nine<Euler>())});
  table.add({"one step of midpoint", operations(step_of_four<Midpoint>()),
             operations(step_of_nine<Midpoint>())});
  table.add({"one step of RK4", operations(step_of_four<Rk4>()), operations(step_of_nine<Rk4>())});
  table.add({"normalise", count([&] { return q.normalized(); }), ""});
  table.add({"turn into a matrix", count([&] { return to_matrix(q); }), ""});
  return table;
}

// ── Error against cost ──

/// A body that spins about an axis of its own, which goes round the vertical: a top.
constexpr double lean = 0.6, precession = 2, own = 5;  // [rad], [rad/s], [rad/s]
constexpr double span = 10;                            // [s]

Quat top_orientation(double t) {
  return from_axis_angle(Vec3::UnitZ(), precession * t) * from_axis_angle(Vec3::UnitX(), lean) *
         from_axis_angle(Vec3::UnitZ(), own * t);
}

/// ω(t) of the top, in world axes.
Vec3 top_spin(double t) {
  const double s = std::sin(lean), c = std::cos(lean);
  return {own * s * std::sin(precession * t), -own * s * std::cos(precession * t),
          precession + own * c};
}

template <class Method>
double error_of_four(int steps) {
  const Four<double> y =
      stepped<Method>(rate_of_four<double>(top_spin), coefficients(top_orientation(0)),
                      span / steps, steps, as_it_is);
  return angle_between(top_orientation(span), from_coefficients(y));
}

template <class Method>
double error_of_nine(int steps) {
  const Nine<double> y = stepped<Method>(rate_of_nine<double>(top_spin),
                                         Nine<double>(to_matrix(top_orientation(0)).reshaped()),
                                         span / steps, steps, as_it_is);
  return angle_apart(to_matrix(top_orientation(span)), nearest_rotation(y.reshaped(3, 3)));
}

/// One turn about the ω in the middle of the step.
Quat turn_step(const Quat& q, const Vec3& middle, double step) {
  return exp_quaternion<double>(step * middle) * q;
}

double error_of_turns(int steps) {
  Quat q = top_orientation(0);
  const double step = span / steps;
  for (int i = 0; i < steps; ++i) q = turn_step(q, top_spin((i + 0.5) * step), step);
  return angle_between(top_orientation(span), q);
}

std::string work_figure() {
  support::Plot plot{"error against work",
                     {"multiplications for 10 s", support::Scale::log},
                     {"orientation off by [rad]", support::Scale::log},
                     {}};
  const auto add = [&](const std::string& name, auto&& error, const support::Operations& each) {
    support::Series series{name, {}, {}};
    for (int steps = 128; steps <= 65536; steps *= 2) {
      const double off = error(steps);
      if (off < 1e-11 || off > 0.5) continue;
      series.x.push_back(1.0 * steps * each.multiplications);
      series.y.push_back(off);
    }
    plot.series.push_back(series);
  };
  add("Euler, nine", error_of_nine<Euler>, step_of_nine<Euler>());
  add("Euler, four", error_of_four<Euler>, step_of_four<Euler>());
  add("midpoint, nine", error_of_nine<Midpoint>, step_of_nine<Midpoint>());
  add("midpoint, four", error_of_four<Midpoint>, step_of_four<Midpoint>());
  add("RK4, nine", error_of_nine<Rk4>, step_of_nine<Rk4>());
  add("RK4, four", error_of_four<Rk4>, step_of_four<Rk4>());
  return support::to_svg(plot);
}

/// How many steps an error takes; 0 for more than 200,000.
double steps_for(double target, const std::function<double(int)>& error) {
  double before = error(32);
  for (int steps = 64; steps <= 1 << 18; steps *= 2) {
    const double now = error(steps);
    if (now < target)
      return 0.5 * steps * std::pow(2, std::log(before / target) / std::log(before / now));
    before = now;
  }
  return 0;
}

/// A large number, rounded to two digits and written in full.
std::string two_digits(double value) {
  const double unit = std::pow(10, std::floor(std::log10(value)) - 1);
  return number(std::round(value / unit) * unit, 9);
}

/// The least seconds of each action, in turns, so that all see the same machine.
std::vector<double> seconds_each(const std::vector<std::function<void()>>& batches, int batch) {
  std::vector<double> least(batches.size(), 1e9);
  for (int again = 0; again < 5; ++again)
    for (std::size_t i = 0; i < batches.size(); ++i)
      least[i] = std::min(least[i], support::shortest_run(0.006, batches[i]) / batch);
  return least;
}

/// An action many times over, in one call.
template <class Action>
std::function<void()> batch_of(int batch, Action action) {
  return [batch, action]() mutable {
    for (int i = 0; i < batch; ++i) action();
  };
}

constexpr int batch = 1000;

template <class Method, class State, class Rate>
std::function<void()> steps_of(const Rate& rate, State y) {
  return batch_of(batch, [rate, y]() mutable {
    y = Method::step(rate, 0.0, y, 1e-3);
    support::keep(y);
  });
}

Table reach_table() {
  Table table({"method", "a step", "steps to 1e-4 rad", "time", "to 1e-8 rad", "time"});
  const auto four = rate_of_four<double>(steady);
  const auto nine = rate_of_nine<double>(steady);
  const std::vector<std::string> names{"Euler, nine",        "Euler, four", "midpoint, nine",
                                       "midpoint, four",     "RK4, nine",   "RK4, four",
                                       "turns about ω, four"};
  const std::vector<std::function<double(int)>> errors{
      error_of_nine<Euler>, error_of_four<Euler>, error_of_nine<Midpoint>, error_of_four<Midpoint>,
      error_of_nine<Rk4>,   error_of_four<Rk4>,   error_of_turns};
  const std::vector<double> seconds = seconds_each(
      {steps_of<Euler>(nine, nine_start), steps_of<Euler>(four, four_start),
       steps_of<Midpoint>(nine, nine_start), steps_of<Midpoint>(four, four_start),
       steps_of<Rk4>(nine, nine_start), steps_of<Rk4>(four, four_start),
       batch_of(
           batch,
           [q = Quat::Identity()]() mutable { support::keep(q = turn_step(q, steady(0), 1e-3)); })},
      batch);
  for (std::size_t i = 0; i < names.size(); ++i) {
    std::vector<std::string> row{names[i], support::duration(seconds[i])};
    for (const double target : {1e-4, 1e-8}) {
      const double steps = steps_for(target, errors[i]);
      row.push_back(steps > 0 ? two_digits(steps) : "> 200000");
      row.push_back(steps > 0 ? support::duration(steps * seconds[i]) : "");
    }
    table.add(row);
  }
  return table;
}

Table times_table() {
  Table table({"what", "time"});
  std::vector<std::string> names;
  std::vector<std::function<void()>> batches;
  const auto add = [&](const std::string& name, auto&& action) {
    names.push_back(name);
    batches.push_back(batch_of(batch, [action] { support::keep(action()); }));
  };
  static Quat q = top_orientation(1), r = top_orientation(1.2);
  static Mat3 R = to_matrix(q);
  static Vec3 p(1, 2, 3);
  const auto fresh = [](auto& value) -> auto& { return support::keep(value), value; };
  add("normalise four numbers", [=] { return normalize(fresh(q)); });
  add("one Newton step for nine", [=] { return newton_rotation_step(fresh(R)); });
  add("Gram–Schmidt for nine", [=] { return gram_schmidt(fresh(R)); });
  add("turn a point by four numbers", [=] { return Vec3(fresh(q) * fresh(p)); });
  add("turn a point by nine", [=] { return Vec3(fresh(R) * fresh(p)); });
  add("nine numbers of four", [=] { return to_matrix(fresh(q)); });
  add("four numbers of nine", [=] { return from_matrix(fresh(R)); });
  add("four numbers mixed, normalised",
      [=] { return normalize(mix_four(fresh(q), fresh(r), 0.3)); });
  add("slerp", [=] { return slerp(fresh(q), fresh(r), 0.3); });
  const std::vector<double> seconds = seconds_each(batches, batch);
  for (std::size_t i = 0; i < names.size(); ++i)
    table.add({names[i], support::duration(seconds[i])});
  return table;
}

// ── Where digits are lost ──

Table small_angles_table() {
  Table table({"turn [rad]", "2 acos w: relative error", "2 atan2(|v|, w)"});
  for (const double angle : {1.0, 1e-2, 1e-4, 1e-6, 1e-7, 1e-8}) {
    const Quat q = from_axis_angle({2, -1, 2}, angle);
    const auto off = [&](double read) { return error_or_rounding(std::abs(read / angle - 1)); };
    table.add(
        {number(angle), off(2 * std::acos(q.w())), off(2 * std::atan2(q.vec().norm(), q.w()))});
  }
  return table;
}

/// The formula with sines, as it stands in books; `straight` mixes linearly above that cosine.
Quat by_sines(const Quat& a, const Quat& b, double t, double straight) {
  const double cosine = a.dot(b);
  if (cosine > straight) return mix_four(a, b, t).normalized();
  const double angle = std::acos(std::min(cosine, 1.0));
  return Quat(
      Eigen::Vector4d((std::sin((1 - t) * angle) * a.coeffs() + std::sin(t * angle) * b.coeffs()) /
                      std::sin(angle)));
}

Table near_table() {
  Table table(
      {"apart [rad]", "sines and acos: off by", "straight above cos = 0.9995", "a (a⁻¹ b)ᵗ"});
  const Vec3 axis = Vec3(2, -1, 2).normalized();
  for (const double angle : {1.0, 0.06, 1e-3, 1e-8, 0.0}) {
    const Quat a = exp_quaternion<double>(Vec3(0.3, -1.1, 0.7));
    const Quat b = exp_quaternion<double>(angle * axis) * a;
    const Quat exact = exp_quaternion<double>(0.25 * angle * axis) * a;
    const auto off = [&](const Quat& q) {
      return q.coeffs().hasNaN() ? "not a number" : error_or_rounding(angle_between(exact, q));
    };
    table.add({number(angle), off(by_sines(a, b, 0.25, 2)), off(by_sines(a, b, 0.25, 0.9995)),
               off(slerp(a, b, 0.25))});
  }
  return table;
}

}  // namespace

int main(int argc, char** argv) {
  support::Chapter chapter("04_quaternions",
                           "Quaternions: the way between two orientations, drift, and its price");
  chapter.table("ways", "Five ways of 150°", ways_table);
  chapter.table("turns", "Some turns and their quaternions", turns_table);
  chapter.table("order", "Two quarter turns in both orders", order_table);
  chapter.table("length", "A turn of 60° by a quaternion that is too long", length_table);
  chapter.table("pace", "The pace of a mixture", pace_table);
  chapter.table("drift", "A steady turn of 2 rad/s in steps of 1/60 s", drift_table);
  chapter.table("big_steps", "One step of a large turn", big_steps_table);
  chapter.table("counts", "What the arithmetic of an orientation costs", counts_table);
  chapter.measured("reach", "What an orientation error costs", reach_table);
  chapter.measured("times", "What the other operations take", times_table);
  chapter.table("small_angles", "The angle of a small turn", small_angles_table);
  chapter.table("near", "A quarter of the way between two that are close", near_table);
  chapter.figure("between", between_figure);
  chapter.figure("tracks", tracks_figure);
  chapter.figure("circle", circle_figure);
  chapter.figure("half_turn", half_turn_figure);
  chapter.figure("chord", chord_figure);
  chapter.figure("pace", pace_figure);
  chapter.figure("drift", drift_figure);
  chapter.figure("work", work_figure);
  return chapter.run(argc, argv);
}
