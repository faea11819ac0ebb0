#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "project/harness/refusal.hpp"
#include "project/library/mesh/shapes.hpp"
#include "tumble/mesh/diagnose.hpp"

using namespace tumble;
using namespace tumble::detail;

namespace {

/// All sentences, one a line.
std::string text(const PolygonMesh& mesh) {
  std::string all;
  for (const MeshDefect& finding : diagnose(mesh)) all += finding.message + "\n";
  return all;
}

PolygonMesh triangles() { return test::triangulated(test::cube()); }

/// A band of quadrilaterals, closed after `parts`, turned over in between or not.
PolygonMesh band(int parts, bool turned_over) {
  PolygonMesh mesh;
  for (int i = 0; i < parts; ++i) {
    const double angle = 2 * std::numbers::pi * i / parts, lean = turned_over ? angle / 2 : 0.3;
    const Vec3 out(std::cos(angle), std::sin(angle), 0);
    const Vec3 side = 0.3 * (std::cos(lean) * out + std::sin(lean) * Vec3::UnitZ());
    mesh.vertices.push_back(out - side);
    mesh.vertices.push_back(out + side);
  }
  for (int i = 0; i + 1 < parts; ++i) mesh.add_face({2 * i, 2 * i + 1, 2 * i + 3, 2 * i + 2});
  const int last = 2 * parts - 2;
  if (turned_over)
    mesh.add_face({last, last + 1, 0, 1});
  else
    mesh.add_face({last, last + 1, 1, 0});
  return mesh;
}

/// A grid that closes in both directions, in one of them turned over: a Klein bottle.
PolygonMesh klein_bottle(int n) {
  PolygonMesh mesh;
  for (int i = 0; i < n * n; ++i)
    mesh.vertices.emplace_back(i / n, i % n, (i * i) % 7);  // where they are does not matter
  const auto vertex = [n](int i, int j) {
    const int row = i == n ? 0 : i, column = i == n ? (2 * n - j) % n : j % n;
    return row * n + column;
  };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      mesh.add_face({vertex(i, j), vertex(i, j + 1), vertex(i + 1, j + 1), vertex(i + 1, j)});
  return mesh;
}

std::string said_of_turned(const PolygonMesh& mesh) {
  std::string all;
  for (const MeshDefect& finding : diagnose(mesh))
    if (finding.kind == MeshDefectKind::inconsistent_orientation) all += finding.message + '\n';
  return all;
}

}  // namespace

TEST_CASE("diagnose: fields are indices from 0, sentences count from #1") {
  const std::vector<MeshDefect> findings = diagnose(test::without_face(test::cube(), 0));
  REQUIRE(findings.size() == 4);
  const MeshDefect& first = findings[0];
  CHECK(first.kind == MeshDefectKind::open_edge);
  CHECK(first.face == 1);  // what was face 2 of the cube, at y = 0
  CHECK(first.edge == std::array<int, 2>{0, 1});
  CHECK(
      first.message ==
      "the edge from vertex #1 at (0, 0, 0) to vertex #2 at (1, 0, 0) has face #2 on one side and "
      "nothing on the other (open edges in all: 4)");
}

TEST_CASE("diagnose: says that welding would close the surface, only when it would") {
  CHECK(text(test::soup(test::cube())).find("call weld()") != std::string::npos);
  CHECK(text(test::soup(test::without_face(test::cube(), 0))).find("weld") == std::string::npos);
}

TEST_CASE("diagnose: names a T-junction, the vertex and the edge, and only where there is one") {
  PolygonMesh mesh = test::cube();
  mesh.vertices.emplace_back(0.5, 0, 0);
  const PolygonMesh whole = mesh;
  mesh = test::without_face(whole, 0);
  mesh.add_face({0, 2, 3, 1, 8});  // face 1 of the cube, with a corner more
  const std::string both = text(mesh);
  const std::string vertex = "vertex #9 at (0.5, 0, 0) lies in the middle of ";
  const std::string cure = ", and face #2 has no corner there (a T-junction): give it one";
  CHECK_MESSAGE(
      both.find("(open edges in all: 3); " + vertex + "this edge" + cure) != std::string::npos,
      both);
  CHECK_MESSAGE(both.find("; " + vertex +
                          "the edge from vertex #1 at (0, 0, 0) to vertex #2 at "
                          "(1, 0, 0)" +
                          cure) != std::string::npos,
                both);
  CHECK(text(test::without_face(whole, 0)).find("T-junction") == std::string::npos);
  mesh.vertices.back().y() = 1e-8;  // as in single precision
  CHECK(text(mesh).find("T-junction") != std::string::npos);
  mesh.vertices.back().y() = 1e-3;
  CHECK(text(mesh).find("T-junction") == std::string::npos);
}

TEST_CASE("diagnose: an open mesh with vertices that are no numbers is not sorted by position") {
  PolygonMesh mesh = test::soup(test::without_face(test::sphere(3), 0));
  for (std::size_t i = 0; i < mesh.vertices.size(); i += 3)
    mesh.vertices[i].x() = std::numeric_limits<double>::quiet_NaN();
  CHECK(diagnose(mesh).front().kind == MeshDefectKind::not_finite);
}

TEST_CASE("diagnose: names both faces of an edge that they use in the same direction") {
  CHECK(text(test::with_face_flipped(triangles(), 0))
            .find("faces #1 and #2 go along the edge from vertex #1 at (0, 0, 0) to vertex #4 at "
                  "(1, 1, 0) in the same direction") != std::string::npos);
}

TEST_CASE("diagnose: names the original of a doubled face") {
  CHECK(text(test::with_face_twice(triangles(), 3))
            .find("face #13 has the same vertices as face #4") != std::string::npos);
}

TEST_CASE("diagnose: lists a few findings of a kind, and counts the others") {
  const std::vector<MeshDefect> findings = diagnose(test::soup(test::sphere(3)));
  CHECK(findings.size() == MeshDefectsOfOneKind::max_shown);
  CHECK(findings.back().message.find("(and 3835 more)") != std::string::npos);  // 3 · 1280 − 5
}

TEST_CASE("diagnose: names the part that is inside out or lies in another, and its volume") {
  const PolygonMesh small = test::moved(test::cube(), 0.5, Vec3::Constant(0.25));
  const std::string nested = text(test::together(test::cube(), small));
  CHECK(nested.find("the part with face #7 (6 of 12 faces) lies inside another part and looks "
                    "outwards, so that its 0.125 m³ count 2 times") != std::string::npos);
  const PolygonMesh beside = test::moved(test::inside_out(test::cube()), 1, Vec3(2, 0, 0));
  CHECK(text(test::together(test::cube(), beside))
            .find("the part with face #7 (6 of 12 faces) is inside out (volume -1 m³)") !=
        std::string::npos);
  CHECK(text(test::inside_out(test::cube())).find("the surface is inside out (volume -1 m³)") == 0);
}

TEST_CASE("diagnose: shows a line on which the surface crosses itself") {
  const std::vector<MeshDefect> findings =
      diagnose(test::together(test::cube(), test::moved(test::cube(), 1, Vec3(0.5, 0.5, 0.5))));
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].face >= 6);  // of the second cube
  const std::string& message = findings[0].message;
  for (const char* part : {"you enter the body at ", " = 0 (face #", " and again at ",
                           " = 0.5 (face #", ") without leaving it in between; what lies ",
                           " counts 2 times; 0.062 ± 0.00", " of the volume count wrongly"})
    CHECK_MESSAGE(message.find(part) != std::string::npos, message);
}

TEST_CASE("diagnose: where no turning of faces is a cure, a surface with one side is named") {
  const char* one_side = "the surface has one side only";
  const char* turned = "one of them is turned the wrong way round";
  for (const PolygonMesh& mesh : {band(12, true), klein_bottle(5)}) {
    CHECK(said_of_turned(mesh).find(one_side) != std::string::npos);
    CHECK(said_of_turned(mesh).find(turned) == std::string::npos);
  }
  const PolygonMesh cube = test::with_face_flipped(test::cube(), 0);
  CHECK(said_of_turned(cube).find(turned) != std::string::npos);
  CHECK(said_of_turned(cube).find(one_side) == std::string::npos);
  CHECK(said_of_turned(test::with_face_flipped(band(12, false), 3)).find(one_side) ==
        std::string::npos);
  const PolygonMesh both = test::together(cube, band(12, true));  // each part has its own words
  CHECK(said_of_turned(both).find(turned) != std::string::npos);
}

TEST_CASE(
    "require_body: lets a body pass, even with a degenerate face, and throws all findings else") {
  CHECK_NOTHROW(require_body(test::cube()));
  PolygonMesh degenerate = triangles();
  degenerate.add_face({0, 1, 1});
  CHECK_NOTHROW(require_body(degenerate));
  PolygonMesh broken = test::without_face(degenerate, 0);
  try {
    require_body(broken);
    FAIL("not refused");
  } catch (const std::invalid_argument& error) {
    const std::string message = error.what();
    CHECK(message.find("the mesh does not bound a body:\n  open_edge: the edge") == 0);
    CHECK(message.find(
              "\n  degenerate_face: face #12 has the same vertex at two corners: vertex #2") !=
          std::string::npos);
  }
}

TEST_CASE("require_faultless: refuses a degenerate face too, and names it") {
  CHECK_NOTHROW(require_faultless(test::cube()));
  PolygonMesh degenerate = triangles();
  degenerate.add_face({0, 1, 1});
  CHECK_REFUSED(require_faultless(degenerate), "the mesh has faults", "degenerate_face: face #13");
  CHECK_REFUSED(require_faultless(test::without_face(triangles(), 0)), "open_edge");
}
