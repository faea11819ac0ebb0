#pragma once
/// @file
/// A real body with real forces: a mug that hangs by its handle from a spring, in the air.

#include "common.hpp"
#include "objects/hanging_mug.hpp"

namespace rigid_body_chapter {

// ── Where the energy goes ──

/// The thirteen numbers and what drag has taken so far [J].
using WithLoss = Eigen::Matrix<double, 14, 1>;

inline WithLoss rate_with_loss(double t, const WithLoss& y) {
  static const auto motion = hanging_mug();
  const PackedState<double> packed = y.head<13>();
  const Derived<> now = derived(mug(), unpack<double>(packed));
  WithLoss rate;
  rate << motion(t, packed),
      drag.linear * now.v.squaredNorm() + drag.angular * now.omega.squaredNorm();
  return rate;
}

struct Ledger {
  double motion, spin, height, stretch, lost;  ///< [J]
  double sum() const { return motion + spin + height + stretch + lost; }
};

inline Ledger ledger_at(double t) {
  WithLoss y = WithLoss::Zero();
  y.head<13>() = pack(mug_start());
  if (t > 0) y = integrate_adaptive<Dop853>(rate_with_loss, y, 0.0, t, {1e-12, 1e-12}).y;
  const RigidBodyState<> state = unpack<double>(PackedState<double>(y.head<13>()));
  const Derived<> now = derived(mug(), state);
  const double length = point_position(now, spring.p_body).norm();
  return {state.P.dot(now.v) / 2, state.L.dot(now.omega) / 2, -mug().mass() * weight.g.dot(now.x),
          spring.stiffness / 2 * std::pow(length - spring.rest_length, 2), y[13]};
}

inline Table ledger_table() {
  Table table({"after", "motion", "spin", "height", "spring", "lost", "sum [J]"});
  for (const double t : {0., 0.25, 0.5, 1., 5., 20., 120.}) {
    const Ledger at = ledger_at(t);
    const auto text = [](double joule) { return support::svg_number(joule, 4); };
    table.add({number(t) + " s", text(at.motion), text(at.spin), text(at.height), text(at.stretch),
               text(at.lost), support::svg_number(at.sum(), 8)});
  }
  return table;
}

// ── In pictures ──

/// From the world to the viewer, who looks along y, a little from above.
inline Mat3 mug_view() { return exp_rotation(Vec3(0.2, 0, 0)) * exp_rotation(Vec3(-pi / 2, 0, 0)); }

/// The lines of a mug about its centre of mass: rims, foot, two sides and the handle.
/// @param toward the viewer, in body axes: the sides are where the wall turns away
inline std::vector<std::vector<Vec3>> mug_lines(const Vec3& toward) {
  constexpr double radius = 0.041, height = 0.095, middle = 0.053;
  const auto at = [](double r, double angle, double z) -> Vec3 {
    return Vec3(r * std::cos(angle), r * std::sin(angle), z) - properties_of(mug_object).centre;
  };
  std::vector<std::vector<Vec3>> lines(4);
  for (int i = 0; i <= 24; ++i) {
    const double angle = 2 * pi * i / 24, bend = pi * (0.09 + 0.082 * i / 2.4);
    lines[0].push_back(at(radius, angle, 0));
    lines[1].push_back(at(radius, angle, height));
    lines[2].push_back(at(radius - 0.004, angle, height));
    lines[3].push_back(at(radius + 0.030 * std::sin(bend), 0, middle + 0.026 * std::cos(bend)));
  }
  const double side = std::atan2(toward.y(), toward.x());
  for (const double angle : {side + pi / 2, side - pi / 2})
    lines.push_back({at(radius, angle, 0), at(radius, angle, height)});
  return lines;
}

inline void draw_mug(support::Sketch& sketch, const Derived<>& now) {
  const Mat3 view = mug_view();
  const Vec3 toward = (view * now.R).transpose() * Vec3::UnitZ();
  std::vector<std::vector<Vec2>> seen;
  for (const std::vector<Vec3>& line : mug_lines(toward)) {
    seen.emplace_back();
    for (const Vec3& p : line)
      seen.back().push_back((view * point_position<double>(now, p)).head<2>());
  }
  sketch.curves(seen, {"ink", 1.5});
}

inline std::string mug_figure() {
  support::Sketch sketch(760, 560, "A mug on a spring: its centre of mass, its handle, the spring");
  sketch.look({370, 30, 560});
  const Mat3 view = mug_view();
  const auto motion = hanging_mug();
  std::vector<Vec2> centre, hook;
  for (int i = 0; i <= 240; ++i) {
    const Derived<> now = derived(mug(), followed(motion, mug_start(), i / 100.0));
    centre.push_back((view * now.x).head<2>());
    hook.push_back((view * point_position(now, spring.p_body)).head<2>());
  }
  sketch.curve(hook, {"c1", 1.2});
  sketch.curve(centre, {"c0", 2});
  for (const double t : {0., 0.35, 0.75, 1.05, 1.45, 1.9}) {
    const Derived<> now = derived(mug(), followed(motion, mug_start(), t));
    sketch.curve({{0, 0}, (view * point_position(now, spring.p_body)).head<2>()}, {"c2", 1, 0.7});
    draw_mug(sketch, now);
    sketch.words((view * now.x).head<2>(), {24, 34}, support::svg_number(t, 2) + " s");
  }
  sketch.dot({0, 0}, "ink", 5);
  return sketch.svg();
}

}  // namespace rigid_body_chapter
