#pragma once
/// @file
/// What all parts of this chapter's program share: the bodies that tumble, and how they are set
/// spinning.

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "support/objects/objects.hpp"
#include "support/plot.hpp"
#include "support/sketch.hpp"
#include "support/table.hpp"
#include "tumble/body.hpp"
#include "tumble/free_body/free_motion.hpp"
#include "tumble/mass/mesh_mass_properties.hpp"
#include "tumble/ode.hpp"
#include "tumble/quaternion.hpp"
#include "tumble/rotation.hpp"

namespace rigid_body_chapter {

using namespace tumble;
using support::error_number;
using support::error_or_rounding;
using support::number;
using support::Table;
using support::Vec2;

constexpr double pi = std::numbers::pi, degree = pi / 180;

inline const objects::Object& handle_object = objects::all[0];
inline const objects::Object& nut_object = objects::all[1];
inline const objects::Object& mug_object = objects::all[3];

inline MassProperties properties_of(const objects::Object& object) {
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
inline PolygonMesh centred(const objects::Object& object) {
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

/// ω along the axes of the least, middle and largest moment [rad/s].
inline Vec3 omega_principal(const RigidBody<>& body, const RigidBodyState<>& state) {
  const Derived<> now = derived(body, state);
  return principal_axes(body.I_body()).R.transpose() * (now.R.transpose() * now.omega);
}

/// The handle of all tables: one turn a second about its stem, 0.01 rad off.
inline RigidBodyState<> handle_start() { return spinning(handle(), 2 * pi, 0.01); }

/// By how much `a` is turned against `b` [rad].
inline double turned_apart(const RigidBodyState<>& a, const RigidBodyState<>& b) {
  return angle_between(a.q, b.q);
}

/// The order that two errors show, the second with half the step.
inline std::string order_text(double coarse, double fine) {
  return number(std::log2(coarse / fine), 2);
}

/// The state after so many steps of one length.
template <class Method, class Motion>
RigidBodyState<> stepped(const Motion& motion, const RigidBodyState<>& start, double duration,
                         int steps) {
  return unpack<double>(integrate_fixed<Method>(motion, pack(start), 0, duration, steps));
}

}  // namespace rigid_body_chapter
