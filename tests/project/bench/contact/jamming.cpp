#include "project/bench/contact/jamming.hpp"

#include <cmath>

#include "project/bench/contact/bodies.hpp"
#include "project/bench/contact/problem.hpp"
#include "tumble/quaternion/exp_log.hpp"

namespace tumble::bench {
namespace {

constexpr double duration = 2e-3;
constexpr int steps = 2000;

/// A slender rod that leans at 63.4° to the floor and slides with its tip ahead, μ = 1.5: friction
/// turns it into the floor faster than the floor can lift it.
Scene sliding_rod() {
  constexpr double length = 1, thick = 0.002;
  const double pi = std::acos(-1.), tilt = std::atan(2);
  const Quat q =
      from_axis_angle(Vec3(Vec3::UnitY()), tilt) * from_axis_angle(Vec3(Vec3::UnitX()), pi / 4);
  const double low = length / 2 * std::sin(tilt) + thick / std::sqrt(2) * std::cos(tilt);
  Scene scene{{box({length, thick, thick}, 1, {0, 0, low + 1e-4}, q)},
              {plane(Vec3::UnitZ())},
              Vec3::Zero(),
              0,
              1.5,
              true};
  scene.bodies[0].start.v = {1, 0, -0.1};
  return scene;
}

/// The corner that hits.
Vec3 tip(const Body& body) {
  Vec3 lowest = Vec3::Zero();
  for (int i = 0; i < 8; ++i)
    if ((body.start.q * body.corner(i)).z() < (body.start.q * lowest).z()) lowest = body.corner(i);
  return lowest;
}

double energy(const Body& body, const Motion& now) {
  const Vec3 omega = now.q.conjugate() * now.omega;
  return (body.mass * now.v.squaredNorm() + omega.dot(body.moments.cwiseProduct(omega))) / 2;
}

std::vector<std::string> row(const std::string& name, const std::string& says, const Body& body,
                             const Motion& now) {
  const Vec3 u = now.v + now.omega.cross(now.q * tip(body));
  const double gained = energy(body, now) / energy(body, body.start) - 1;
  if (std::isnan(gained)) return {name, "not a number", "–", "–", "–"};
  return {name, says, support::number(u.x(), 2), support::number(u.z(), 2),
          support::number(100 * gained, 3) + " %"};
}

}  // namespace

Jamming jamming(const std::vector<Stepper>& steppers) {
  const Scene scene = sliding_rod();
  const Body& body = scene.bodies[0];
  Jamming made{support::Table({"method", "says", "slip [m/s]", "leaves with [m/s]", "energy"}), {}};
  const contact::ContactScene own = contact_scene(scene);
  const contact::ContactRun run = simulate_contacts(own, {.until = duration});
  const RigidBodyState<> state = run.state(own, 0, run.t);
  const Derived<> now = derived(own.body(0).body, state);
  const bool jammed = !run.impacts.empty() && run.impacts[0].jammed;
  made.table.add(row("tumble, simulate_contacts", jammed ? "jammed" : "nothing", body,
                     {state.x, now.v, state.q, now.omega}));
  if (!jammed) made.broken += "; Painlevé's rod is not said to be jammed";
  if (run.energy.end > run.energy.start) made.broken += "; Painlevé's rod gains energy";
  for (const Stepper& stepper : steppers)
    if (const auto simulation = stepper.make(scene, duration / steps)) {
      simulation->restart();
      simulation->advance(steps);
      made.table.add(
          row(stepper.software + ", " + stepper.name, "nothing", body, simulation->motion(0)));
    }
  return made;
}

}  // namespace tumble::bench
