#include "tumble/mesh/edge_balance.hpp"

#include <doctest/doctest.h>

#include "project/library/mesh/shapes.hpp"

using namespace tumble;
using namespace tumble::detail;

TEST_CASE("edge_balance: is 0 for closed surfaces, of triangles or polygons") {
  CHECK(is_closed(test::cube()));
  CHECK(is_closed(test::triangulated(test::cube())));
  CHECK(is_closed(test::sphere(3)));
  CHECK(is_closed(test::torus(20, 12)));
  CHECK(is_closed(test::inside_out(test::cube())));
}

TEST_CASE("edge_balance: is not 0 for a missing, a turned or a doubled face, whichever it is") {
  const PolygonMesh sphere = test::sphere(2);
  for (int f = 0; f < sphere.face_count(); ++f) {
    CAPTURE(f);
    CHECK_FALSE(is_closed(test::without_face(sphere, f)));
    CHECK_FALSE(is_closed(test::with_face_flipped(sphere, f)));
    CHECK_FALSE(is_closed(test::with_face_twice(sphere, f)));
  }
}

TEST_CASE("edge_balance: parts that share a vertex, an edge or a face are closed") {
  const PolygonMesh cube = test::cube();
  for (const Vec3& step : {Vec3(1, 1, 1), Vec3(1, 1, 0), Vec3(1, 0, 0)}) {
    CAPTURE(step.transpose());
    // The second cube uses the vertices of the first where they coincide.
    PolygonMesh both = test::together(cube, test::moved(cube, 1, step));
    for (int& v : both.corners)
      for (int w = 0; w < v; ++w)
        if (both.vertex(w) == both.vertex(v)) v = w;
    CHECK(is_closed(both));
  }
}

TEST_CASE("edge_balance: a repeated corner makes no edge") {
  PolygonMesh mesh = test::triangulated(test::cube());
  mesh.add_face({0, 0, 1});
  CHECK(is_closed(mesh));
  mesh.add_face({2, 2, 2});
  CHECK(is_closed(mesh));
}

TEST_CASE("edge_balance: two turned faces do not hide each other") {
  const PolygonMesh sphere = test::sphere(1);
  for (int f = 1; f < sphere.face_count(); ++f) {
    CAPTURE(f);
    CHECK_FALSE(is_closed(test::with_face_flipped(test::with_face_flipped(sphere, 0), f)));
  }
}
