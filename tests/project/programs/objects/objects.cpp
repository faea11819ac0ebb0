#include "objects/objects.hpp"

#include <doctest/doctest.h>

#include <map>
#include <string>

#include "project/harness/inputs.hpp"
#include "project/library/mesh/shapes.hpp"
#include "tumble/mesh/check_edges.hpp"
#include "tumble/mesh/diagnose.hpp"
#include "tumble/mesh/edge_use.hpp"

using namespace tumble;
using objects::Object;

namespace {

/// How many triangles the faces are.
int triangle_count(const PolygonMesh& mesh) {
  int count = 0;
  for_each_triangle(mesh, [&](int, const std::array<int, 3>&) { ++count; });
  return count;
}

/// The second moments ∫ x², ∫ y², ∫ z² about the centre of mass [m⁵]: slow but correct.
Vec3 second_moments(const PolygonMesh& mesh) {
  double volume = 0;
  Vec3 first = Vec3::Zero(), second = Vec3::Zero();
  for_each_triangle(mesh, [&](int, const std::array<int, 3>& t) {
    const Vec3 &a = mesh.vertex(t[0]), &b = mesh.vertex(t[1]), &c = mesh.vertex(t[2]);
    const double v = a.dot(b.cross(c)) / 6;
    const Vec3 sum = a + b + c;
    volume += v;
    first += v / 4 * sum;
    second += v / 20 * (sum.cwiseAbs2() + a.cwiseAbs2() + b.cwiseAbs2() + c.cwiseAbs2());
  });
  return second - first.cwiseAbs2() / volume;
}

}  // namespace

TEST_CASE("objects: bound a body at every resolution") {
  for (const Object& object : objects::all)
    for (const int r : {1, 2, 3, 4, 5, 6, 7, 8, 12}) {
      CAPTURE(std::string(object.name));
      CAPTURE(r);
      for (const MeshDefect& finding : diagnose(object.mesh(r))) FAIL_CHECK(finding.message);
    }
}

TEST_CASE("objects: have the holes that the things have") {
  // V − E + F = 2 for a ball, 0 for a ring; the racket is a ring and 32 strings.
  const std::map<std::string, int> expected = {
      {"t_handle", 2}, {"wing_nut", 0}, {"tennis_racket", 0 + 32 * 2}, {"mug", 0}, {"gear", 0}};
  for (const Object& object : objects::all)
    for (const int r : {1, 2, 5}) {
      CAPTURE(std::string(object.name));
      CAPTURE(r);
      CHECK(test::euler_characteristic(object.mesh(r)) == expected.at(object.name));
    }
}

TEST_CASE("objects: each edge has two faces: nothing touches") {
  for (const Object& object : objects::all)
    for (const int r : {1, 3}) {
      std::map<std::pair<int, int>, int> faces;
      const PolygonMesh mesh = object.mesh(r);
      for (const detail::EdgeUse& use : detail::edge_uses(mesh)) ++faces[{use.low, use.high}];
      CAPTURE(std::string(object.name));
      for (const auto& [edge, count] : faces) CHECK(count == 2);
    }
}

TEST_CASE("objects: no vertex is left over, and polygons are flat") {
  for (const Object& object : objects::all) {
    const PolygonMesh mesh = object.mesh(2);
    CAPTURE(std::string(object.name));
    for (const int part : detail::label_components(mesh).of_vertex) CHECK(part >= 0);
    for (int f = 0; f < mesh.face_count(); ++f)
      for (std::size_t k = 3; k < mesh.face(f).size(); ++k) {
        const Vec3& o = mesh.vertex(mesh.face(f)[0]);
        const Vec3 u = mesh.vertex(mesh.face(f)[1]) - o, v = mesh.vertex(mesh.face(f)[2]) - o;
        const Vec3 w = mesh.vertex(mesh.face(f)[k]) - o;
        CHECK(std::abs(w.dot(u.cross(v))) <= 16 * test::eps * u.norm() * v.norm() * w.norm());
      }
  }
}

TEST_CASE("objects: come with some hundred triangles for drawings, and with about 20,000") {
  for (const Object& object : objects::all) {
    CAPTURE(std::string(object.name));
    const int coarse = triangle_count(object.mesh(object.for_drawings)),
              fine = triangle_count(object.mesh(object.fine));
    CHECK(coarse > 300);
    CHECK(coarse < 2000);
    CHECK(fine > 16000);
    CHECK(fine < 24000);
  }
}

TEST_CASE("objects: a finer mesh is the same thing") {
  for (const Object& object : objects::all) {
    CAPTURE(std::string(object.name));
    const double v4 = test::volume(object.mesh(4)), v8 = test::volume(object.mesh(8)),
                 v16 = test::volume(object.mesh(16));
    CHECK(v4 > 0);
    // Inscribed polyhedra: the error falls as r⁻², by 4 from each to the next; 2.5 leaves room.
    CHECK(std::abs(v16 - v8) < std::abs(v8 - v4) / 2.5);
    CHECK(std::abs(v16 - v8) < 0.01 * v16);
  }
}

TEST_CASE("objects: real sizes in metres") {
  const std::map<std::string, Vec3> sizes = {{"t_handle", {0.0865, 0.120, 0.020}},
                                             {"wing_nut", {0.0485, 0.019, 0.020}},
                                             {"tennis_racket", {0.6915, 0.273, 0.031}},
                                             {"mug", {0.116, 0.082, 0.096}},
                                             {"gear", {0.060, 0.060, 0.010}}};
  for (const Object& object : objects::all) {
    CAPTURE(std::string(object.name));
    const Vec3 size = bounds(object.mesh(object.fine)).sizes();
    CAPTURE(size.transpose());
    CHECK((size - sizes.at(object.name)).lpNorm<Eigen::Infinity>() < 0.0015);
  }
}

TEST_CASE(
    "t_handle, tennis_racket: the intermediate moment is about the stem, and about the face's y") {
  // The moments are s_y + s_z, s_z + s_x, s_x + s_y: the intermediate axis is that of the middle s.
  const Vec3 t = second_moments(objects::t_handle(3));
  CHECK(t.z() < 0.8 * t.x());
  CHECK(t.x() < 0.8 * t.y());
  const Vec3 racket = second_moments(objects::tennis_racket(2));
  CHECK(racket.z() < 0.8 * racket.y());
  CHECK(racket.y() < 0.8 * racket.x());
}

TEST_CASE("objects: a resolution below 1 is refused") {
  for (const Object& object : objects::all)
    for (const int r : {0, -1}) CHECK_THROWS_AS(object.mesh(r), std::invalid_argument);
}
