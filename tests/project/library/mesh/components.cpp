#include "tumble/mesh/components.hpp"

#include <doctest/doctest.h>

#include "project/harness/inputs.hpp"
#include "project/harness/relative_error.hpp"
#include "project/library/mesh/parts.hpp"
#include "project/library/mesh/shapes.hpp"

using namespace tumble;
using namespace tumble::detail;
using test::parts_of;

TEST_CASE("components: a cube is one part of volume 1") {
  const Components surface = parts_of(test::cube());
  REQUIRE(surface.parts.size() == 1);
  CHECK(surface.parts[0].volume == 1);
  CHECK(surface.parts[0].rounding < 1e-13);
}

TEST_CASE("components: parts are told apart, unused vertices belong to none") {
  PolygonMesh mesh = test::together(test::cube(), test::moved(test::sphere(2), 2, Vec3(10, 0, 0)));
  mesh.vertices.emplace_back(0, 0, 0);
  mesh = test::together(mesh, test::inside_out(test::moved(test::cube(), 3, Vec3(0, 20, 0))));
  const Components surface = parts_of(mesh);
  REQUIRE(surface.parts.size() == 3);
  CHECK(surface.parts[0].volume == 1);
  CHECK(test::relative_error(surface.parts[1].volume, 8 * test::volume(test::sphere(2))) <= 1e-13);
  CHECK(surface.parts[2].volume == -27);
  CHECK(surface.of(0) == 0);
  CHECK(surface.of(8) == 1);
  CHECK(surface.of(static_cast<int>(mesh.vertices.size()) - 9) == -1);
  CHECK(first_faces(mesh, surface) == std::vector<int>{0, 6, 6 + 320});
}

TEST_CASE("components: the volume is within the stated rounding, far away and tiny too") {
  const PolygonMesh sphere = test::sphere(3);
  for (const double scale : {1e-6, 1.0, 1e3})
    for (const double far : {0.0, 1.0, 1e4, 1e8}) {
      const PolygonMesh mesh = test::moved(sphere, scale, Vec3(far * scale, far * scale, 0));
      const Components surface = parts_of(mesh);
      CAPTURE(scale);
      CAPTURE(far);
      // The vertices were rounded when they were moved: the volume is that of the mesh as it is.
      CHECK(std::abs(surface.parts[0].volume - test::volume(mesh)) <= surface.parts[0].rounding);
      CHECK(surface.parts[0].rounding < 1e-11 * surface.parts[0].volume);
    }
}

TEST_CASE("components: a body without thickness encloses less than the rounding") {
  for (const double far : {0.0, 1.0, 1e8}) {
    PolygonMesh sheet = test::sphere(3);
    for (Vec3& p : sheet.vertices) p = Vec3(p.x() + far, p.y(), 0.3 * p.x() + 0.1 * p.y());
    const Component part = parts_of(sheet).parts[0];
    CAPTURE(far);
    // In the plane up to the rounding of the vertices, ½ ulp(far) in an area of 2 π.
    CHECK(std::abs(part.volume) <= part.rounding + 2 * test::eps * far * 2 * std::numbers::pi);
  }
}
