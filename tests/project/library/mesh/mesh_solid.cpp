#include "tumble/mesh/mesh_solid.hpp"

#include <doctest/doctest.h>

#include "project/harness/inputs.hpp"
#include "project/harness/relative_error.hpp"
#include "project/library/mesh/shapes.hpp"

using namespace tumble;
using test::Random;

namespace {

/// The solid angle of the surface seen from p, in whole turns. Source: Van Oosterom & Strackee,
/// "The solid angle of a plane triangle", IEEE Trans. Biomed. Eng. 30 (1983), eq. 8.
double slow_but_correct_winding(const PolygonMesh& mesh, const Vec3& p) {
  double sum = 0;
  for_each_triangle(mesh, [&](int, const std::array<int, 3>& t) {
    const Vec3 a = mesh.vertex(t[0]) - p, b = mesh.vertex(t[1]) - p, c = mesh.vertex(t[2]) - p;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    sum +=
        std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  });
  return sum / (2 * std::numbers::pi);
}

/// Volume by counting the cell centres of an n³ grid that are inside.
double counted_volume(const PolygonMesh& mesh, int n) {
  const MeshSolid solid(mesh);
  const Vec3 low = solid.bounds().min(), size = solid.bounds().sizes();
  int inside = 0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k)
        inside += solid.contains(low + size.cwiseProduct(Vec3(i + 0.5, j + 0.5, k + 0.5) / n));
  return inside * (size.prod() / n / n / n);
}

}  // namespace

TEST_CASE("MeshSolid: agrees with the solid angle everywhere") {
  const PolygonMesh cavity = test::together(
      test::sphere(2), test::inside_out(test::moved(test::sphere(1), 0.5, Vec3::Zero())));
  for (const PolygonMesh& mesh : {test::cube(), test::sphere(2), test::torus(24, 12), cavity}) {
    for (const double scale : {1e-6, 1.0}) {
      const MeshSolid solid(test::moved(mesh, scale, Vec3::Zero()));
      Random rng(21);
      for (int i = 0; i < 1000; ++i) {
        const Vec3 p = 1.5 * rng.vector();
        const double winding = slow_but_correct_winding(mesh, p);
        if (std::abs(winding - std::round(winding)) > 1e-3) continue;  // on the surface
        CAPTURE(scale);
        CAPTURE(p.transpose());
        CHECK(solid.winding(scale * p) == static_cast<int>(std::round(winding)));
        CHECK(solid.contains(scale * p) == (std::round(winding) != 0));
      }
    }
  }
}

TEST_CASE("MeshSolid: lines through edges and vertices are counted once: no column is lost") {
  CHECK(counted_volume(test::cube(), 32) == 1);
  CHECK(counted_volume(test::triangulated(test::cube()), 32) == 1);
  CHECK(counted_volume(test::box({0, 0, 0}, {1, 2, 3}), 32) == 6);
  // An odd grid has lines through the middle, along both diagonals.
  CHECK(test::relative_error(counted_volume(test::cube(), 31), 1) <= 4 * test::eps);
}

TEST_CASE("MeshSolid: lines through the vertices of a sphere") {
  const PolygonMesh sphere = test::sphere(3);
  const MeshSolid solid(sphere);
  for (const Vec3& v : sphere.vertices)
    for (const double t : {-2.0, -0.9, 0.0, 0.9, 2.0}) {
      const Vec3 p(v.x(), v.y(), t * v.z());
      const double winding = slow_but_correct_winding(sphere, p);
      if (std::abs(winding - std::round(winding)) > 1e-3) continue;  // on the surface
      CAPTURE(p.transpose());
      CHECK(solid.winding(p) == static_cast<int>(std::round(winding)));
    }
}

TEST_CASE("MeshSolid: a body 1e8 away is as good as a body here") {
  const Vec3 far(1e8, -1e8, 1e8);
  CHECK(counted_volume(test::moved(test::cube(), 1, far), 32) == 1);
  const MeshSolid here(test::sphere(2)), there(test::moved(test::sphere(2), 1, far));
  Random rng(22);
  int differ = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p = (far + rng.vector()) - far;  // as rounded out there
    differ += here.contains(p) != there.contains(p + far);
  }
  CHECK(differ == 0);  // the vertices moved by 1e-8: a change has a chance of 2000 · 1e-8
}

TEST_CASE("MeshSolid: overlapping parts are their union, parts inside out count all the same") {
  const PolygonMesh two =
      test::together(test::cube(), test::moved(test::cube(), 1, Vec3(0.5, 0, 0)));
  CHECK(test::relative_error(counted_volume(two, 30), 1.5) <= 16 * test::eps);
  CHECK(MeshSolid(two).winding({0.75, 0.5, 0.5}) == 2);
  CHECK(counted_volume(test::inside_out(test::cube()), 32) == 1);
}

TEST_CASE("MeshSolid: refuses what has no inside") {
  PolygonMesh wrong = test::cube();
  wrong.corners[5] = 8;
  CHECK_THROWS_WITH_AS(MeshSolid{wrong}, doctest::Contains("face #2 has vertex #9"),
                       std::invalid_argument);
  wrong = test::cube();
  wrong.vertices[3].y() = std::nan("");
  CHECK_THROWS_WITH_AS(MeshSolid{wrong}, doctest::Contains("vertex #4"), std::invalid_argument);
  CHECK_THROWS_AS(MeshSolid{test::without_face(test::cube(), 0)}, std::invalid_argument);
  CHECK_THROWS_AS(MeshSolid{PolygonMesh{}}, std::invalid_argument);
}
