/// @file
/// Steady forces: the heavy top, its nutation and its sleep, and Taylor series for what has no
/// closed form.

#include "by_series.hpp"
#include "common.hpp"
#include "parts.hpp"
#include "support/two_axes.hpp"
#include "tilted_top.hpp"

namespace scene_chapter {

// ── The tip of the axis ──

namespace {

/// The way of the axis over the sphere, in the world, once round the vertical.
std::vector<Vec3> tip_of(const KnownTurning& scene) {
  const steady::SteadyTorque torque(scene.body, scene.forces);
  const steady::LagrangeTop top =
      steady::LagrangeTop::from(torque, scene.start.q, scene.start.L).value();
  std::vector<Vec3> way{top.at(0).q * Vec3::UnitZ()};
  double round = 0;
  for (int i = 1; std::abs(round) < 2 * pi; ++i) {
    const Vec3 tip = top.at(0.015 * i).q * Vec3::UnitZ(), last = way.back();
    round += std::atan2(last.x() * tip.y() - last.y() * tip.x(), last.head<2>().dot(tip.head<2>()));
    way.push_back(tip);
  }
  return way;
}

/// Seen from high above the horizon.
Mat3 tip_view() { return exp_rotation(Vec3((64 - 90) * degree, 0, 0)); }

void draw_tip(support::Sketch& sketch, const KnownTurning& scene, const std::string& name) {
  const Mat3 view = tip_view();
  std::vector<Vec2> circle;
  for (int i = 0; i <= 90; ++i)
    circle.emplace_back(std::cos(2 * pi * i / 90), std::sin(2 * pi * i / 90));
  sketch.curve(circle, {"faint", 1.2, 1, 0.05});
  const Way way{tip_of(scene), {"c0", 1.7}};
  sketch.curves(visible(way, view, false), {"c0", 1.1, 0.35});
  sketch.curves(visible(way, view, true), way.pen);
  const Vec2 pole = (view * Vec3::UnitZ()).head<2>();
  sketch.dot(pole, "ink", 3);
  sketch.words(pole, {8, 4}, "z");
  sketch.dot((view * way.points.front()).head<2>(), "c1", 4.5);
  sketch.words({0, -1}, {0, 30}, name, "ink", "middle");
}

}  // namespace

std::string tip_figure() {
  support::Sketch sketch(760, 300, "The tip of a heavy top", 18);
  const double spin = 18, tilt = 50 * degree;
  const std::array<double, 3> rounds{0.3, 0, -1.2};
  const std::array<std::string, 3> names{"pushed along", "let go", "pushed back"};
  for (std::size_t i = 0; i < 3; ++i) {
    sketch.look({130 + 250 * static_cast<double>(i), 132, 118});
    draw_tip(sketch, tilted_top(spin, tilt, rounds[i]), names[i]);
  }
  sketch.look({12, 288, 1});
  support::draw_two_axes(sketch, 30, {"x", "y"});
  return sketch.svg();
}

// ── Asleep ──

namespace {

/// The spin above which the top stands upright by itself: L_n² = 4 A μ.
double waking_spin() { return std::sqrt(4 * 1 * 5.0) / 0.5; }

/// How far it leans at most, started a thousandth of a radian off the vertical.
double largest_lean(double spin) {
  const KnownTurning scene = tilted_top(spin, 1e-3, 0);
  const Trajectory way = simulate(scene.body, scene.start, {0, 60, 1e-6}, scene.forces);
  double lean = 0;
  for (int i = 0; i <= 6000; ++i) {
    const Vec3 n = way.at(0.01 * i).q * Vec3::UnitZ();
    lean = std::max(lean, std::atan2(std::hypot(n.x(), n.y()), n.z()));
  }
  return lean;
}

}  // namespace

Table sleep_table() {
  Table table({"spin", "÷ threshold", "leans at most", "by the formula"});
  for (const double part : {0.5, 0.8, 0.9, 0.95, 0.99, 1.01, 1.05, 1.2}) {
    const double spin = part * waking_spin();
    const double cosine = 2 * part * part - 1;  // L_n²/(2 A μ) − 1
    table.add({support::svg_number(spin, 2) + " rad/s", number(part),
               degrees(largest_lean(spin), 3), part < 1 ? degrees(std::acos(cosine), 3) : "0°"});
  }
  return table;
}

// ── Until it wakes ──

namespace {

/// A top that is slowed down by the air, and slowly stops to stand.
Trajectory sleepy_top() {
  KnownTurning scene = tilted_top(25, 1e-3, 0);
  scene.forces.angular_drag = 0.01;
  return simulate(scene.body, scene.start, {0, 60, 1e-6}, scene.forces);
}

/// Positive while the axis is less than 10° off the vertical.
double upright(double, const RigidBodyState<>& state) {
  return (state.q * Vec3::UnitZ()).z() - std::cos(10 * degree);
}

std::optional<Event> it_falls() { return first_event(sleepy_top(), upright); }

double spin_of(const RigidBodyState<>& state) { return state.L.dot(state.q * Vec3::UnitZ()) / 0.5; }

double too_slow(double, const RigidBodyState<>& state) { return spin_of(state) - waking_spin(); }

}  // namespace

Table event_table() {
  Table table({"what happens", "at", "spin then"});
  const Trajectory way = sleepy_top();
  const auto slow = first_event(
      way, [](double, const RigidBodyState<>& state) { return spin_of(state) - waking_spin(); });
  const auto falls = it_falls();
  const auto add = [&](const std::string& what, const Event& event) {
    table.add({what, support::svg_number(event.t, 3) + " s",
               support::svg_number(spin_of(event.state), 3) + " rad/s"});
  };
  add("it spins too slowly to stand", *slow);
  add("it leans by 10°", *falls);
  return table;
}

std::string sleep_figure() {
  support::Plot plot{"a top that slows down", {"time [s]"}, {"axis off the vertical [°]"}, {}};
  const Trajectory way = sleepy_top();
  support::Series lean{"lean", {}, {}};
  for (int i = 0; i <= 796; ++i) {  // then its name is still below the grid's last line
    const double t = 40 + 0.025 * i;
    const Vec3 n = way.at(t).q * Vec3::UnitZ();
    lean.x.push_back(t);
    lean.y.push_back(std::atan2(std::hypot(n.x(), n.y()), n.z()) / degree);
  }
  const double slow = first_event(way, too_slow)->t;
  plot.series = {lean, {"spin below 8.94 rad/s", {slow, slow}, {0, 50}, support::Look::dashed}};
  return support::to_svg(plot);
}

// ── Series ──

Table series_table() {
  Table table({"tolerance of a step", "order", "series", "orientation off by"});
  for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14}) {
    int order = 0, steps = 0;
    const Quat end = by_series(lopsided_body(), tolerance, order, steps);
    table.add({number(tolerance), std::to_string(order), std::to_string(steps),
               error_above(angle_between(end, lopsided_body().end), 1e-12) + " rad"});
  }
  return table;
}

}  // namespace scene_chapter
