#include "tumble/mesh/weld.hpp"

#include <doctest/doctest.h>

#include "project/library/mesh/shapes.hpp"
#include "tumble/mesh/edge_balance.hpp"

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
