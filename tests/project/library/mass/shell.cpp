#include "tumble/mass/shell.hpp"

#include <doctest/doctest.h>

#include <numbers>

#include "project/harness/refusal.hpp"
#include "project/library/mass/meshes.hpp"
#include "tumble/mass/transform.hpp"

using namespace tumble;
using test::askew;
using test::eps;

TEST_CASE("shells: a rectangle is a lamina, wherever it lies") {
  PolygonMesh sheet;
  sheet.vertices = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}};
  sheet.add_face({0, 1, 2, 3});
  const Vec3 place(3, -4, 5);
  const MassProperties body = shells::mass_properties(test::mapped(sheet, askew(), place), 3);
  CHECK(std::abs(body.mass - 6) <= 16 * eps);
  CHECK((body.centre - (askew() * Vec3(1, 0.5, 0) + place)).norm() <= 16 * eps);
  const Mat3 flat = Vec3(6 / 12.0, 6 * 4 / 12.0, 6 * 5 / 12.0).asDiagonal();
  CHECK((body.inertia - rotate_inertia(askew(), flat)).norm() <= 64 * eps);
}

TEST_CASE("shells: the skin of a cube: 5/18 m a² about each axis") {
  const MassProperties body = shells::mass_properties(test::box_mesh(Vec3(2, 2, 2)), 0.5);
  CHECK(std::abs(body.mass - 12) <= 16 * eps);
  CHECK(body.centre.norm() <= eps);
  CHECK((body.inertia - 12 * 4 * 5 / 18.0 * Mat3::Identity()).norm() <= 64 * eps);
}

TEST_CASE("shells: a sphere's mesh approaches 2/3 m r² with the square of its edges") {
  double error[2];
  for (const int level : {3, 4}) {
    const MassProperties body = shells::mass_properties(test::sphere(level), 1);
    const double m = 4 * std::numbers::pi;
    error[level - 3] = 2 / 3.0 * m - body.inertia(0, 0);
  }
  CHECK(std::abs(error[0] / error[1] - 4) <= 0.1);
}

TEST_CASE("shells: refuses what has no area, and densities that mean nothing") {
  PolygonMesh line;
  line.vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  line.add_face({0, 1, 2});
  CHECK_REFUSED(shells::mass_properties(line, 1), "no area");
  CHECK_REFUSED(shells::mass_properties(test::cube(), 0), "the surface density 0");
  PolygonMesh bad = test::cube();
  bad.corners[0] = 99;
  CHECK_REFUSED(shells::mass_properties(bad, 1), "#100");
  bad = test::cube();
  bad.vertices[0].x() = std::nan("");
  CHECK_REFUSED(shells::mass_properties(bad, 1), "nan");
}

TEST_CASE("combine: any number of bodies are what two at a time are") {
  std::vector<MassProperties> cubes;
  for (const double x : {0.0, 1.0, 2.0, 3.0})
    cubes.push_back(test::tight(test::moved(test::cube(), 1, Vec3(x, 0, 0)), 2));
  const MassProperties bar = combine(cubes);
  const MassProperties truth = test::tight(test::box(Vec3::Zero(), Vec3(4, 1, 1)), 2);
  CHECK(bar.mass == truth.mass);
  CHECK((bar.centre - truth.centre).norm() <= 8 * eps);
  CHECK((bar.inertia - truth.inertia).norm() <= 32 * eps * truth.inertia.norm());
  CHECK_REFUSED(combine(std::span<const MassProperties>()), "no bodies");
}
