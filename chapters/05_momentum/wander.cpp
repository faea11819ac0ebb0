/// @file
/// Where ω goes while L stands still.

#include <cmath>

#include "common.hpp"
#include "parts.hpp"
#include "support/space_sketch.hpp"

namespace momentum_chapter {

namespace {

using support::Pen, support::SpaceSketch;

/// A body with three different moments, spinning askew.
const RigidBody<>& wanderer() {
  static const RigidBody<> body(1, Vec3(1, 1.6, 2.2).asDiagonal());
  return body;
}

std::vector<Moment> wandering(double duration, int count) {
  const RigidBodyState<> start = state_of_motion<double>(wanderer(), Vec3::Zero(), Quat::Identity(),
                                                         Vec3::Zero(), Vec3(0.3, 1, 0.55));
  return followed(RigidBodyRhs(wanderer()), start, duration, count);
}

/// Rows are three axes, the last of them along L.
Mat3 axes_with_L_upright(const Vec3& L) {
  const Vec3 up = L.normalized(), right = up.unitOrthogonal();
  Mat3 rows;
  rows << right.transpose(), up.cross(right).transpose(), up.transpose();
  return rows;
}

/// The invariable plane as a pale disc about the tip of ω's part along L.
void draw_plane(support::Sketch& sketch, const SpaceSketch& space, double height, double radius) {
  std::vector<Vec2> rim;
  for (const Vec3& p : support::arc({0, 0, height}, {radius, 0, 0}, Vec3::UnitZ(), 2 * pi))
    rim.push_back(space.seen(p));
  sketch.curve(rim, {"faint", 1.2, 1, 0.12});
}

}  // namespace

std::string wander_figure() {
  const std::vector<Moment> moments = wandering(20, 700);
  const Vec3 L = angular_momentum(wanderer(), moments[0].now.R, moments[0].now.omega);
  const Mat3 upright = axes_with_L_upright(L);
  std::vector<Vec3> path;
  for (const Moment& m : moments) path.emplace_back(upright * m.now.omega);
  support::Sketch sketch(760, 470, "The path of ω while L stands still");
  sketch.look({380, 440, 300});
  SpaceSketch space(sketch, support::view_from(-70 * degree, 24 * degree));
  const Vec3 foot(0, 0, path[0].z());
  draw_plane(sketch, space, foot.z(), 0.62);
  space.curve({Vec3::Zero(), foot}, {"c0", 3, 0.45});
  space.arrow(foot, 1.3 * foot, {"c0", 3});
  space.words(1.3 * foot, {12, 6}, "L", "c0", "start");
  space.curve(path, {"c1", 1.6});
  const std::array<std::size_t, 3> drawn{0, 60, 120};
  for (std::size_t i = 0; i < 3; ++i)
    space.arrow(Vec3::Zero(), path[drawn[i]], {"c1", 2.6, 0.4 + 0.3 * static_cast<double>(i)});
  space.words(0.5 * path[drawn[2]], {14, 12}, "ω", "c1", "start");
  space.words(foot + Vec3(0.62, 0, 0), {10, 26}, "ω · L = 2E", "ink", "start");
  sketch.look({60, 440, 1});
  SpaceSketch(sketch, support::view_from(-70 * degree, 24 * degree)).world_axes(Vec3::Zero(), 44);
  return sketch.svg();
}

}  // namespace momentum_chapter
