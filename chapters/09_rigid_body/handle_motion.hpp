#pragma once
/// @file
/// How a T-handle turns that is thrown about its middle axis: in closed form, and by other laws.

#include <cmath>
#include <numbers>
#include <vector>

#include "09_rigid_body/laws.hpp"
#include "objects/t_handle.hpp"
#include "tumble/free_body/free_trajectory.hpp"
#include "tumble/mass/mirtich/mirtich.hpp"
#include "tumble/ode/rk4.hpp"

namespace rigid_body_chapter::handle_figure {

constexpr double pi = std::numbers::pi;
constexpr double longest = 20, spacing = 0.02;  // of what is shown, of its samples [s]
constexpr int samples = 1000;

/// The handle: its mesh about its centre of mass, and its mass properties.
struct Handle {
  PolygonMesh mesh;
  RigidBody<> body;
  PrincipalAxes axes;
};

inline const Handle& the_handle() {
  static const Handle made = [] {
    PolygonMesh mesh = objects::t_handle(1);
    const MassProperties mass = tumble::detail::unchecked_mirtich(mesh, 2700);
    for (Vec3& v : mesh.vertices) v -= mass.centre;
    const RigidBody<> body(mass);
    return Handle{mesh, body, principal_axes(body.I_body())};
  }();
  return made;
}

/// One turn per second about the middle axis, which points up, and off by `tilt` [rad].
inline RigidBodyState<> start_of(double tilt) {
  Mat3 up;  // the least axis along x, the middle one along z
  up << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  const Quat q = from_matrix(Mat3(up * the_handle().axes.R.transpose()));
  const Vec3 omega = 2 * pi * (up * Vec3(tilt, 1, -tilt));
  return state_of_motion<double>(the_handle().body, Vec3::Zero(), q, Vec3::Zero(), omega);
}

/// The handle at one time.
struct Sample {
  Quat q;      ///< body → world
  Vec3 L;      ///< in the world
  Vec3 omega;  ///< along the axes of the least, the middle and the largest moment [rad/s]
};

inline Sample sample(const Quat& q, const Vec3& L) {
  const Vec3 L_body = the_handle().axes.R.transpose() * (to_matrix(q).transpose() * L);
  return {q, L, L_body.cwiseQuotient(the_handle().axes.moments)};
}

inline std::vector<Sample> in_closed_form(const RigidBodyState<>& start) {
  const FreeTrajectory motion(the_handle().body, start);
  std::vector<Sample> all;
  for (int i = 0; i <= samples; ++i) all.push_back(sample(motion.at(i * spacing).q, start.L));
  return all;
}

inline std::vector<Sample> by_steps(const Law& law, const RigidBodyState<>& start) {
  constexpr int steps = 4;  // per sample
  const RigidBody<>& body = the_handle().body;
  const auto rate = [&](double, const Seven& y) { return law.rate(body, y); };
  const Vec3 omega = derived(body, start).omega;
  Seven y = seven(start.q, law.of_L ? start.L : to_matrix(start.q).transpose() * omega);
  std::vector<Sample> all;
  for (int i = 0; i <= samples; ++i) {
    const Quat q = orientation_in(y).normalized();
    const Vec3 last = y.tail<3>();
    all.push_back(sample(q, law.of_L ? last : to_matrix(q) * (body.I_body() * last)));
    for (int k = 0; k < steps; ++k) y = Rk4::step(rate, 0., y, spacing / steps);
  }
  return all;
}

}  // namespace rigid_body_chapter::handle_figure
