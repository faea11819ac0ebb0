// Surfaces that are there twice, alone, beside a body and in one.
#include "tumble/mesh/doubled_surface.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "project/harness/inputs.hpp"
#include "project/library/mesh/shapes.hpp"
#include "tumble/mass/mesh_mass_properties.hpp"
#include "tumble/mesh/closed_pieces.hpp"
#include "tumble/mesh/weld.hpp"

using namespace tumble;

namespace {

/// Both sides of the faces, each with vertices of its own.
PolygonMesh both_sides(const PolygonMesh& mesh, bool other_diagonals) {
  PolygonMesh back;
  back.vertices = mesh.vertices;
  for (int f = 0; f < mesh.face_count(); ++f) {
    std::vector<int> face(mesh.face(f).rbegin(), mesh.face(f).rend());
    if (!other_diagonals) std::rotate(face.begin(), face.end() - 1, face.end());
    back.add_face(face);
  }
  return test::together(mesh, back);
}

/// Bodies of quads and of concave polygons, that lie anyhow near (3, 0, 0).
std::vector<PolygonMesh> bodies(test::Random& random) {
  std::vector<PolygonMesh> list = {
      test::box(Vec3::Zero(), {1, 2, 0.5}),
      test::torus_mesh(12, 8, 1, 0.4),
      test::prism({{0, 0}, {2, 0}, {2.2, 1}, {1, 0.4}, {0, 1}}, 0.7),
  };
  for (PolygonMesh& mesh : list)
    mesh = test::mapped(mesh, random.rotation().toRotationMatrix(), Vec3(3, 0, 0));
  return list;
}

bool is_flat(const PolygonMesh& mesh) {
  for (const MeshDefect& finding : diagnose(mesh))
    if (finding.kind == MeshDefectKind::flat && spoils_integrals(finding)) return true;
  return false;
}

/// Calls `visit(both sides)` for many surfaces that are there twice.
template <class Visit>
void for_each_doubled(const Visit& visit) {
  test::Random random(1);
  for (int i = 0; i < 4; ++i)
    for (const PolygonMesh& body : bodies(random))
      for (const int places : {17, 9, 6, 4})
        for (const bool other_diagonals : {false, true}) {
          CAPTURE(i);
          CAPTURE(places);
          CAPTURE(other_diagonals);
          visit(both_sides(test::with_decimals(body, places), other_diagonals), places);
        }
}

}  // namespace

TEST_CASE("doubled surfaces: are found beside a body too, with vertices of their own or not") {
  for_each_doubled([](const PolygonMesh& twice, int places) {
    const PolygonMesh ball =
        test::with_decimals(test::moved(test::sphere(1), 1, {9, 1, 2}), places);
    for (const PolygonMesh& both : {twice, weld(twice)}) {
      CHECK(is_flat(both));
      CHECK(is_flat(test::together(both, ball)));
      CHECK(is_flat(test::together(ball, both)));
    }
  });
}

TEST_CASE("doubled surfaces: in a body they are a cavity that is filled, and nothing is wrong") {
  for_each_doubled([](const PolygonMesh& twice, int places) {
    const PolygonMesh ball =
        test::with_decimals(test::moved(test::sphere(2), 9, {0, 0, 0}), places);
    const double mass = mesh_mass_properties(ball, 1).mass;
    // Half a decimal, √3 times, on a surface of up to 20 m², of a ball of 3000 m³.
    const double left = 0.01 * std::pow(10, -places) + 64 * test::eps;
    const PolygonMesh filled = test::together(ball, twice);
    for (const PolygonMesh& mesh : {filled, weld(filled)}) {
      double found = 0;
      CHECK_NOTHROW(found = mesh_mass_properties(mesh, 1).mass);
      CHECK(std::abs(found - mass) <= left * mass);
    }
  });
}

TEST_CASE("doubled surfaces: a cavity as large as a body elsewhere is none") {
  const PolygonMesh cube = test::cube();
  const PolygonMesh hollow =
      test::together(test::box(Vec3::Constant(-1), Vec3::Constant(2)), test::inside_out(cube));
  CHECK(diagnose(test::together(hollow, test::moved(cube, 1, {5, 0, 0}))).empty());
  // One that touches the body from within is not filled by it.
  const PolygonMesh corner =
      test::together(test::box(Vec3::Zero(), Vec3::Constant(2)), test::inside_out(cube));
  CHECK(diagnose(test::together(corner, test::moved(cube, 1, {2, 0, 0}))).empty());
  CHECK(diagnose(weld(test::together(corner, test::moved(cube, 1, {2, 0, 0})))).empty());
}

TEST_CASE("doubled surfaces: are found where they touch a body, in a vertex or an edge") {
  const PolygonMesh cube = test::cube();
  const PolygonMesh twice = both_sides(cube, true);
  test::Random random(5);
  for (const Vec3& low : {Vec3(1, 1, 1), Vec3(1, 1, 0)})
    for (const double size : {1., 0.5, 2.})
      for (const int places : {17, 6}) {
        PolygonMesh body = test::moved(cube, size, low);
        if (low.z() == 0 && size != 1) continue;  // no edge in common
        const Mat3 R = random.rotation().toRotationMatrix();
        PolygonMesh mesh = test::together(twice, body);
        mesh = test::with_decimals(test::mapped(mesh, R, Vec3(3, 0, 0)), places);
        CAPTURE(low.transpose());
        CAPTURE(size);
        CAPTURE(places);
        CHECK(is_flat(mesh));
        CHECK(is_flat(weld(mesh)));
      }
}

TEST_CASE("doubled surfaces: one that touches a large body is found as well") {
  PolygonMesh ball = test::sphere(5);
  REQUIRE(ball.face_count() > detail::always_pairs);
  const Vec3 touch = ball.vertex(7);
  for (const double size : {0.5, 0.02, 0.005, 1e-4}) {  // down to less than a face of the ball
    CAPTURE(size);
    PolygonMesh box = test::box(touch, touch + size * touch.cwiseSign());
    if (test::volume(box) < 0) box = test::inside_out(box);
    for (const bool other_diagonals : {false, true}) {
      const PolygonMesh twice = both_sides(box, other_diagonals);
      CHECK(is_flat(weld(test::together(ball, twice))));
      CHECK(is_flat(weld(test::together(twice, ball))));
    }
    CHECK_FALSE(is_flat(weld(test::together(ball, box))));
  }
}

TEST_CASE("doubled surfaces: are found if their copies have one vertex in common") {
  test::Random random(6);
  PolygonMesh mesh = test::together(test::inside_out(test::cube()), test::cube());
  for (int& v : mesh.corners) v = v == 8 ? 0 : v;
  for (int i = 0; i < 5; ++i) {
    const Mat3 R = random.rotation().toRotationMatrix();
    for (const int places : {17, 6})
      CHECK(is_flat(test::with_decimals(test::mapped(mesh, R, Vec3(3, 0, 0)), places)));
  }
}

TEST_CASE("closed pieces: bodies that touch are apart, and what hangs together stays so") {
  const PolygonMesh cube = test::cube();
  const auto parts = [](const PolygonMesh& mesh) {
    const PolygonMesh apart = detail::apart_at_pinches(mesh);
    CHECK(apart.first_corner == mesh.first_corner);
    return detail::label_components(apart).parts.size();
  };
  CHECK(parts(cube) == 1);
  CHECK(parts(weld(test::together(cube, test::moved(cube, 1, {1, 1, 1})))) == 2);
  CHECK(parts(weld(test::together(cube, test::moved(cube, 1, {1, 1, 0})))) == 2);
  CHECK(parts(weld(test::together(cube, test::moved(cube, 1, {1, 0, 0})))) == 1);  // a face
  CHECK(parts(weld(both_sides(cube, false))) == 1);
  CHECK(parts(weld(test::together(both_sides(cube, false), test::moved(cube, 1, {1, 1, 0})))) == 2);
}

TEST_CASE("closed pieces: a surface is pinched where it touches itself, and nowhere else") {
  const PolygonMesh cube = test::cube();
  CHECK_FALSE(detail::is_pinched(cube));
  CHECK_FALSE(detail::is_pinched(test::sphere(3)));
  CHECK_FALSE(detail::is_pinched(test::torus_mesh(12, 8, 1, 0.4)));
  CHECK_FALSE(detail::is_pinched(test::together(cube, test::moved(cube, 1, {1, 1, 1}))));
  CHECK(detail::is_pinched(weld(test::together(cube, test::moved(cube, 1, {1, 1, 1})))));
  CHECK(detail::is_pinched(weld(test::together(cube, test::moved(cube, 1, {1, 1, 0})))));
  CHECK(detail::is_pinched(weld(both_sides(cube, false))));
}

TEST_CASE("closed pieces: faces without area pinch nothing") {
  PolygonMesh mesh = test::cube();
  mesh.add_face({0, 0, 0});
  mesh.add_face({0, 1, 1});
  mesh.add_face({2, 3, 2});
  mesh.add_face({5, 5, 6});
  CHECK_FALSE(detail::is_pinched(mesh));
}

TEST_CASE("closed pieces: a vertex with many faces is one fan or two") {
  for (const int sides : {3, 8, 16, 17, 1000}) {
    PolygonMesh spindle;
    spindle.vertices = {{0, 0, 0}, {0, 0, 2}};
    for (int i = 0; i < sides; ++i) {
      const double angle = 2 * 3.14159265358979 * i / sides;
      spindle.vertices.emplace_back(std::cos(angle), std::sin(angle), 1);
    }
    for (int i = 0; i < sides; ++i) {
      const int a = 2 + i, b = 2 + (i + 1) % sides;
      spindle.add_face({0, b, a});
      spindle.add_face({1, a, b});
    }
    CAPTURE(sides);
    CHECK_FALSE(detail::is_pinched(spindle));
    CHECK(detail::is_pinched(weld(test::together(spindle, test::moved(spindle, 1, {0, 0, 2})))));
  }
}
