#pragma once
/// @file
/// A box in any position, as a stand-in for a body: I = R diag(b² + c², …) Rᵀ m/12.

#include <span>

#include "tumble/mass/solids/box.hpp"
#include "tumble/mesh/polygon_mesh.hpp"

namespace tumble::boxes {

/// @addtogroup mass
/// @{

/// A solid box: the points centre + R r with |r.x| ≤ size.x/2 and so on.
struct OrientedBox {
  Vec3 centre = Vec3::Zero();  ///< [m]
  Mat3 R = Mat3::Identity();   ///< rotation, box to world; its columns are the edges' directions
  Vec3 size = Vec3::Zero();    ///< full lengths of the edges [m]

  double volume() const { return size.prod(); }
  bool contains(const Vec3& point) const {
    return Box{size}.contains(R.transpose() * (point - centre));
  }
  Eigen::AlignedBox3d bounds() const {
    const Vec3 half = R.cwiseAbs() * (size / 2);
    return {centre - half, centre + half};
  }
};

/// The smallest box with the edge directions R around some points.
/// @param R rotation, box to world
/// @throws std::invalid_argument if there are no points or one is not finite
OrientedBox box_around(std::span<const Vec3> points, const Mat3& R);

/// The smallest box along the coordinate axes.
/// @throws std::invalid_argument as box_around()
inline OrientedBox aligned_box(std::span<const Vec3> points) {
  return box_around(points, Mat3::Identity());
}

/// Mass properties of a box that is full of mass.
/// @param mass [kg]
/// @throws std::invalid_argument if the mass or an edge is not positive and finite
MassProperties box_mass_properties(const OrientedBox& box, double mass);

/// The box with its proportions kept and its volume changed. With the true volume of a solid,
/// rounded body in it its inertia is nearer to the truth than that of the box around the body (of
/// an ellipsoid to 8 %); of a hollow one it is not.
/// @param volume [m³]
/// @throws std::invalid_argument if the volume, or that of the box, is not positive and finite
OrientedBox shrunk_to(const OrientedBox& box, double volume);

/// @}

}  // namespace tumble::boxes

#ifndef TUMBLE_COMPILED
#include "tumble/mass/oriented_box.inl"
#endif
