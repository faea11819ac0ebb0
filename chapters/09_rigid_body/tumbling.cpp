/// @file
/// Bodies that turn over: a wing nut in pictures, the way of L in the body, how often it happens.

#include "common.hpp"
#include "parts.hpp"
#include "polhodes.hpp"
#include "support/flipbook.hpp"
#include "support/view.hpp"

namespace rigid_body_chapter {

// ── The nut ──

namespace {

/// |L|/B is how fast the nut goes round L while it turns about its middle axis.
/// @return how long it takes [s]
double nut_turn() {
  return 2 * pi * principal_axes(nut().I_body()).moments[1] / nut_start().L.norm();
}

/// Where things are: a row of pictures two turns apart, and below it the spin, each picture above
/// its time.
struct NutStrip {
  static constexpr int pictures = 8;
  static constexpr double width = 760, cell = width / pictures, row = 150, curve = 130;  // [px]
  double turn;                                                                           ///< [s]

  double time(int i) const { return 2 * turn * i; }
  double x(double t) const { return cell * (0.5 + t / (2 * turn)); }
};

/// The nut, and an arrow that is painted on it: out of its bore, along its middle axis.
void draw_nut(support::Sketch& sketch, const RigidBodyState<>& state,
              const support::Placement& at) {
  static const PolygonMesh mesh = centred(nut_object);
  static const Vec3 bore = principal_axes(nut().I_body()).R.col(1);
  const Mat3 view = exp_rotation(Vec3(0.45, 0, 0)) * exp_rotation(Vec3(0, -0.7, 0));
  const Vec3 along = view * to_matrix(state.q) * bore;
  sketch.look({at.x, at.y, at.scale});
  const auto arrow = [&](double from) {
    sketch.arrow(from * along.head<2>(), 0.034 * along.head<2>(), {"c1", 3});
  };
  // A mesh is painted over what points away from the viewer.
  if (along.z() < 0) arrow(0);
  sketch.drawing(support::draw_mesh(mesh, view * to_matrix(state.q), at));
  if (along.z() >= 0) arrow(0.005);
}

/// Turns per second about the bore, over the time of the strip.
void draw_spin(support::Sketch& sketch, const NutStrip& strip) {
  const FreeTrajectory motion(nut(), nut_start());
  const double middle = strip.row + strip.curve / 2, scale = 0.38 * strip.curve / nut_rate;
  const auto at = [&](double t) -> Vec2 {
    return {strip.x(t), -middle + scale * omega_principal(nut(), motion.at(t))[1]};
  };
  std::vector<Vec2> curve, moments;
  for (int i = 0; i <= 400; ++i)
    curve.push_back(at(strip.time(strip.pictures - 1) * i / 400.0 * 1.02));
  for (int i = 0; i < strip.pictures; ++i) moments.push_back(at(strip.time(i)));
  sketch.look({0, 0, 1});
  sketch.curve({{strip.x(0), -middle}, {strip.width, -middle}}, {"faint", 1});
  sketch.curve(curve, {"c1", 2.2});
  sketch.dots(moments, "c1", 4);
  sketch.words({4, -middle + scale * nut_rate}, {0, 5}, "+5");
  sketch.words({4, -middle}, {0, 5}, "0");
  sketch.words({4, -middle - scale * nut_rate}, {0, 5}, "−5");
  sketch.words({strip.width - 8, -middle + scale * nut_rate}, {0, 5},
               "turns per second about the arrow", "c1", "end");
}

}  // namespace

std::string nut_figure() {
  const NutStrip strip{nut_turn()};
  support::Sketch sketch(strip.width, strip.row + strip.curve, "A wing nut turns over", 15);
  const FreeTrajectory motion(nut(), nut_start());
  for (int i = 0; i < strip.pictures; ++i) {
    const double t = strip.time(i);
    draw_nut(sketch, motion.at(t), {strip.x(t), 66, 1850});
    sketch.look({0, 0, 1});
    sketch.words({strip.x(t), -strip.row}, {0, -2}, support::svg_number(t, 1) + " s", "ink",
                 "middle");
  }
  draw_spin(sketch, strip);
  return sketch.svg();
}

std::string slow_motion_figure() {
  // Until it is as at first, but for how far it has gone round.
  const double period = 2 * time_between_flips(nut(), nut_start());
  const int turns = static_cast<int>(std::lround(period / nut_turn()));
  constexpr double seconds_a_turn = 0.2;
  support::Sketch sketch(760, 300, "A wing nut, seen once in each of its turns", 15);
  const FreeTrajectory motion(nut(), nut_start());
  support::flipbook(sketch, turns, seconds_a_turn * turns, [&](int i) {
    draw_nut(sketch, motion.at(nut_turn() * i), {380, 150, 4200});
  });
  return sketch.svg();
}

std::string spin_figure() {
  support::Plot plot{"the nut's ω, in its own axes", {"time [s]"}, {"[rad/s]"}, {}};
  const FreeTrajectory motion(nut(), nut_start());
  const std::array<std::string, 3> names{"least moment", "middle moment", "largest moment"};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    support::Series series{names[axis], {}, {}};
    for (int i = 0; i <= 600; ++i) {
      const double t = 0.01 * i;
      series.x.push_back(t);
      series.y.push_back(omega_principal(nut(), motion.at(t))[static_cast<Eigen::Index>(axis)]);
    }
    plot.series.push_back(series);
  }
  return support::to_svg(plot);
}

// ── The way of L in the body ──

std::string polhode_figure() {
  support::Sketch sketch(760, 420, "The ways of the angular momentum in a body that nothing pushes",
                         18);
  sketch.look({190, 190, 172});
  draw_sphere(sketch, principal_axes(handle().I_body()).moments, "T-handle");
  sketch.look({570, 190, 172});
  draw_sphere(sketch, principal_axes(nut().I_body()).moments, "wing nut");
  return sketch.svg();
}

// ── How often ──

Table flips_table() {
  Table table({"aimed to", "handle turns over every", "nut turns over every"});
  for (const double tilt : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
    const double handle_time = time_between_flips(handle(), spinning(handle(), 2 * pi, tilt));
    const double nut_time = time_between_flips(nut(), spinning(nut(), nut_rate, tilt));
    table.add({number(tilt) + " rad", support::svg_number(handle_time, 2) + " s",
               support::svg_number(nut_time, 2) + " s"});
  }
  const auto added = [](const RigidBody<>& body, double rate) {
    const Vec3 I = principal_axes(body.I_body()).moments;
    const double growth = rate * std::sqrt((I[2] - I[1]) * (I[1] - I[0]) / (I[0] * I[2]));
    return support::svg_number(2 * std::log(10) / growth, 2) + " s";
  };
  table.add({"2 ln 10 / λ", added(handle(), 2 * pi), added(nut(), nut_rate)});
  return table;
}

Table aimed_table() {
  Table table({"aimed to", "handle turns over every"});
  const double time = time_between_flips(handle(), spinning(handle(), 2 * pi, 1e-9));
  table.add({"1e-09 rad", support::svg_number(time, 2) + " s"});
  return table;
}

}  // namespace rigid_body_chapter
