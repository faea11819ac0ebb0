#include "tumble/mass/mirtich/mirtich.hpp"

#include <doctest/doctest.h>

#include "lib/mass/meshes.hpp"
#include "support/refusal.hpp"
#include "tumble/mass/mesh_mass_properties.hpp"
#include "tumble/mass/solids/box.hpp"
#include "tumble/mass/transform.hpp"

using namespace tumble;
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
  const MassProperties body = mirtich_mass_properties(test::unit_tetrahedron(), 1);
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
      const BoundedMassProperties body = unchecked_mirtich(mesh, 1),
                                  exact = exact_tetrahedra(mesh, 1);
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
  const BoundedMassProperties fan = exact_tetrahedra(mesh, 1);
  for (const double distance : {0.0, 1.0, 1e3}) {
    const PolygonMesh there =
        test::mapped(mesh, Mat3::Identity(), Vec3(distance, 2 * distance, -distance));
    const BoundedMassProperties body = unchecked_mirtich(there, 1);
    CAPTURE(distance);
    CHECK(mass_error(body.mass, there) <= body.mass_error_bound);
    CHECK(std::abs(body.mass - fan.mass) <= 32 * eps * (1 + distance));
    CHECK(inertia_error(body.inertia, exact_tetrahedra(there, 1).inertia) <=
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
    CHECK(inertia_error(body.inertia, exact_tetrahedra(mesh, 1).inertia) <=
          body.inertia_error_bound + eps);
  }
}

TEST_CASE("Mirtich and the tetrahedra: the doors refuse what has no mass, and say where") {
  const PolygonMesh cube = test::box_mesh(Vec3(1, 1, 1));
  PolygonMesh bad_index = cube, nan = cube;
  bad_index.corners[3] = 99;
  nan.vertices[2].x() = std::nan("");
  for (const auto door : {mirtich_mass_properties, mesh_mass_properties}) {
    CHECK(door(cube, 2).mass == 2);
    for (const double density : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()})
      CHECK_REFUSED(door(cube, density), "the density");
    CHECK_REFUSED(door(test::without_face(cube, 2), 1), "open");
    CHECK_REFUSED(door(test::inside_out(cube), 1), "inside out");
    CHECK_REFUSED(door(bad_index, 1), "#100");
    CHECK_REFUSED(door(nan, 1), "nan");
    CHECK_REFUSED(door(PolygonMesh{}, 1), "no faces");
    CHECK_REFUSED(door(test::mapped(cube, Vec3(1, 1, 0).asDiagonal().toDenseMatrix()), 1),
                  "no volume");
  }
}

TEST_CASE("require_volume: what the diagnosis may let through is refused after the integrals") {
  const PolygonMesh cube = test::box_mesh(Vec3(1, 1, 1));
  CHECK_REFUSED(require_volume(unchecked_mass_properties(test::inside_out(cube), 1)), "inside out",
                "mass -1");
  const PolygonMesh sheet = test::mapped(cube, askew() * Vec3(1, 1, 0).asDiagonal());
  CHECK_REFUSED(require_volume(unchecked_mirtich(sheet, 1)), "no volume");
  CHECK_REFUSED(require_volume(unchecked_mass_properties(PolygonMesh{}, 1)), "no volume");
  const PolygonMesh speck = test::mapped(cube, 1e-80 * Mat3::Identity());
  CHECK_REFUSED(require_volume(unchecked_mass_properties(speck, 1)), "too small or too large");
}
