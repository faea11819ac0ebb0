#include "tumble/mass/tetrahedra.hpp"

#include <doctest/doctest.h>

#include <string>

#include "project/library/mass/meshes.hpp"
#include "tumble/mass/solids/box.hpp"

using namespace tumble;
using namespace tumble::detail;
using test::askew;
using test::eps;
using test::inertia_error;
using test::mass_error;

namespace {

struct NamedMesh {
  const char* name;
  PolygonMesh mesh;
};

std::vector<NamedMesh> ordinary_meshes() {
  const PolygonMesh sphere = test::sphere(3), torus = test::torus_mesh(40, 20, 1, 0.4);
  const PolygonMesh L = test::prism({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 3}, {0, 3}}, 1.5);
  return {{"tetrahedron", test::unit_tetrahedron()},
          {"box", test::box_mesh(Vec3(1, 2, 3))},
          {"box askew", test::mapped(test::box_mesh(Vec3(1, 2, 3)), askew())},
          {"L, concave faces", L},
          {"L askew", test::mapped(L, askew(), Vec3(1, 2, 3))},
          {"sphere", sphere},
          {"ellipsoid 1:10:100", test::mapped(sphere, askew() * Vec3(1, 10, 100).asDiagonal())},
          {"torus of skew quads", torus}};
}

/// All within their bounds: the exact tensor that they are compared with is itself rounded by eps.
void check_against_exact(const PolygonMesh& mesh, const BoundedMassProperties& found) {
  const MassProperties exact = test::exact_mass_properties(mesh, 1);
  CHECK(mass_error(found.mass, mesh) <= found.mass_error_bound);
  CHECK(inertia_error(found.inertia, exact.inertia) <= found.inertia_error_bound + eps);
  CHECK(test::centre_error(found, mesh) <= found.centre_error_bound);
}

}  // namespace

TEST_CASE("tetrahedra: the unit tetrahedron: V = 1/6, I = 1/80 and products −∫ = +1/480") {
  const PolygonMesh mesh = test::unit_tetrahedron();
  Mat3 I = Mat3::Constant(1.0 / 480);
  I.diagonal().setConstant(1.0 / 80);
  for (const MassProperties& body :
       {MassProperties(test::fast(mesh, 1)), MassProperties(test::tight(mesh, 1)),
        test::exact_mass_properties(mesh, 1)}) {
    CHECK(std::abs(body.mass - 1.0 / 6) <= 2 * eps / 6);
    CHECK((body.centre - Vec3::Constant(0.25)).norm() <= 4 * eps * 0.25);
    CHECK(inertia_error(body.inertia, I) <= 8 * eps);
  }
}

TEST_CASE(
    "tetrahedra: boxes are what the closed form says, where they are, and density multiplies") {
  for (const Vec3& size : {Vec3(1, 1, 1), Vec3(1, 2, 3), Vec3(0.125, 10, 3)}) {
    const Vec3 place(3, -5, 8);  // with these sizes no vertex is rounded
    const PolygonMesh mesh = test::mapped(test::box_mesh(size), Mat3::Identity(), place);
    const MassProperties truth = mass_properties(Box{size}, 7.5);
    CAPTURE(size.transpose());
    for (const auto method : {test::fast, test::tight}) {
      const BoundedMassProperties body = method(mesh, 7.5);
      CHECK(std::abs(body.mass - truth.mass) <= 4 * eps * truth.mass);
      CHECK((body.centre - place).norm() <= 4 * eps * place.norm());
      CHECK(inertia_error(body.inertia, truth.inertia) <= 8 * eps);
    }
  }
}

TEST_CASE(
    "tetrahedra: the reference of these tests agrees with the volume of a lattice polytope to 28 "
    "digits") {
  // Corners at thirds of integers do not exist in double; at integers all is exact: 6V an integer.
  PolygonMesh mesh = test::unit_tetrahedron();
  Mat3 A;
  A << 101, 7, -3, 5, 97, 11, -2, 13, 103;
  mesh = test::mapped(mesh, A, Vec3(1e6, -1e6, 3));
  const simd::DoubleDouble v =
      test::exact_moments(mesh, Vec3(1e6 + 0.1, -1e6 + 0.7, 0.3)).one * 6.0;
  const double det =
      101.0 * (97 * 103 - 11 * 13) - 7.0 * (5 * 103 + 2 * 11) - 3.0 * (5 * 13 + 2 * 97);
  CHECK(std::abs(double((v - det) / simd::DoubleDouble(det))) <= 1e-28);
}

TEST_CASE("tetrahedra: every path keeps within its own bound of the exact value") {
  for (const NamedMesh& shape : ordinary_meshes()) {
    CAPTURE(std::string(shape.name));
    const BoundedMassProperties fast = test::fast(shape.mesh, 1),
                                tight = test::tight(shape.mesh, 1);
    check_against_exact(shape.mesh, fast);
    check_against_exact(shape.mesh, tight);
    // eps for the rounding of the result, eps for the product with the density.
    CHECK(mass_error(tight.mass, shape.mesh) <= 2 * eps);
    CHECK(inertia_error(tight.inertia, test::exact_mass_properties(shape.mesh, 1).inertia) <=
          2 * eps);
    // The bound says that digits are there: a bound of 1 would let anything pass.
    CHECK(fast.mass_error_bound <= 1e-12);
    CHECK(fast.inertia_error_bound <= 1e-12);
  }
}

TEST_CASE("tetrahedra: polygons and their triangles are the same body") {
  for (const NamedMesh& shape : ordinary_meshes()) {
    CAPTURE(std::string(shape.name));
    const Mat3 triangles = test::tight(test::triangulated(shape.mesh), 1).inertia;
    CHECK(inertia_error(test::tight(shape.mesh, 1).inertia, triangles) <= 8 * eps);
  }
}

TEST_CASE("tetrahedra: a sphere's mesh approaches the ball with the square of its edges") {
  double error[2];
  for (const int level : {3, 4}) {
    const double V = test::fast(test::sphere(level), 1).mass;
    error[level - 3] = 4 * std::numbers::pi / 3 - V;
  }
  CHECK(std::abs(error[0] / error[1] - 4) <= 0.03 * 4);  // next term: h², (1/16)² · 4
}

TEST_CASE("tetrahedra: vertices that no face uses change nothing") {
  PolygonMesh mesh = test::mapped(test::box_mesh(Vec3(1, 2, 3)), askew());
  const BoundedMassProperties without = test::fast(mesh, 1);
  mesh.vertices.push_back(Vec3(1e12, 0, 0));
  mesh.vertices.push_back(Vec3::Constant(std::nan("")));
  const BoundedMassProperties with = test::fast(mesh, 1);
  CHECK(with.inertia == without.inertia);
  CHECK(with.inertia_error_bound == without.inertia_error_bound);
}

TEST_CASE("tetrahedra: threads change no bit, other instructions none that matters") {
  using simd::InstructionSet;
  const PolygonMesh triangles = test::triangulated(test::torus_mesh(200, 101, 1, 0.4));
  for (const PolygonMesh& mesh : {triangles, test::torus_mesh(200, 101, 1, 0.4)}) {
    const Vec3 p = reference_point(mesh);
    const MassProperties exact = test::exact_mass_properties(mesh, 1);
    for (const auto sum : {sum_in_doubles, sum_in_pairs}) {
      for (int i = 0; i <= static_cast<int>(simd::best_instruction_set()); ++i) {
        const auto set = static_cast<InstructionSet>(i);
        CAPTURE(i);
        const Moments<simd::DoubleDouble> one = sum(mesh, p, {1, set}).raw,
                                          three = sum(mesh, p, {3, set}).raw;
        CHECK(one.one == three.one);
        CHECK(one.zx == three.zx);
        const MassProperties body = mass_properties(with_factors(one), p, 1);
        CHECK(std::abs(body.mass / exact.mass - 1) <= 16 * eps);
        CHECK(inertia_error(body.inertia, exact.inertia) <= 16 * eps);
      }
    }
  }
}

TEST_CASE("tetrahedra: meshes of any number of triangles, whole packs or not") {
  // A fan of n triangles round an axis, closed by their shadows: 1/2 Σ sin(2π/n) of area, 1 high.
  for (int n = 3; n <= 40; ++n) {
    std::vector<Eigen::Vector2d> rim;
    for (int i = 0; i < n; ++i)
      rim.push_back(Eigen::Rotation2Dd(2 * std::numbers::pi * i / n) * Eigen::Vector2d(1, 0));
    const PolygonMesh polygons = test::prism(rim, 1);
    CAPTURE(n);
    for (const PolygonMesh& mesh : {polygons, test::triangulated(polygons)}) {
      const double V = n * std::sin(2 * std::numbers::pi / n) / 2;
      CHECK(std::abs(test::fast(mesh, 1).mass - V) <= 16 * eps * V);
      CHECK(std::abs(test::tight(mesh, 1).mass - V) <= 8 * eps * V);
    }
  }
}
