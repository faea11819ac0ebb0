#include "tumble/mesh/check_faces.hpp"

#include <doctest/doctest.h>

#include "project/harness/inputs.hpp"
#include "project/library/mesh/shapes.hpp"

using namespace tumble;
using namespace tumble::detail;
using test::Random;

TEST_CASE("has_no_area: exactly, where the cross product in doubles is not 0") {
  // In units of 2⁻⁵³: a = −(odd), b = 2 modulo 4. Then c = a + 3 (b − a) is a double, but b −
  // a is none.
  Random rng(31);
  int not_zero_in_doubles = 0;
  for (int i = 0; i < 1000; ++i) {
    Vec3 a, b, c;
    for (int k = 0; k < 3; ++k) {
      a[k] = -(4 * std::floor(rng.uniform(0x1p50, 0x1.8p50)) + 1) * 0x1p-53;
      b[k] = (4 * std::floor(rng.uniform(0x1p50, 0x1.8p50)) + 2) * 0x1p-53;
      c[k] = std::fma(3, b[k], -2 * a[k]);
    }
    const Vec3 u = b - a, v = c - a;
    not_zero_in_doubles += u.cross(v) != Vec3::Zero();
    CAPTURE(a.transpose());
    CAPTURE(b.transpose());
    CHECK(has_no_area(a, b, c));
    CHECK_FALSE(has_no_area(a, b, Vec3(c.x(), c.y(), std::nextafter(c.z(), 9))));
  }
  CHECK(not_zero_in_doubles > 100);
}

TEST_CASE("degeneracy: says what is wrong with a face, and nothing of one that is right") {
  PolygonMesh mesh = test::cube();
  const auto what = [&](const std::vector<int>& face) -> std::string {
    const char* text = degeneracy(mesh, face);
    return text == nullptr ? "" : text;
  };
  CHECK(what({0, 2, 3, 1}) == "");
  CHECK(what({0, 2, 3}) == "");
  CHECK(what({0, 1}) == "has fewer than 3 corners");
  CHECK(what({}) == "has fewer than 3 corners");
  CHECK(what({0, 1, 0}) == "has the same vertex at two corners");
  CHECK(what({0, 1, 3, 1}) == "has the same vertex at two corners");
  mesh.vertices = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(3, 0, 0), Vec3(0, 1, 0)};
  CHECK(what({0, 1, 2, 3}) == "has an area of exactly 0");
  CHECK(what({0, 1, 2, 4}) == "");  // three corners in a line are no harm
}

TEST_CASE("find_degenerate_faces: names the vertex that stands there twice, and no other") {
  PolygonMesh mesh = test::cube();
  const auto message = [&](const std::vector<int>& face) {
    PolygonMesh with = mesh;
    with.add_face(face);
    return find_degenerate_faces(with).front().message;
  };
  const auto count = [](const std::string& text) {
    std::size_t found = 0;
    for (auto at = text.find("vertex #"); at != text.npos; at = text.find("vertex #", at + 1))
      ++found;
    return found;
  };
  for (const std::vector<int>& face :
       {std::vector{0, 1, 3, 3, 2}, {3, 1, 3}, {3, 3, 1}, {1, 3, 3}, {0, 3, 1, 3}}) {
    const std::string text = message(face);
    CHECK_MESSAGE(text.find("at two corners: vertex #4 at") != std::string::npos, text);
    CHECK(count(text) == 1);
  }
  CHECK(count(message({0, 1})) == 2);  // what it has
}

TEST_CASE("find_nonplanar_faces: says how far a corner is from the plane, and forgives rounding") {
  PolygonMesh mesh = test::cube();
  CHECK(find_nonplanar_faces(mesh).empty());
  mesh.vertices.back() += Vec3(0.1, 0, 0);  // in the planes of two of its three faces
  const std::vector<MeshDefect> findings = find_nonplanar_faces(mesh);
  REQUIRE(findings.size() == 1);
  const Planarity one = planarity(mesh, mesh.face(findings[0].face));
  // Three corners of a square and one 0.1 off: the best plane is 0.1/4 from each, nearly.
  CHECK(std::abs(one.distance - 0.025) <= 0.025 * 0.01);
  CHECK(findings[0].message.find("its 4 corners are up to 0.0249 m") != std::string::npos);
  CHECK(find_nonplanar_faces(test::triangulated(mesh)).empty());
  // Seven digits, as files have them, are no fault; nor is a strip, however thin.
  const Mat3 R = Eigen::AngleAxisd(1.1, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  for (const double thin : {1.0, 1e-4, 1e-9}) {
    PolygonMesh strip = test::box(Vec3::Zero(), Vec3(1, thin, 1));
    for (Vec3& p : strip.vertices) p = R * p + Vec3(10, 20, 30);
    CHECK(find_nonplanar_faces(strip).empty());
  }
}
