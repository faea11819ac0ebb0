#pragma once
/// @file
/// A body that slides on a face. As long as it neither turns nor tips, gravity and friction are
/// constant, and its centre's way is a parabola.

#include <optional>

#include "tumble/contact/rest.hpp"

namespace tumble::contact::detail {

/// How a body slides on.
struct Slide {
  RigidBodyState<> state;  ///< without what it still had of other motions
  Vec3 acceleration;       ///< [m/s²]
  double stops;            ///< after so long, or infinity [s]
};

/// What a body that lies on a face has on smooth ground besides its way: a turning about the
/// normal, which is steady only about a principal axis.
std::optional<Vec3> steady_spin(const Colliding& c, const Vec3& normal);

/// How a body that has come down on a face slides on, if it does: straight, and without tipping.
/// What it has left of hops is forgotten, and so is a turning about the normal that friction stops
/// at once.
/// @param normal out of the ground
std::optional<Slide> slide_of(const Colliding& c, const collide::Convex& shape, const Vec3& normal,
                              const Vec3& gravity, double mu, const Stillness& still);

}  // namespace tumble::contact::detail

#ifndef TUMBLE_COMPILED
#include "tumble/contact/slide.inl"
#endif
