// The triangles over a rectangle: none that is there is left out.
#include "tumble/mesh/triangle_columns.hpp"

#include <doctest/doctest.h>

#include "project/harness/inputs.hpp"
#include "project/library/mesh/shapes.hpp"
#include "tumble/mesh/polygon_mesh.hpp"

using namespace tumble;
using namespace tumble::detail;

namespace {

/// Those whose own rectangle meets `where`, one by one.
std::vector<int> faces_over(const PolygonMesh& mesh, const View& view, const Rectangle& where) {
  std::vector<int> faces;
  for_each_triangle(mesh, [&](int f, const std::array<int, 3>& t) {
    const auto corner = [&](std::size_t k) { return view.point(mesh.vertex(t[k])); };
    if (rectangle_of(corner(0), corner(1), corner(2)).meets(where)) faces.push_back(f);
  });
  return faces;
}

}  // namespace

TEST_CASE("TriangleColumns: gives the triangles over a rectangle, each once, in order") {
  test::Random random(1);
  for (const PolygonMesh& body :
       {test::sphere(3), test::torus(40, 9), test::cube(),
        test::together(test::sphere(3), test::box({-9, -9, 5}, {9, 9, 6}))}) {
    const PolygonMesh mesh = test::mapped(body, random.rotation().toRotationMatrix(), {1, 2, 3});
    const std::vector<FaceTriangle> triangles = face_triangles(mesh);
    for (int axis = 0; axis < 3; ++axis) {
      const View view{axis};
      const TriangleColumns columns(mesh, triangles, view, bounds(mesh));
      for (int i = 0; i < 50; ++i) {
        const Vec3 p = view.point(Vec3(1, 2, 3) + random.vector());
        const double size = i % 5 == 0 ? 0 : std::abs(random.vector().x());
        const Rectangle where{p.x(), p.x() + size, p.y(), p.y() + 2 * size};
        std::vector<int> found;
        for (const FaceTriangle& triangle : columns.over(where)) found.push_back(triangle.face);
        CHECK(found == faces_over(mesh, view, where));
      }
    }
  }
}

TEST_CASE("TriangleColumns: a mesh of no width has one column") {
  PolygonMesh flat;
  flat.vertices = {Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(1, 0, 1)};
  flat.add_face({0, 1, 2});
  const std::vector<FaceTriangle> triangles = face_triangles(flat);
  const TriangleColumns columns(flat, triangles, View{2}, bounds(flat));
  CHECK(columns.over({0, 2, 0, 1}).size() == 1);
  CHECK(columns.over({2, 3, 0, 1}).empty());
}
