#pragma once
/// @file
/// A real body with real forces: the mug hangs by its handle from a spring, in the air.

#include "objects/tumbling_bodies.hpp"

namespace tumble::bodies {

inline const Object& mug_object = objects::all[3];

inline const RigidBody<>& mug() {
  static const RigidBody<> body(properties_of(mug_object));
  return body;
}

/// The middle of the outermost part of the handle, from the centre of mass [m].
inline Vec3 mug_hook() {
  Vec3 farthest = Vec3::Zero();
  for (const Vec3& v : centred(mug_object).vertices)
    if (v.x() > farthest.x()) farthest = v;
  return {farthest.x(), 0, farthest.z()};
}

inline const Weight weight{};
inline const SpringToWorld spring{mug_hook(), {0, 0, 0}, 12, 0.3};  // [m], [m], [N/m], [m]
inline const BodyDrag drag{0.02, 1e-5};                             // [kg/s], [kg m²/s]

inline RigidBodyRhs<double, Weight, SpringToWorld, BodyDrag> hanging_mug() {
  return RigidBodyRhs(mug(), weight, spring, drag);
}

/// Let go of 40 cm to the side of the hook, upright, with a little spin.
inline RigidBodyState<> mug_start() {
  return state_of_motion<double>(mug(), {-0.4, 0, -0.1}, Quat::Identity(), {0, 0.25, 0},
                                 {2, 3, -1});
}

/// To 12 digits or so.
template <class Rhs>
RigidBodyState<> followed(const Rhs& motion, const RigidBodyState<>& start, double t) {
  return unpack<double>(integrate_adaptive<Dop853>(motion, pack(start), 0.0, t, {1e-14, 1e-14}).y);
}

}  // namespace tumble::bodies
