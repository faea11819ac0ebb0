#include "tumble/mesh/weld.hpp"

#include <doctest/doctest.h>

#include "project/library/mesh/shapes.hpp"
#include "tumble/mesh/edge_balance.hpp"
#include "tumble/mesh/weld_if_open.hpp"

using namespace tumble;
using namespace tumble::detail;

TEST_CASE("weld: closes a surface whose faces have their own corners") {
  for (const PolygonMesh& mesh : {test::cube(), test::sphere(2)}) {
    const PolygonMesh soup = test::soup(mesh);
    CHECK_FALSE(is_closed(soup));
    const PolygonMesh welded = weld(soup);
    CHECK(is_closed(welded));
    CHECK(welded.vertices.size() == mesh.vertices.size());
    CHECK(welded.first_corner == mesh.first_corner);
    for (std::size_t i = 0; i < mesh.corners.size(); ++i)
      CHECK(welded.vertex(welded.corners[i]) == mesh.vertex(mesh.corners[i]));
  }
}

TEST_CASE("weld: leaves a mesh alone that has nothing to merge") {
  const PolygonMesh mesh = test::sphere(1), welded = weld(mesh);
  CHECK(welded.corners == mesh.corners);
  CHECK(welded.vertices == mesh.vertices);
}

TEST_CASE("weld: the first of equal vertices stays, and an ulp keeps two apart") {
  PolygonMesh mesh;
  mesh.vertices = {Vec3(1, 0, 0), Vec3(0, 0, 0), Vec3(-0.0, 0, 0), Vec3(1, 0, 0),
                   Vec3(1 + 0x1p-52, 0, 0)};
  mesh.add_face({4, 3, 2});
  const PolygonMesh welded = weld(mesh);
  CHECK(welded.vertices ==
        std::vector<Vec3>{Vec3(1, 0, 0), Vec3(0, 0, 0), Vec3(1 + 0x1p-52, 0, 0)});
  CHECK(welded.corners == std::vector<int>{2, 0, 1});
}

TEST_CASE("weld_if_open: faces share the first of equal vertices, which keep their numbers") {
  PolygonMesh mesh = test::soup(test::cube());
  const std::vector<Vec3> vertices = mesh.vertices;
  CHECK(weld_if_open(mesh) == 16);  // of 24
  CHECK(is_closed(mesh));
  CHECK(mesh.vertices == vertices);
  CHECK(weld_if_open(mesh) == 0);
}

TEST_CASE("weld_if_open: an open surface loses its seams, and what is closed stays as it is") {
  PolygonMesh open = test::soup(test::without_face(test::cube(), 0));
  CHECK(weld_if_open(open) == 12);  // of 20
  CHECK_FALSE(is_closed(open));
  PolygonMesh touching = test::together(test::cube(), test::moved(test::cube(), 1, Vec3(1, 0, 0)));
  const std::vector<int> corners = touching.corners;
  CHECK(weld_if_open(touching) == 0);
  CHECK(touching.corners == corners);
  touching.add_face({0, 1, 1});  // of no area, and no neighbour needs it
  touching.add_face({0, 1, 0});
  CHECK(weld_if_open(touching) == 0);
}
