#pragma once
/// @file
/// A solid turned and moved: its point r is at x + R r.

#include <utility>

#include "tumble/core/solid.hpp"
#include "tumble/mass/transform.hpp"

namespace tumble::solids {

/// @addtogroup mass
/// @{

/// A solid somewhere else than where its type defines it.
template <Solid S>
struct Placed {
  S solid;
  Mat3 R = Mat3::Identity();  ///< rotation, solid to world
  Vec3 x = Vec3::Zero();      ///< where the solid's origin is [m]

  bool contains(const Vec3& point) const { return solid.contains(R.transpose() * (point - x)); }
  Eigen::AlignedBox3d bounds() const {
    const Eigen::AlignedBox3d box = solid.bounds();
    if (box.isEmpty()) return box;
    const Vec3 half = R.cwiseAbs() * (box.sizes() / 2), middle = x + R * box.center();
    return {middle - half, middle + half};
  }
};

/// The solid turned by R (solid to world), then moved by x [m].
template <Solid S>
Placed<S> placed(S solid, const Mat3& R, const Vec3& x) {
  return {std::move(solid), R, x};
}

/// The solid moved by x [m].
template <Solid S>
Placed<S> placed(S solid, const Vec3& x) {
  return {std::move(solid), Mat3::Identity(), x};
}

/// @}

}  // namespace tumble::solids

namespace tumble {

/// @addtogroup mass
/// @{

/// Mass properties of a placed homogeneous solid, in world coordinates.
/// @param density [kg/m³]
/// @throws std::invalid_argument as for the solid itself
template <solids::Solid S>
MassProperties mass_properties(const solids::Placed<S>& placed, double density) {
  return translated(rotated(mass_properties(placed.solid, density), placed.R), placed.x);
}

/// @}

}  // namespace tumble
