#pragma once
/// @file
/// Mass properties of point masses: I = Σ m (rᵀr 1 − r rᵀ), r = x − c, c = Σ m x / Σ m.
///
/// The sums are taken about the first point and then moved, so bodies far away lose no digits.
/// Source: e.g. Goldstein, "Classical Mechanics" (3rd ed. 2002), eq. 5.8.

#include <cmath>
#include <span>

#include "tumble/core/require.hpp"
#include "tumble/mass/as_point.hpp"
#include "tumble/mass/moments.hpp"
#include "tumble/mass/parallel_axis.hpp"

namespace tumble {

/// @addtogroup mass
/// @{

/// A mass [kg] in one point [m].
struct PointMass {
  double mass = 0;
  Vec3 position = Vec3::Zero();
};

/// The centre of mass of points [m].
/// @throws std::invalid_argument as mass_properties() of points
inline Vec3 centre_of_mass(std::span<const PointMass> points) {
  require(!points.empty(), "no point masses were given");
  const Vec3 first = points.front().position;
  simd::DoubleDouble mass, x, y, z;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const PointMass& p = points[i];
    require(p.mass >= 0 && std::isfinite(p.mass) && p.position.allFinite(), "point mass ", i,
            " (mass ", p.mass, " kg at ", detail::AsPoint{p.position},
            ") is negative or not finite");
    const Vec3 moment = p.mass * (p.position - first);
    mass += p.mass;
    x += moment.x();
    y += moment.y();
    z += moment.z();
  }
  require(mass.hi > 0, "all ", points.size(), " point masses are 0 kg");
  return first + Vec3(double(x / mass), double(y / mass), double(z / mass));
}

/// Mass, centre and inertia of points. Points on one line have no inertia about it: the tensor is
/// then not one that a body can be simulated with (see require_valid_inertia()).
/// @throws std::invalid_argument if there are no points, a mass is negative or not finite, a
///         position is not finite, or all masses are 0
inline MassProperties mass_properties(std::span<const PointMass> points) {
  MassProperties result;
  result.centre = centre_of_mass(points);
  simd::DoubleDouble mass;
  Matrix3<simd::DoubleDouble> sum = Matrix3<simd::DoubleDouble>::Constant(0.0);
  for (const PointMass& p : points) {
    mass += p.mass;
    sum += point_inertia(p.mass, p.position - result.centre).cast<simd::DoubleDouble>();
  }
  result.mass = double(mass);
  result.inertia = sum.unaryExpr([](const simd::DoubleDouble& x) { return double(x); });
  return result;
}

/// @}

}  // namespace tumble
