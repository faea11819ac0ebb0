#include "tumble/mass/transform.hpp"

#include <doctest/doctest.h>

#include "project/harness/refusal.hpp"
#include "project/library/mass/meshes.hpp"
#include "tumble/mass/mesh_mass_properties.hpp"
#include "tumble/mass/solids/box.hpp"

using namespace tumble;
using test::askew;
using test::eps;
using test::inertia_error;
using test::Random;

namespace {

/// Both agree to k roundings; centres to k roundings of `length`.
void check_same(const MassProperties& a, const MassProperties& b, double k, double length) {
  CHECK(std::abs(a.mass - b.mass) <= k * eps * b.mass);
  CHECK((a.centre - b.centre).norm() <= k * eps * length);
  CHECK(inertia_error(a.inertia, b.inertia) <= k * eps);
}

}  // namespace

TEST_CASE("rotate_inertia: a quarter turn about z swaps x and y") {
  const Mat3 R = Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitZ()).toRotationMatrix();
  const Mat3 turned = rotate_inertia(R, Vec3(2, 3, 4).asDiagonal().toDenseMatrix());
  CHECK((turned - Vec3(3, 2, 4).asDiagonal().toDenseMatrix()).norm() <= 4 * eps * 4);
}

TEST_CASE("rotate_inertia: I_world = R I_body Rᵀ, not the other way round, and exactly symmetric") {
  const Mat3 I = Vec3(2, 3, 4).asDiagonal();
  for (const Vec3& v : test::rotation_vectors(60, 50)) {
    const Vec3 axis = v.norm() > 0 ? Vec3(v.normalized()) : Vec3(Vec3::UnitX());
    const Mat3 R = Eigen::AngleAxisd(v.norm(), axis).toRotationMatrix();
    const Mat3 turned = rotate_inertia(R, I);
    CAPTURE(v.transpose());
    for (int i = 0; i < 3; ++i)  // the body's axes are the columns of R
      CHECK((turned * R.col(i) - I(i, i) * R.col(i)).norm() <= 16 * eps * 4);
    CHECK(turned == turned.transpose());
    CHECK(inertia_error(rotate_inertia(R.transpose(), turned), I) <= 32 * eps);
  }
}

TEST_CASE("rotated, translated, scaled: as if the mesh had been") {
  Random rng(61);
  const PolygonMesh mesh = test::mapped(test::unit_tetrahedron(), Mat3::Identity(), Vec3(1, 2, 3));
  const MassProperties body = unchecked_mass_properties(mesh, 2.5);
  for (int i = 0; i < 50; ++i) {
    const Mat3 R = Eigen::AngleAxisd(rng.uniform(-3, 3), rng.direction()).toRotationMatrix();
    const Vec3 d = rng.vector(), s(rng.uniform(0.1, 3), rng.uniform(0.1, 3), rng.uniform(0.1, 3));
    CAPTURE(d.transpose());
    CAPTURE(s.transpose());
    // Moving the vertices rounds them by eps times their distance 5 from the origin, the
    // tetrahedron is 1 wide: relative 5 eps a coordinate, at most 3 (mass) or 5 (inertia) of them
    // times a few.
    const auto moved = [&](const Mat3& A, const Vec3& by) {
      return unchecked_mass_properties(test::mapped(mesh, A, by), 2.5);
    };
    check_same(rotated(body, R), moved(R, Vec3::Zero()), 100, 5);
    check_same(translated(body, d), moved(Mat3::Identity(), d), 100, 5);
    check_same(scaled(body, s), moved(s.asDiagonal(), Vec3::Zero()), 300, 15);
    check_same(scaled(body, s.x()), moved(s.x() * Mat3::Identity(), Vec3::Zero()), 100, 15);
  }
}

TEST_CASE("scaled: mass goes with s³ and inertia with s⁵") {
  const MassProperties body{2, Vec3(1, 0, 0), Vec3(2, 3, 4).asDiagonal()};
  const MassProperties twice = scaled(body, 2.0);
  CHECK(twice.mass == 16);
  CHECK(twice.centre == Vec3(2, 0, 0));
  CHECK(twice.inertia == 32 * body.inertia);
  CHECK(inertia_error(scaled(body, Vec3(2, 2, 2)).inertia, twice.inertia) <= 8 * eps);
}

TEST_CASE("combine: two halves are the whole") {
  const MassProperties half = mass_properties(Box{Vec3(1, 2, 3)}, 700);
  const MassProperties whole =
      combine(translated(half, Vec3(4.5, 0, 0)), translated(half, Vec3(5.5, 0, 0)));
  check_same(whole, translated(mass_properties(Box{Vec3(2, 2, 3)}, 700), Vec3(5, 0, 0)), 8, 5);
}

TEST_CASE("combine: order does not matter, grouping does not, and far away nothing is lost") {
  Random rng(62);
  for (int i = 0; i < 100; ++i) {
    MassProperties bodies[3];
    const Vec3 far = 1e6 * rng.direction();
    for (MassProperties& body : bodies)
      body = translated(rotated(mass_properties(Box{Vec3(1, 2, 3)}, rng.uniform(1, 5)), askew()),
                        far + rng.vector());
    const MassProperties ab = combine(bodies[0], bodies[1]), ba = combine(bodies[1], bodies[0]);
    check_same(ab, ba, 8, 1e6);
    // The offset of the centres is 1 with the rounding of 1e6: 1e6 eps in d, 2e6 eps in d².
    check_same(combine(ab, bodies[2]), combine(bodies[0], combine(bodies[1], bodies[2])), 4e6, 1);
  }
}

TEST_CASE("scaled, combine: refuse what makes no body") {
  const MassProperties body{2, Vec3(1, 0, 0), Vec3(2, 3, 4).asDiagonal()};
  for (const double s : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    CAPTURE(s);
    CHECK_REFUSED(scaled(body, s), "scale factor");
    CHECK_REFUSED(scaled(body, Vec3(1, s, 1)), "scale factors");
    MassProperties bad = body;
    bad.mass = s;
    CHECK_REFUSED(combine(body, bad), "the mass");
    CHECK_REFUSED(combine(bad, body), "the mass");
  }
}
