#include "tumble/mass/mirtich/mirtich.hpp"

#include <doctest/doctest.h>

#include "project/harness/refusal.hpp"
#include "project/library/mass/meshes.hpp"
#include "tumble/mass/mesh_mass_properties.hpp"
#include "tumble/mass/solids/box.hpp"
#include "tumble/mass/transform.hpp"

using namespace tumble;
using namespace tumble::detail;
using test::askew;
using test::eps;
using test::inertia_error;
using test::mass_error;

namespace {

/// An L of two boxes, 2 × 1 and 1 × 2 on top of it at the left, `height` high; from (0, 0, 0).
MassProperties L_of_boxes(double height) {
  const auto at = [&](const Vec3& size, const Vec3& low) {
    return translated(mass_properties(Box{size}, 1), low + size / 2);
  };
  return combine(at(Vec3(2, 1, height), Vec3(0, 0, 0)), at(Vec3(1, 2, height), Vec3(0, 1, 0)));
}

PolygonMesh L_mesh(double height) {
  return test::prism({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 3}, {0, 3}}, height);
}

}  // namespace

TEST_CASE("Mirtich: the unit tetrahedron: V = 1/6, I = 1/80 and products −∫ = +1/480") {
  const MassProperties body = unchecked_mirtich(test::unit_tetrahedron(), 1);
  Mat3 I = Mat3::Constant(1.0 / 480);
  I.diagonal().setConstant(1.0 / 80);
  CHECK(std::abs(body.mass - 1.0 / 6) <= 4 * eps / 6);
  CHECK((body.centre - Vec3::Constant(0.25)).norm() <= 8 * eps * 0.25);
  CHECK(inertia_error(body.inertia, I) <= 32 * eps);
}

TEST_CASE("Mirtich: concave polygons as faces, in every position") {
  const MassProperties truth = L_of_boxes(1.5);
  for (const Vec3& v : test::rotation_vectors(111, 30)) {
    const Mat3 R =
        Eigen::AngleAxisd(v.norm(), v.norm() > 0 ? Vec3(v.normalized()) : Vec3(Vec3::UnitX()))
            .toRotationMatrix();
    const MassProperties body = unchecked_mirtich(test::mapped(L_mesh(1.5), R), 1);
    CAPTURE(v.transpose());
    // Turning rounds the vertices, 3 eps each of 3; the integrals add some 10 eps of their own.
    CHECK(std::abs(body.mass - truth.mass) <= 32 * eps * truth.mass);
    CHECK((body.centre - R * truth.centre).norm() <= 32 * eps * 3);
    CHECK(inertia_error(body.inertia, rotate_inertia(R, truth.inertia)) <= 100 * eps);
  }
}

TEST_CASE(
    "Mirtich: keeps within its bound of the exact value for spheres, tori and stretched ones") {
  for (const PolygonMesh& base : {test::sphere(3), test::torus_mesh(40, 20, 1, 0.4), L_mesh(2)}) {
    for (const Vec3& s : {Vec3(1, 1, 1), Vec3(1, 10, 100), Vec3(1e-3, 1, 1)}) {
      const PolygonMesh mesh = test::mapped(base, askew() * s.asDiagonal(), Vec3(1, 2, 3));
      const BoundedMassProperties body = unchecked_mirtich(mesh, 1);
      const MassProperties exact = test::exact_mass_properties(mesh, 1);
      CAPTURE(s.transpose());
      CHECK(mass_error(body.mass, mesh) <= body.mass_error_bound);
      CHECK(inertia_error(body.inertia, exact.inertia) <= body.inertia_error_bound + eps);
    }
  }
}

TEST_CASE("Mirtich: a face without area brings nothing, where the original gives NaN") {
  PolygonMesh mesh = test::box_mesh(Vec3(1, 2, 3));
  const MassProperties whole = unchecked_mirtich(mesh, 1);
  // A corner of the box once more, in the middle of an edge, and the triangle between: it is flat.
  for (const Mat3& R : {Mat3(Mat3::Identity()), askew()}) {
    PolygonMesh with = test::mapped(mesh, R);
    with.vertices.push_back((with.vertex(0) + with.vertex(1)) / 2);
    with.add_face({0, 1, 8});
    with.add_face({0, 8, 1});
    with.add_face({0, 0, 0});
    with.add_face({2, 3});
    const MassProperties body = unchecked_mirtich(with, 1);
    CHECK(std::abs(body.mass - whole.mass) <= 32 * eps * whole.mass);
    CHECK(inertia_error(body.inertia, rotate_inertia(R, whole.inertia)) <= 64 * eps);
  }
}

TEST_CASE("Mirtich: a face that is not plane is its fan, whatever the origin") {
  PolygonMesh mesh = test::box_mesh(Vec3(1, 1, 1));
  mesh.vertices[6].z() += 0.2;
  const MassProperties fan = test::exact_mass_properties(mesh, 1);
  for (const double distance : {0.0, 1.0, 1e3}) {
    const PolygonMesh there =
        test::mapped(mesh, Mat3::Identity(), Vec3(distance, 2 * distance, -distance));
    const BoundedMassProperties body = unchecked_mirtich(there, 1);
    CAPTURE(distance);
    CHECK(mass_error(body.mass, there) <= body.mass_error_bound);
    CHECK(std::abs(body.mass - fan.mass) <= 32 * eps * (1 + distance));
    CHECK(inertia_error(body.inertia, test::exact_mass_properties(there, 1).inertia) <=
          body.inertia_error_bound + eps);
  }
}

TEST_CASE("Mirtich: from bent to plane the answer changes without a jump") {
  for (double bend = 1e-17; bend < 1e-9; bend *= 2) {
    PolygonMesh mesh = test::box_mesh(Vec3(1, 1, 1));
    mesh.vertices[6] += Vec3(bend, -bend, 3 * bend);
    mesh = test::mapped(mesh, askew());
    const BoundedMassProperties body = unchecked_mirtich(mesh, 1);
    CAPTURE(bend);
    CHECK(mass_error(body.mass, mesh) <= body.mass_error_bound);
    CHECK(inertia_error(body.inertia, test::exact_mass_properties(mesh, 1).inertia) <=
          body.inertia_error_bound + eps);
  }
}
