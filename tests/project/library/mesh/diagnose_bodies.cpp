#include <doctest/doctest.h>

#include <set>
#include <string>

#include "project/library/mesh/shapes.hpp"
#include "tumble/mesh/diagnose.hpp"
#include "tumble/mesh/weld.hpp"

using namespace tumble;

namespace {

/// The names of the kinds that are found, each once, in the order of the enumeration.
std::string found_in(const PolygonMesh& mesh) {
  std::set<MeshDefectKind> found;
  for (const MeshDefect& finding : diagnose(mesh)) found.insert(finding.kind);
  std::string text;
  for (const MeshDefectKind kind : found)
    text += std::string(text.empty() ? "" : " ") + name_of(kind);
  return text;
}

/// A triangle on an edge, of zero area: the edge's middle is a new vertex of one of its
/// two faces only.
PolygonMesh with_flat_face(PolygonMesh mesh) {
  const std::vector<int> face(mesh.face(0).begin(), mesh.face(0).end());
  const int middle = static_cast<int>(mesh.vertices.size());
  mesh.vertices.push_back((mesh.vertex(face[0]) + mesh.vertex(face[1])) / 2);
  PolygonMesh result = test::without_face(mesh, 0);
  result.add_face({face[0], face[1], middle});
  result.add_face({face[0], middle, face[2]});
  result.add_face({middle, face[1], face[2]});
  return result;
}

/// A cube around the origin, of 12 triangles.
PolygonMesh cube_of_triangles() {
  return test::triangulated(test::box(Vec3::Constant(-0.5), Vec3::Constant(0.5)));
}

/// A torus bent to an eight, which crosses itself: its middle line is (sin 2u, sin u).
PolygonMesh eight() {
  PolygonMesh mesh = test::torus(96, 12);
  for (Vec3& p : mesh.vertices) {
    const double u = std::atan2(p.y(), p.x()), r = std::hypot(p.x(), p.y()) - 1;
    const Vec3 ahead = Vec3(2 * std::cos(2 * u), std::cos(u), 0).normalized();
    p = Vec3(std::sin(2 * u), std::sin(u), p.z() / 2) + r / 2 * Vec3(ahead.y(), -ahead.x(), 0);
  }
  return mesh;
}

}  // namespace

TEST_CASE("diagnose: a triangle without area is found exactly") {
  for (const PolygonMesh& body : {cube_of_triangles(), test::sphere(1)}) {
    // Middles of edges are exact only where the sum of the ends is: keep 20 bits
    // of each coordinate.
    PolygonMesh mesh = body;
    for (Vec3& p : mesh.vertices)
      for (double& x : p) x = std::round(x * 0x1p20) * 0x1p-20;
    CHECK(found_in(with_flat_face(mesh)) == "degenerate_face");
    PolygonMesh bent = with_flat_face(mesh);
    bent.vertices.back() *= 1 + 0x1p-40;  // a hair of area
    CHECK(found_in(bent) == "");
  }
}

TEST_CASE("diagnose: bodies that touch at a vertex, an edge or a face are fine") {
  const PolygonMesh cube = test::cube();
  for (const Vec3& step :
       {Vec3(1, 1, 1), Vec3(1, 1, 0), Vec3(1, 0, 0), Vec3(0, 0, 1), Vec3(0.5, 0.3, 1)})
    for (const double far : {0.0, 0.1, 1e8}) {
      CAPTURE(step.transpose());
      CAPTURE(far);
      const PolygonMesh both = test::together(cube, test::moved(cube, 1, step));
      const PolygonMesh there = test::moved(both, 1, Vec3(far, far, far));
      CHECK(found_in(there) == "");
      CHECK(found_in(weld(there)) == "");
    }
}

TEST_CASE("diagnose: a turned body that touches along slanted faces is fine") {
  const Quat q = Quat(0.8, 0.3, -0.4, 0.2).normalized();
  for (const double far : {0.0, 1e4, 1e8}) {
    PolygonMesh a = test::cube(),
                b = test::moved(test::triangulated(test::cube()), 1, Vec3(1, 0, 0));
    for (PolygonMesh* mesh : {&a, &b})
      for (Vec3& p : mesh->vertices) p = q * p + Vec3::Constant(far);
    CAPTURE(far);
    CHECK(found_in(test::together(a, b)) == "");
  }
}

TEST_CASE("diagnose: flat bodies enclose nothing") {
  PolygonMesh sheet;
  sheet.vertices = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  sheet.add_face({0, 1, 2});
  sheet.add_face({2, 1, 0});
  CHECK(found_in(sheet) == "flat");
  CHECK(found_in(test::moved(sheet, 1e-6, Vec3::Ones())) == "flat");
}

TEST_CASE("diagnose: a thin plate is a body") {
  for (const double thickness : {1e-3, 1e-8, 1e-12}) {
    CAPTURE(thickness);
    CHECK(found_in(test::box(Vec3::Zero(), {1, 1, thickness})) == "");
    CHECK(found_in(test::box(Vec3::Zero(), {thickness, 1, 1})) == "");
    CHECK(found_in(test::inside_out(test::box(Vec3::Zero(), {thickness, 1, 1}))) == "inverted");
  }
}

TEST_CASE("diagnose: an empty mesh, and a broken table of faces") {
  CHECK(found_in(PolygonMesh{}) == "no_faces");
  for (const std::vector<int>& table :
       {std::vector<int>{}, {0, 4}, {0, 30, 24}, {1, 24}, {0, -4, 24}, {0, 99}}) {
    PolygonMesh mesh = test::cube();
    mesh.first_corner = table;
    CHECK(found_in(mesh) == "index_out_of_range");
  }
}

TEST_CASE("diagnose: a surface that crosses itself, alone or beside something else that is wrong") {
  CHECK(found_in(eight()) == "self_crossing");
  const PolygonMesh beside = test::moved(test::inside_out(test::cube()), 1, Vec3(0, 0, 3));
  CHECK(found_in(test::together(eight(), beside)) == "inverted self_crossing");
}

TEST_CASE(
    "diagnose: a part inside out is found where it touches another, and where no line meets it") {
  const PolygonMesh cube = test::cube(),
                    on_top = test::moved(test::inside_out(cube), 1, Vec3(0, 0, 1));
  CHECK(found_in(test::together(cube, on_top)) == "inverted");
  CHECK(found_in(test::together(on_top, cube)) == "inverted");
  // A needle along the diagonal, a millionth as wide as long.
  PolygonMesh needle = test::box(Vec3::Zero(), {1, 1e-6, 1e-6});
  for (Vec3& p : needle.vertices) p = Vec3(p.x() - p.y(), p.x() + p.y(), p.z());
  CHECK(found_in(needle) == "");
  CHECK(found_in(test::inside_out(needle)) == "inverted");
}

TEST_CASE("diagnose: plates and needles that lie askew are bodies, and inside out they are found") {
  const Mat3 R = Eigen::AngleAxisd(1.1, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  for (const Vec3& size : {Vec3(1, 1, 1e-8), Vec3(1, 1e-8, 1e-8), Vec3(1, 1e-12, 1e-3)}) {
    CAPTURE(size.transpose());
    PolygonMesh thin = test::box(Vec3::Zero(), size);
    for (Vec3& p : thin.vertices) p = R * p;
    CHECK(found_in(thin) == "");
    CHECK(found_in(test::inside_out(thin)) == "inverted");
  }
}

namespace {

/// All faces, and all of them once more, the other way round and from another corner on: a fan of
/// quads has other diagonals.
PolygonMesh doubled(const PolygonMesh& mesh) {
  PolygonMesh result = mesh;
  for (int f = 0; f < mesh.face_count(); ++f)
    result.add_face(std::vector<int>(mesh.face(f).rbegin(), mesh.face(f).rend()));
  return result;
}

/// A box that lies askew: corner by corner it is rounded.
PolygonMesh askew_box(int i, const Vec3& size) {
  PolygonMesh mesh = test::box(Vec3::Zero(), size);
  const Mat3 R = Eigen::AngleAxisd(0.7 + i, Vec3(1, 2 + i, 3).normalized()).toRotationMatrix();
  for (Vec3& p : mesh.vertices) p = R * p + Vec3(0.1, 3, 0.2);
  return mesh;
}

}  // namespace

TEST_CASE("diagnose: faces that are there twice, along other diagonals, enclose nothing") {
  for (int i = 0; i < 40; ++i)
    for (const int places : {17, 9, 6, 4}) {
      CAPTURE(i);
      CAPTURE(places);
      const PolygonMesh askew = askew_box(i, {1, 2, 0.5});
      const PolygonMesh box = test::with_decimals(askew, places);
      const PolygonMesh mesh = doubled(box);
      PolygonMesh apart = mesh;  // each copy with vertices of its own
      apart.vertices.insert(apart.vertices.end(), box.vertices.begin(), box.vertices.end());
      for (std::size_t k = box.corners.size(); k < apart.corners.size(); ++k)
        apart.corners[k] += static_cast<int>(box.vertices.size());
      for (const PolygonMesh& twice : {mesh, test::triangulated(mesh), apart})
        CHECK(found_in(twice).find("flat") != std::string::npos);
    }
}

TEST_CASE("diagnose: a foil is thin, and not there twice") {
  for (int i = 0; i < 40; ++i) {
    CAPTURE(i);
    CHECK(found_in(askew_box(i, {1, 2, 1e-13})) == "");
    CHECK(found_in(test::with_decimals(test::box({0, 0, 0}, {1.234567, 2.345678, 1e-6}), 6)) == "");
  }
}

TEST_CASE("diagnose: thin plates in a body count twice, though one might be rounding") {
  const auto plate = [](const Vec3& from, const Vec3& thickness) {
    const Vec3 a(40, 20, 10), b(-20, 60, 30);  // whole numbers: the last decimal is a metre
    PolygonMesh mesh = test::regular_cube(1, 1);
    for (Vec3& v : mesh.vertices)
      v = from + (v.x() > 0 ? a : Vec3(0, 0, 0)) + (v.y() > 0 ? b : Vec3(0, 0, 0)) +
          (v.z() > 0 ? thickness : Vec3(0, 0, 0));
    return mesh;
  };
  PolygonMesh mesh = test::moved(test::regular_cube(4, 1), 200, {0, 0, 0});
  for (const Vec3& thickness : {Vec3(0, 0, 1), Vec3(1, 0, 1), Vec3(0, -1, 1)}) {
    CAPTURE(thickness.transpose());
    CHECK(found_in(test::together(mesh, plate({0, 0, 0}, thickness))) == "nested_wrong");
  }
  for (int i = 0; i < 5; ++i) mesh = test::together(mesh, plate({0, 0, 20. * i - 60}, {0, 0, 1}));
  CHECK(found_in(mesh).starts_with("nested_wrong"));
}
