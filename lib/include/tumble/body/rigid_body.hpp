#pragma once
/// @file
/// The constants of a rigid body: its mass and, in body coordinates, its inertia tensor
/// and the inverse.
///
/// Body coordinates have their origin at the centre of mass; their axes need not be principal.
/// Source: Baraff, "Rigid Body Simulation I" (1997), §2.10 and §3.

#include "tumble/core/types.hpp"
#include "tumble/mass/mass_properties.hpp"
#include "tumble/mass/validity.hpp"

namespace tumble {

/// @addtogroup body
/// @{

/// A body that can be moved: valid from construction on. T is the scalar the motion is computed in.
template <class T = double>
class RigidBody {
 public:
  /// @param mass   [kg]
  /// @param I_body inertia tensor about the centre of mass [kg m²]
  /// @throws std::invalid_argument for a mass that is not positive, or a tensor that no body has
  RigidBody(double mass, const Mat3& I_body)
      : RigidBody(MassProperties{mass, Vec3::Zero(), I_body}) {}

  /// The body of which these are the mass properties, taken to its own centre of mass.
  /// @throws std::invalid_argument if no body has them
  explicit RigidBody(const MassProperties& properties) {
    require_valid(properties);
    // Divided by its own size first: the inverse of a very small or large tensor would
    // leave the range.
    const double scale = properties.inertia.trace();
    const Mat3 scaled = properties.inertia / scale;
    mass_ = static_cast<T>(properties.mass);
    I_body_ = properties.inertia.cast<T>();
    I_body_inv_ = Mat3(scaled.inverse() / scale).cast<T>();
  }

  T mass() const { return mass_; }                              ///< [kg]
  const Matrix3<T>& I_body() const { return I_body_; }          ///< [kg m²]
  const Matrix3<T>& I_body_inv() const { return I_body_inv_; }  ///< [1/(kg m²)]

 private:
  T mass_;
  Matrix3<T> I_body_, I_body_inv_;
};

/// @}

}  // namespace tumble
