#pragma once

#include "tumble/mass/points.hpp"

#include <cmath>

#include "tumble/core/compiled.hpp"
#include "tumble/core/require.hpp"
#include "tumble/mass/as_point.hpp"
#include "tumble/mass/parallel_axis.hpp"

namespace tumble {

TUMBLE_BODY Vec3 centre_of_mass(std::span<const PointMass> points) {
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

TUMBLE_BODY MassProperties mass_properties(std::span<const PointMass> points) {
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

}  // namespace tumble
