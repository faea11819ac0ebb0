#pragma once
/// @file
/// Closed meshes to try mass properties on, and how far results are apart.

#include <cmath>
#include <numbers>
#include <vector>

#include "lib/mesh/shapes.hpp"
#include "reference/exact_moments.hpp"
#include "support/inputs.hpp"
#include "tumble/mass/mesh_mass_properties.hpp"

namespace tumble::test {

/// Corners (0,0,0), (1,0,0), (0,1,0), (0,0,1).
inline PolygonMesh unit_tetrahedron() {
  PolygonMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.add_face({0, 2, 1});
  mesh.add_face({0, 1, 3});
  mesh.add_face({0, 3, 2});
  mesh.add_face({1, 2, 3});
  return mesh;
}

/// A straight prism from z = 0 to `height` over a polygon in the xy plane (counter-clockwise).
inline PolygonMesh prism(const std::vector<Eigen::Vector2d>& base, double height) {
  const int n = static_cast<int>(base.size());
  PolygonMesh mesh;
  for (const double z : {0.0, height})
    for (const Eigen::Vector2d& p : base) mesh.vertices.push_back({p.x(), p.y(), z});
  std::vector<int> bottom, top;
  for (int i = 0; i < n; ++i) {
    bottom.push_back(n - 1 - i);
    top.push_back(n + i);
    mesh.add_face({i, (i + 1) % n, n + (i + 1) % n, n + i});
  }
  mesh.add_face(bottom);
  mesh.add_face(top);
  return mesh;
}

/// A box with its middle in the origin, of six quads.
inline PolygonMesh box_mesh(const Vec3& size) {
  const double x = size.x() / 2, y = size.y() / 2;
  PolygonMesh mesh = prism({{-x, -y}, {x, -y}, {x, y}, {-x, y}}, size.z());
  for (Vec3& v : mesh.vertices) v.z() -= size.z() / 2;
  return mesh;
}

/// A torus around z of n × k quads that are not planar; R to the middle of the tube, r its radius.
inline PolygonMesh torus_mesh(int n, int k, double R, double r) {
  constexpr double pi = std::numbers::pi;
  PolygonMesh mesh;
  const auto index = [&](int i, int j) { return (i % n) * k + j % k; };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < k; ++j) {
      const double u = 2 * pi * i / n, v = 2 * pi * j / k, across = R + r * std::cos(v);
      mesh.vertices.push_back({across * std::cos(u), across * std::sin(u), r * std::sin(v)});
      mesh.add_face({index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)});
    }
  }
  return mesh;
}

/// Every vertex x at A x + d.
inline PolygonMesh mapped(PolygonMesh mesh, const Mat3& A, const Vec3& d = Vec3::Zero()) {
  for (Vec3& x : mesh.vertices) x = A * x + d;
  return mesh;
}

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
  const DoubleDouble exact = exact_moments(mesh, reference_point(mesh)).one;
  return std::abs(double((DoubleDouble(mass) - exact) / exact));
}

/// How far two inertia tensors are apart, Frobenius, relative to the second.
inline double inertia_error(const Mat3& I, const Mat3& truth) {
  return (I - truth).norm() / truth.norm();
}

/// How far a centre of mass is from the true one [m], with what rounding took from it.
inline double centre_error(const BoundedMassProperties& body, const PolygonMesh& mesh) {
  using T = DoubleDouble;
  const Vector3<T> found = body.centre.cast<T>() + body.centre_rest.cast<T>();
  return to_double(found - exact_centre(mesh)).norm();
}

}  // namespace tumble::test
