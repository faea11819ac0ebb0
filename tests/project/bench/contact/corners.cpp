// Bodies with corners, one impact each: the truth is the reference in double-doubles.
#include <cmath>

#include "project/bench/contact/bodies.hpp"
#include "project/bench/contact/problem.hpp"
#include "project/bench/contact/reference_brick.hpp"
#include "tumble/quaternion/exp_log.hpp"

namespace tumble::bench {
namespace {

/// After the first impact, halfway to the second one.
Motion after_first_impact(const Scene& scene) {
  ReferenceBrick twice(scene);
  twice.next_impact();
  const double first = twice.t();
  twice.next_impact();
  ReferenceBrick reference(scene);
  reference.next_impact();
  reference.fly((twice.t() - first) / 2);
  return reference.motion();
}

double duration_of(const Scene& scene) {
  ReferenceBrick reference(scene);
  reference.next_impact();
  const double first = reference.t();
  reference.next_impact();
  return first + (reference.t() - first) / 2;
}

/// The farthest that a corner is off.
double corner_error(const Body& body, const Motion& found, const Motion& truth) {
  double most = 0;
  for (int i = 0; i < 8; ++i) {
    const Vec3 corner = body.corner(i);
    const Vec3 off = found.x + found.q.normalized() * corner - truth.x - truth.q * corner;
    most = std::max(most, off.norm());
    if (std::isnan(off.sum())) return off.sum();
  }
  return most;
}

/// It stands on one edge of four, so that a corner is lowest and all of it stays in a plane.
Problem rod() {
  const double pi = std::acos(-1.);
  const Quat q =
      from_axis_angle(Vec3(Vec3::UnitY()), pi / 6) * from_axis_angle(Vec3(Vec3::UnitX()), pi / 4);
  const Scene scene{
      {box({1, 0.05, 0.05}, 1, {0, 0, 0.8}, q)}, {plane(Vec3::UnitZ())}, weight, 0.6, 0, true};
  const Motion truth = after_first_impact(scene);
  const auto error = [truth, body = scene.bodies[0]](const std::vector<Motion>& end) {
    return corner_error(body, end[0], truth);
  };
  const double duration = duration_of(scene);
  // What places have digits for, and a fifth of a second with velocities after some 100 roundings.
  constexpr double promised = 2 * 16 * eps * (0.8 + 0.5) + 0.2 * 100 * eps * 5;
  return {
      "rod",
      "ROD: dropped at 30°, lands on a corner, no friction, e = 0.6, halfway to the next impact",
      "error of its corners [m]",
      scene,
      duration,
      at_end(scene, duration, error),
      promised};
}

Problem brick() {
  const Quat q(0.9, 0.3, -0.2, 0.25);
  const Scene scene{
      {box({0.2, 0.1, 0.06}, 2, {0, 0, 0.6}, q)}, {plane({0.5, 0, std::sqrt(0.75)})}, weight, 0.5};
  const Motion truth = after_first_impact(scene);
  const double reach = scene.bodies[0].reach();
  const auto error = [truth, reach](const std::vector<Motion>& end) {
    return std::max((end[0].v - truth.v).norm(), reach * (end[0].omega - truth.omega).norm());
  };
  const double duration = duration_of(scene);
  // Some 100 roundings of an impact, and the time of 16 ε of a metre, at 3 m/s, times g.
  constexpr double promised = 100 * eps * 5 + 16 * eps / 3 * 9.81;
  return {
      "brick",
      "BRICK: its corner hits an incline of 30°, no friction, e = 0.5, halfway to the next impact",
      "error of its velocities [m/s]",
      scene,
      duration,
      at_end(scene, duration, error),
      promised};
}

}  // namespace

std::vector<Problem> corner_problems() { return {rod(), brick()}; }

}  // namespace tumble::bench
