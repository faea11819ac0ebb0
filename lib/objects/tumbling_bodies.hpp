#pragma once
/// @file
/// The objects as rigid bodies, and the T-handle and the wing nut as they are set spinning: about
/// the middle axis, not quite.

#include <numbers>

#include "objects/objects.hpp"
#include "tumble/body.hpp"
#include "tumble/elliptic/integrals.hpp"
#include "tumble/free_body/free_trajectory.hpp"
#include "tumble/mass/mesh_mass_properties.hpp"
#include "tumble/ode.hpp"
#include "tumble/quaternion.hpp"

namespace tumble::bodies {

using objects::Object;

inline const Object& handle_object = objects::all[0];
inline const Object& nut_object = objects::all[1];

inline MassProperties properties_of(const Object& object) {
  return mesh_mass_properties(object.mesh(object.for_drawings), object.density);
}

inline const RigidBody<>& handle() {
  static const RigidBody<> body(properties_of(handle_object));
  return body;
}

inline const RigidBody<>& nut() {
  static const RigidBody<> body(properties_of(nut_object));
  return body;
}

/// The mesh with its centre of mass in the origin.
inline PolygonMesh centred(const Object& object) {
  PolygonMesh mesh = object.mesh(object.for_drawings);
  const Vec3 centre = properties_of(object).centre;
  for (Vec3& v : mesh.vertices) v -= centre;
  return mesh;
}

/// A body in the origin that spins about its middle axis, not quite: the axes of the least, the
/// middle and the largest moment are the world's x, y and z.
/// @param rate [rad/s]
/// @param tilt of ω out of the middle axis, towards each of the others [rad]
inline RigidBodyState<> spinning(const RigidBody<>& body, double rate, double tilt) {
  const Quat q = from_matrix(principal_axes(body.I_body()).R).conjugate();
  const Vec3 omega = rate * Vec3(tilt, 1, -tilt);
  return state_of_motion<double>(body, Vec3::Zero(), q, Vec3::Zero(), omega);
}

/// The handle of all tables: one turn a second about its stem, 0.01 rad off.
inline RigidBodyState<> handle_start() { return spinning(handle(), 2 * std::numbers::pi, 0.01); }

inline constexpr double nut_rate = 2 * std::numbers::pi * 5;  // five turns per second [rad/s]
inline constexpr double nut_tilt = 0.01;                      // [rad]

inline RigidBodyState<> nut_start() { return spinning(nut(), nut_rate, nut_tilt); }

/// The time from one turning over to the next [s], of a body that nothing pushes.
inline double time_between_flips(const RigidBody<>& body, const RigidBodyState<>& start) {
  const auto polhode = elliptic::polhode_of(principal_axes(body.I_body()), start.q, start.L);
  return 2 * elliptic::complete_elliptic_k(std::sqrt(polhode->modulus.kc2)) /
         std::abs(polhode->lambda);
}

/// By how much `a` is turned against `b` [rad].
inline double turned_apart(const RigidBodyState<>& a, const RigidBodyState<>& b) {
  return angle_between(a.q, b.q);
}

/// The state after so many steps of one length.
template <class Method, class Rhs>
RigidBodyState<> stepped(const Rhs& motion, const RigidBodyState<>& start, double duration,
                         int steps) {
  return unpack<double>(integrate_fixed<Method>(motion, pack(start), 0, duration, steps));
}

}  // namespace tumble::bodies
