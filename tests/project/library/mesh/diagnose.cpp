#include "tumble/mesh/diagnose.hpp"

#include <doctest/doctest.h>

#include <functional>
#include <limits>
#include <set>
#include <string>

#include "project/library/mesh/shapes.hpp"

using namespace tumble;
using Kinds = std::vector<MeshDefectKind>;
using enum MeshDefectKind;

namespace {

std::string words(const Kinds& kinds) {
  std::string text;
  for (const MeshDefectKind kind : kinds)
    text += std::string(text.empty() ? "" : " ") + name_of(kind);
  return text;
}

/// The kinds that are found, each once, in the order of the enumeration.
std::string kinds(const PolygonMesh& mesh) {
  std::set<MeshDefectKind> found;
  for (const MeshDefect& finding : diagnose(mesh)) found.insert(finding.kind);
  return words({found.begin(), found.end()});
}

struct Planted {
  const char* what;
  std::function<PolygonMesh(const PolygonMesh&)> plant;
  Kinds expected;
};

/// A body of about the size 1 at the origin, smaller by `scale`.
PolygonMesh copy(const PolygonMesh& mesh, double scale, const Vec3& shift) {
  return test::moved(mesh, scale, shift);
}

PolygonMesh with_corner(PolygonMesh mesh, std::size_t corner, int v) {
  mesh.corners[corner] = v;
  return mesh;
}

PolygonMesh with_coordinate(PolygonMesh mesh, double value) {
  mesh.vertices[3].y() = value;
  return mesh;
}

/// With a triangle that has no area: two corners and a new one where one of them is.
PolygonMesh with_needle(PolygonMesh mesh, const Vec3& new_corner, const std::array<int, 2>& old) {
  mesh.vertices.push_back(new_corner);
  mesh.add_face({old[0], old[1], static_cast<int>(mesh.vertices.size()) - 1});
  return mesh;
}

/// The defects, planted in a triangulated body around the origin with face #1, radius 0.5 to 1.
const std::vector<Planted>& defects() {
  static const std::vector<Planted> list = {
      {"nothing", [](const PolygonMesh& m) { return m; }, {}},
      {"an unused vertex",
       [](PolygonMesh m) {
         m.vertices.emplace_back(0, 0, 0);
         return m;
       },
       {}},
      {"a face less", [](const PolygonMesh& m) { return test::without_face(m, 7); }, {open_edge}},
      {"a face turned",
       [](const PolygonMesh& m) { return test::with_face_flipped(m, 7); },
       {inconsistent_orientation}},
      {"a face twice",
       [](const PolygonMesh& m) { return test::with_face_twice(m, 7); },
       {duplicate_face, uneven_edge}},
      {"an index too large",
       [](const PolygonMesh& m) { return with_corner(m, 4, 1 << 30); },
       {index_out_of_range}},
      {"a negative index",
       [](const PolygonMesh& m) { return with_corner(m, 4, -1); },
       {index_out_of_range}},
      {"a NaN",
       [](const PolygonMesh& m) { return with_coordinate(m, std::nan("")); },
       {not_finite}},
      {"an infinity",
       [](const PolygonMesh& m) {
         return with_coordinate(m, std::numeric_limits<double>::infinity());
       },
       {not_finite}},
      {"a corner twice",
       [](PolygonMesh m) {
         m.add_face({0, 1, 1});
         return m;
       },
       {degenerate_face}},
      {"a face of two",
       [](PolygonMesh m) {
         m.add_face({0, 1});
         return m;
       },
       {degenerate_face}},
      {"a face without an area that no neighbour needs",
       [](PolygonMesh m) {
         return with_needle(m, m.vertex(0), {0, 1});
       },
       {degenerate_face}},
      {"one beside the body",
       [](PolygonMesh m) {
         m.vertices.emplace_back(2, 2, 2);
         m.vertices.emplace_back(3, 2, 2);
         const int last = static_cast<int>(m.vertices.size()) - 1;
         return with_needle(m, m.vertex(last), {last - 1, last});
       },
       {degenerate_face}},
      {"a corner twice, beside the body",
       [](PolygonMesh m) {
         m.vertices.emplace_back(2, 2, 2);
         m.vertices.emplace_back(3, 2, 2);
         const int last = static_cast<int>(m.vertices.size()) - 1;
         m.add_face({last, last, last - 1});
         return m;
       },
       {degenerate_face}},
      {"a face without an area, and a face less",
       [](const PolygonMesh& m) {
         const std::array edge = {m.face(1)[0], m.face(1)[1]};
         return with_needle(test::without_face(m, 7), m.vertex(edge[0]), edge);
       },
       {degenerate_face, open_edge, uneven_edge}},
      {"inside out", [](const PolygonMesh& m) { return test::inside_out(m); }, {inverted}},
      {"a part inside, outwards",
       [](const PolygonMesh& m) { return test::together(m, copy(m, 0.3, Vec3(0.05, 0.02, 0))); },
       {nested_wrong}},
      {"a tiny part inside, outwards",
       [](const PolygonMesh& m) { return test::together(m, copy(m, 1e-5, Vec3(0.05, 0.02, 0))); },
       {nested_wrong}},
      {"a cavity",
       [](const PolygonMesh& m) {
         return test::together(m, test::inside_out(copy(m, 0.3, Vec3(0.05, 0.02, 0))));
       },
       {}},
      {"a stone in a cavity",
       [](const PolygonMesh& m) {
         return test::together(test::together(copy(m, 0.1, Vec3::Zero()), m),
                               test::inside_out(copy(m, 0.3, Vec3::Zero())));
       },
       {}},
      {"all inside out, with a cavity",
       [](const PolygonMesh& m) {
         return test::together(test::inside_out(m), copy(m, 0.3, Vec3::Zero()));
       },
       {inverted}},
      {"a tiny part beside, inside out",
       [](const PolygonMesh& m) {
         return test::together(m, test::inside_out(copy(m, 1e-5, Vec3(1.5, 1.5, 1.5))));
       },
       {inverted}},
      {"a part beside",
       [](const PolygonMesh& m) { return test::together(m, copy(m, 1, Vec3(3, 0, 0))); },
       {}},
      {"a part that overlaps",
       [](const PolygonMesh& m) { return test::together(m, copy(m, 1, Vec3(0.7, 0.3, 0.2))); },
       {self_crossing}},
      {"the same part twice",
       [](const PolygonMesh& m) { return test::together(m, m); },
       {self_crossing}},
      {"a part and its mirror image",
       [](const PolygonMesh& m) { return test::together(m, test::inside_out(m)); },
       {flat}},
      {"corners of its own for each face",
       [](const PolygonMesh& m) { return test::soup(m); },
       {open_edge}},
  };
  return list;
}

/// A cube around the origin, of 12 triangles.
PolygonMesh small_body() {
  return test::triangulated(test::box(Vec3::Constant(-0.5), Vec3::Constant(0.5)));
}

}  // namespace

TEST_CASE(
    "diagnose: finds each defect planted in a cube or a sphere, and nothing else, at any scale and "
    "place") {
  const std::vector<PolygonMesh> bodies = {small_body(), test::sphere(5)};
  struct Place {
    double scale, far;
  };
  for (const PolygonMesh& body : bodies)
    for (const Planted& defect : defects())
      for (const Place& place : {Place{1, 0}, Place{1e-6, 0}, Place{1e3, 0}, Place{1, 1e8}}) {
        // What is tiny is not representable far away.
        if (place.far > 0 && std::string(defect.what).find("tiny") != std::string::npos) continue;
        CAPTURE(defect.what);
        CAPTURE(body.face_count());
        CAPTURE(place.scale);
        CAPTURE(place.far);
        const Vec3 shift(place.far, -place.far, place.far);
        CHECK(kinds(test::moved(defect.plant(body), place.scale, shift)) == words(defect.expected));
      }
}
