#pragma once
/// @file
/// The same kick at different points of a plank.

#include <array>
#include <cmath>

#include "common.hpp"
#include "support/axis.hpp"

namespace momentum_chapter {

constexpr double plank_length = 1, plank_mass = 2;        // [m], [kg]
constexpr double kick_force = 200, kick_duration = 0.01;  // [N], [s]

/// A thin plank along x.
inline RigidBody<> plank() {
  const double width = 0.1, thickness = 0.02, m = plank_mass / 12;
  const Vec3 square(plank_length * plank_length, width * width, thickness * thickness);
  const Vec3 moments = m * (Vec3::Constant(square.sum()) - square);
  return {plank_mass, moments.asDiagonal()};
}

/// A kick with one force, or with several.
struct Kick {
  std::string name;
  std::vector<ForceAtBodyPoint> forces;
};

inline const std::array<Kick, 4> kicks{
    Kick{"at the centre", {{{0, kick_force, 0}, {0, 0, 0}}}},
    Kick{"halfway out", {{{0, kick_force, 0}, {0.25, 0, 0}}}},
    Kick{"at the end", {{{0, kick_force, 0}, {0.5, 0, 0}}}},
    Kick{"both ends, opposite",
         {{{0, kick_force, 0}, {0.5, 0, 0}}, {{0, -kick_force, 0}, {-0.5, 0, 0}}}}};

/// All forces of a kick as one.
struct KickForce {
  std::vector<ForceAtBodyPoint> forces;

  Wrench<> operator()(double t, const RigidBody<>& body, const Derived<>& now) const {
    Wrench<> sum;
    for (const ForceAtBodyPoint& force : forces) sum += force(t, body, now);
    return sum;
  }
};

inline RigidBodyState<> after(const Kick& kick) {
  const RigidBodyRhs motion(plank(), KickForce{kick.forces});
  const PackedState<double> rest = pack(RigidBodyState<>{});
  return unpack<double>(integrate_fixed<Rk4>(motion, rest, 0, kick_duration, 64));
}

/// What the hands have done: each force times the way of its point, along the force.
inline double work(const Kick& kick, const Derived<>& now) {
  double sum = 0;
  for (const auto& [force, p_body] : kick.forces)
    sum += force.dot(point_position(now, p_body) - p_body);
  return sum;
}

inline Table push_table() {
  Table table({"kick", "the centre's speed", "spin", "energy of motion", "of spin", "work"});
  const RigidBody<> body = plank();
  for (const Kick& kick : kicks) {
    const RigidBodyState<> state = after(kick);
    const Derived<> now = derived(body, state);
    table.add({kick.name, number(now.v.norm()) + " m/s", number(now.omega.norm()) + " rad/s",
               number(state.P.dot(now.v) / 2) + " J", number(state.L.dot(now.omega) / 2) + " J",
               number(work(kick, now)) + " J"});
  }
  return table;
}

inline void draw_plank(support::Sketch& sketch, const Derived<>& now, const support::Pen& pen) {
  std::vector<Vec2> outline;
  for (const auto& [x, y] : {std::pair{-.5, -.03}, {.5, -.03}, {.5, .03}, {-.5, .03}, {-.5, -.03}})
    outline.emplace_back(point_position<double>(now, Vec3(x, y, 0)).head<2>());
  sketch.curve(outline, pen);
  sketch.dot(now.x.head<2>(), "c0", 4.5);
}

/// Three planks, seen from above, at equal times after the kick.
inline std::string push_figure() {
  support::Sketch sketch(760, 472, "The same kick at three points of a plank");
  for (std::size_t k = 0; k < 3; ++k) {
    sketch.look({130 + 250. * static_cast<double>(k), 398, 196});
    const RigidBodyRhs free(plank());
    int i = 0;
    for (const Moment& m : followed(free, after(kicks[k]), 4 * 0.37, 5)) {
      draw_plank(sketch, m.now, {"ink", 2, i == 0 ? 1 : 0.6});
      ++i;
    }
    const Vec2 p = kicks[k].forces[0].p_body.head<2>();
    sketch.arrow(p + Vec2(0, -0.22), p + Vec2(0, -0.03), {"c1", 3});
    sketch.words({0, 0}, {0, 62}, kicks[k].name, "ink", "middle");
  }
  sketch.look({0, 398, 196});
  std::vector<std::vector<Vec2>> lines;
  for (int i = 0; i < 5; ++i) lines.push_back({{0.02, 0.37 * i}, {3.78, 0.37 * i}});
  sketch.curves(lines, {"c0", 0.8, 0.5});
  return sketch.svg();
}

}  // namespace momentum_chapter
