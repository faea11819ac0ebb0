#pragma once
/// @file
/// What an error of a held body's turning is at its centre of mass.
///
/// The turning's error is a part of its angular momentum about the point. That may be nearly all
/// spin about the line to the centre, which does not move the centre: then an error that is a small
/// part of L is a large part of P. With d from the centre to the point it is at most
///
///     δx = d δφ,   δP = m [d]× I_point⁻¹ δl,   δL = I I_point⁻¹ δl
///
/// and where that is too much, a finer turning shows what it is.

#include <vector>

#include "tumble/body/held_body.hpp"
#include "tumble/simulate/trajectory.hpp"

namespace tumble::detail {

/// Sizes of a held body's motion: x [m], P [kg m/s] and L [kg m²/s] of the centre of mass.
struct HeldSizes {
  double x = 0, P = 0, L = 0;
};

/// The error of the states that a turning leads to.
class HeldError {
 public:
  HeldError(const HeldBody& held, const Trajectory& turning);

  /// The report of the turning, with the error that the states have at most.
  /// @param tolerance that was asked for
  SimulationReport report(double tolerance) const;

  /// The same, with the error that a rougher turning's states show, where that is less.
  SimulationReport report(double tolerance, const HeldError& rougher) const;

 private:
  /// The error of states, a part of sizes.
  /// @param angle of the orientation [rad]
  /// @param L     error of L about the point [kg m²/s]
  double part(double angle, double L, const HeldSizes& sizes) const;

  /// By what part of sizes the states differ from those of another turning.
  double difference(const HeldError& other, const HeldSizes& sizes) const;

  /// The sizes that errors are a part of; and each by itself, unless it is so small that it is
  /// rounding.
  HeldSizes sizes_that_matter() const;
  HeldSizes own_sizes() const;

  HeldBody held_;
  SimulationReport turning_;
  double span_;
  double from_origin_;                    ///< of the point [m]
  std::vector<RigidBodyState<>> states_;  ///< at some moments
  HeldSizes sizes_, least_;
  double L_point_ = 0, least_L_point_, omega_ = 0;  ///< about the point [kg m²/s], [rad/s]
};

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/simulate/held_error.inl"
#endif
