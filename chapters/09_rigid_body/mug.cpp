/// @file
/// A real body with real forces: a mug that hangs by its handle from a spring, in the air.

#include "common.hpp"
#include "mug_drawing.hpp"
#include "parts.hpp"

namespace rigid_body_chapter {

// ── Where the energy goes ──

namespace {

/// The thirteen numbers and what drag has taken so far [J].
using WithLoss = Eigen::Matrix<double, 14, 1>;

WithLoss rate_with_loss(double t, const WithLoss& y) {
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

Ledger ledger_at(double t) {
  WithLoss y = WithLoss::Zero();
  y.head<13>() = pack(mug_start());
  if (t > 0) y = integrate_adaptive<Dop853>(rate_with_loss, y, 0.0, t, {1e-12, 1e-12}).y;
  const RigidBodyState<> state = unpack<double>(PackedState<double>(y.head<13>()));
  const Derived<> now = derived(mug(), state);
  const double length = point_position(now, spring.p_body).norm();
  return {state.P.dot(now.v) / 2, state.L.dot(now.omega) / 2, -mug().mass() * weight.g.dot(now.x),
          spring.stiffness / 2 * std::pow(length - spring.rest_length, 2), y[13]};
}

}  // namespace

Table ledger_table() {
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

namespace {

/// From the world to the viewer, who looks along y, a little from above.
Mat3 mug_view() { return exp_rotation(Vec3(0.2, 0, 0)) * exp_rotation(Vec3(-pi / 2, 0, 0)); }

/// Two seconds of the motion, or a part of them, and the mug at some moments.
void draw_motion(support::Sketch& sketch, double from, double to,
                 const std::vector<double>& times) {
  const Mat3 view = mug_view();
  const auto motion = hanging_mug();
  std::vector<Vec2> centre, hook;
  for (int i = 0; i <= 120; ++i) {
    const Derived<> now =
        derived(mug(), followed(motion, mug_start(), from + (to - from) * i / 120.0));
    centre.push_back((view * now.x).head<2>());
    hook.push_back((view * point_position(now, spring.p_body)).head<2>());
  }
  sketch.curve(hook, {"c1", 1.4});
  sketch.curve(centre, {"c0", 2.2});
  for (const double t : times) {
    const Derived<> now = derived(mug(), followed(motion, mug_start(), t));
    sketch.curve({{0, 0}, (view * point_position(now, spring.p_body)).head<2>()}, {"c2", 1.4});
    draw_mug(sketch, view, now);
    const bool at_the_edge = now.x.z() > -0.35, left = now.x.x() < 0;
    const Vec2 beside = at_the_edge ? Vec2(left ? -6 : 0, 58) : Vec2(left ? -34 : 34, 40);
    const std::string anchor = left ? "end" : at_the_edge ? "middle" : "start";
    sketch.words((view * now.x).head<2>(), beside, support::svg_number(t, 2) + " s", "ink", anchor);
  }
  sketch.dot({0, 0}, "ink", 5);
}

}  // namespace

std::string mug_figure() {
  support::Sketch sketch(760, 450, "A mug on a spring: its centre of mass, its handle, the spring",
                         15);
  sketch.look({205, 48, 400});
  draw_motion(sketch, 0, 1, {0, 0.35, 0.9});
  sketch.words({0, 0}, {0, -18}, "the first second", "ink", "middle");
  // Axes and a length, in the corner that stays free.
  const Vec2 corner(-0.48, -0.9);
  sketch.arrow(corner, corner + Vec2(0.1, 0), {"faint", 1.6});
  sketch.words(corner + Vec2(0.1, 0), {4, 5}, "x, 10 cm", "ink");
  sketch.arrow(corner, corner + Vec2(0, 0.1), {"faint", 1.6});
  sketch.words(corner + Vec2(0, 0.1), {-4, -6}, "z", "ink");
  sketch.look({575, 48, 400});
  draw_motion(sketch, 1, 2, {1.05, 1.45, 1.9});
  sketch.words({0, 0}, {0, -18}, "the next second", "ink", "middle");
  return sketch.svg();
}

}  // namespace rigid_body_chapter
