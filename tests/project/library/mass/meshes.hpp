#pragma once
/// @file
/// Closed meshes to try mass properties on, and how far results are apart.

#include <cmath>
#include <numbers>
#include <vector>

#include "project/harness/inputs.hpp"
#include "project/library/mesh/shapes.hpp"
#include "reference/exact_moments.hpp"
#include "tumble/mass/mesh_mass_properties.hpp"

namespace tumble::test {

using namespace reference;

/// A rotation about no axis in particular.
inline Mat3 askew() { return Quat(0.3, 0.5, -0.7, 0.2).normalized().toRotationMatrix(); }

/// The three ways to integrate, by name. Nothing is checked.
inline BoundedMassProperties fast(const PolygonMesh& mesh, double density) {
  return unchecked_mass_properties(mesh, density, Accuracy::fast);
}
inline BoundedMassProperties tight(const PolygonMesh& mesh, double density) {
  return unchecked_mass_properties(mesh, density, Accuracy::tight);
}
inline BoundedMassProperties textbook(const PolygonMesh& mesh, double density) {
  return unchecked_mass_properties(mesh, density, Accuracy::textbook);
}

/// The error of a mass against the exact volume (density 1), relative.
inline double mass_error(double mass, const PolygonMesh& mesh) {
  const simd::DoubleDouble exact = exact_moments(mesh, detail::reference_point(mesh)).one;
  return std::abs(double((simd::DoubleDouble(mass) - exact) / exact));
}

/// How far two inertia tensors are apart, Frobenius, relative to the second.
inline double inertia_error(const Mat3& I, const Mat3& truth) {
  return (I - truth).norm() / truth.norm();
}

/// How far a centre of mass is from the true one [m], with what rounding took from it.
inline double centre_error(const BoundedMassProperties& body, const PolygonMesh& mesh) {
  using T = simd::DoubleDouble;
  const Vector3<T> found = body.centre.cast<T>() + body.centre_rest.cast<T>();
  return detail::to_double(found - exact_centre(mesh)).norm();
}

}  // namespace tumble::test
