/// @file
/// Meshes that bound no body: what is said of them, what integrals make of them, what is missed.

#include <limits>

#include "common.hpp"
#include "parts.hpp"
#include "support/wrapped.hpp"

namespace mirtich_chapter {

// ── A cube, spoiled ──

namespace {

using shapes::inside_out, shapes::together, shapes::with_face_flipped, shapes::without_face;

PolygonMesh with_face(PolygonMesh mesh, const std::vector<int>& face) {
  mesh.add_face(face);
  return mesh;
}

PolygonMesh with_vertex(PolygonMesh mesh, int v, const Vec3& x) {
  mesh.vertices[static_cast<std::size_t>(v)] = x;
  return mesh;
}

/// A third face at an edge of the cube.
PolygonMesh with_fin() {
  PolygonMesh mesh = triangulated(cube());
  mesh.vertices.emplace_back(2, 0, 0);
  mesh.add_face({1, 5, 8});
  return mesh;
}

PolygonMesh two_sides() {
  PolygonMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.add_face({0, 1, 2});
  mesh.add_face({0, 2, 1});
  return mesh;
}

PolygonMesh small_cube() { return cube(0.5, Vec3::Constant(0.25)); }

struct SpoiledCube {
  std::string what;
  MeshDefectKind kind;
  PolygonMesh mesh;
};

std::vector<SpoiledCube> spoiled_cubes() {
  using Kind = MeshDefectKind;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const PolygonMesh whole = cube(), cut = triangulated(whole);
  return {{"no face at all", Kind::no_faces, {}},
          {"a ninth vertex asked for", Kind::index_out_of_range, with_face(whole, {0, 1, 8})},
          {"a coordinate unknown", Kind::not_finite, with_vertex(whole, 7, {1, 1, nan})},
          {"a corner twice", Kind::degenerate_face, with_face(cut, {0, 1, 1})},
          {"a corner pulled", Kind::nonplanar_face, with_vertex(whole, 7, {1, 1, 1.2})},
          {"the bottom left out", Kind::open_edge, without_face(whole, 0)},
          {"a triangle turned", Kind::inconsistent_orientation, with_face_flipped(cut, 0)},
          {"a triangle twice", Kind::duplicate_face, with_face(cut, {4, 5, 7})},
          {"a fin on an edge", Kind::uneven_edge, with_fin()},
          {"a triangle and its back", Kind::flat, two_sides()},
          {"all faces turned", Kind::inverted, inside_out(whole)},
          {"a cube in the cube", Kind::nested_wrong, together(whole, small_cube())},
          {"a cube through the cube", Kind::self_crossing,
           together(whole, cube(1, Vec3::Constant(0.5)))}};
}

}  // namespace

Table findings_table() {
  constexpr std::size_t width = 65;
  Table table({"a cube with", support::padded("what is found: kind, place, meaning", width)});
  for (const SpoiledCube& spoiled : spoiled_cubes()) {
    const std::vector<MeshDefect> findings = diagnose(spoiled.mesh, anywhere);
    const auto found =
        std::find_if(findings.begin(), findings.end(),
                     [&](const MeshDefect& finding) { return finding.kind == spoiled.kind; });
    require(found != findings.end(), spoiled.what, " is not found");
    std::string what = spoiled.what;
    for (const std::string& line :
         support::lines_of(std::string(name_of(found->kind)) + ": " + found->message, width)) {
      table.add({what, support::padded(line, width)});
      what.clear();
    }
  }
  return table;
}

// ── What integrals make of them ──

namespace {

/// The volume if each face were in the plane of its first three corners, as some programs take it.
double volume_by_first_corners(const PolygonMesh& mesh, const Vec3& reference) {
  double sum = 0;
  for (int f = 0; f < mesh.face_count(); ++f) {
    std::vector<Vec3> corners;
    for (const int v : mesh.face(f)) corners.push_back(mesh.vertex(v) - reference);
    const std::vector<Vec3> first(corners.begin(), corners.begin() + 3);
    const mirtich::Plane plane = mirtich::plane_of(first, mirtich::vector_area(first));
    sum += mirtich::plane_face_moments(corners, plane).one;
  }
  return sum;
}

/// The same faces, each beginning at its next corner: their fans are cut along the other diagonal.
PolygonMesh beginning_later(const PolygonMesh& mesh) {
  PolygonMesh result;
  result.vertices = mesh.vertices;
  for (int f = 0; f < mesh.face_count(); ++f) {
    std::vector<int> face(mesh.face(f).begin(), mesh.face(f).end());
    std::rotate(face.begin(), face.begin() + 1, face.end());
    result.add_face(face);
  }
  return result;
}

}  // namespace

Table accept_table() {
  Table table({"a cube of 1 kg with", "about its middle", "about a corner", "with a diagnosis"});
  const auto add = [&](const std::string& what, const PolygonMesh& mesh) {
    const double middle = computed(mesh, Accuracy::tight).mass;
    const double corner = one_by_one<double>(mesh, Vec3::Zero(), six_volume_of_edges).mass;
    std::string says = "accepted";
    try {
      mesh_mass_properties(mesh, 1, {Accuracy::tight, Policy::refuse, anywhere});
    } catch (const std::invalid_argument&) {
      says = "refused: " + std::string(name_of(diagnose(mesh, anywhere).front().kind));
    }
    table.add({what, number(middle, 4) + " kg", number(corner, 4) + " kg", says});
  };
  add("nothing wrong", cube());
  add("its top left out", without_face(cube(), 1));
  add("its bottom left out", without_face(cube(), 0));
  add("its top twice", with_face(cube(), {4, 5, 7, 6}));
  add("all faces turned", inside_out(cube()));
  add("a cavity of 1/8 m³", together(cube(), inside_out(small_cube())));
  add("that cavity turned", together(cube(), small_cube()));
  add("a copy, shifted by 1/2", together(cube(), cube(1, Vec3::Constant(0.5))));
  return table;
}

Table nonplanar_table() {
  Table table({"the faces of the pulled cube are", "about its middle", "about a point 10 m off"});
  const PolygonMesh mesh = with_vertex(cube(), 7, {1, 1, 1.2});
  const Vec3 middle(0.5, 0.5, 0.6), off(10, 0, 0);
  const auto fans = [](const PolygonMesh& body, const Vec3& p) {
    return number(one_by_one<double>(body, p, six_volume_of_edges).mass, 4) + " m³";
  };
  table.add({"fans from their first corners", fans(mesh, middle), fans(mesh, off)});
  const PolygonMesh other = beginning_later(mesh);
  table.add({"fans from their second corners", fans(other, middle), fans(other, off)});
  table.add({"in the planes of three corners",
             number(volume_by_first_corners(mesh, middle), 4) + " m³",
             number(volume_by_first_corners(mesh, off), 4) + " m³"});
  return table;
}

// ── What a diagnosis misses ──

namespace {

/// A cube whose bottom has a spike of this width that goes up, through the top.
PolygonMesh spiked_cube(double width) {
  PolygonMesh mesh = without_face(cube(), 0);
  const double a = 0.47 - width / 2, b = 0.47 + width / 2;
  for (const Vec3& p : {Vec3(a, a, 0), Vec3(b, a, 0), Vec3(a, b, 0), Vec3(b, b, 0)})
    mesh.vertices.push_back(p);
  mesh.vertices.emplace_back(0.47, 0.47, 1.5);
  const std::array<int, 4> outer{0, 2, 3, 1}, inner{8, 10, 11, 9};
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t next = (i + 1) % 4;
    mesh.add_face({outer[i], outer[next], inner[next], inner[i]});
    mesh.add_face({inner[i], inner[next], 12});
  }
  return mesh;
}

}  // namespace

Table missed_table() {
  Table table({"width of the spike", "seen from above", "volume that counts −1 times", "found"});
  for (const double width : {0.4, 0.2, 0.1, 0.05, 0.02}) {
    const double through = width / 3;  // of its 1.5 m, the last 0.5 m are above the top
    const std::vector<MeshDefect> findings = diagnose(spiked_cube(width), anywhere);
    table.add({number(width) + " m", number(100 * through * through, 2) + " %",
               error_number(through * through * 0.5 / 3) + " m³",
               findings.empty() ? "nothing" : name_of(findings.front().kind)});
  }
  return table;
}

// ── The fingerprint of what is closed ──

namespace {

PolygonMesh octahedron() {
  PolygonMesh mesh;
  for (int k = 0; k < 3; ++k)
    for (const double side : {1., -1.}) mesh.vertices.push_back(side * Vec3::Unit(k));
  for (const std::array<int, 3>& face : {std::array{0, 2, 4},
                                         {2, 1, 4},
                                         {1, 3, 4},
                                         {3, 0, 4},
                                         {2, 0, 5},
                                         {1, 2, 5},
                                         {3, 1, 5},
                                         {0, 3, 5}})
    mesh.add_face(face);
  return mesh;
}

using Place = detail::RandomPlace<std::uint64_t>;

constexpr int first_drawn = 2648;

std::int64_t balance_of(const PolygonMesh& mesh) {
  std::uint64_t sum = 0;
  for_each_triangle(mesh, [&](int, const std::array<int, 3>& t) {
    const auto index = [](int v) { return static_cast<std::uint64_t>(v); };
    sum += detail::random_area<std::uint64_t>(index(t[0]), index(t[1]), index(t[2]));
  });
  return static_cast<std::int64_t>(sum);
}

/// A vertex's place in the plane, from −1 to 1. (Of other vertices than the table's: these spread
/// better.)
Vec2 place_of(int v) {
  const Place place(static_cast<std::uint64_t>(v + first_drawn));
  return Vec2(static_cast<double>(static_cast<std::int64_t>(place.u)),
              static_cast<double>(static_cast<std::int64_t>(place.v))) *
         0x1p-31;
}

std::vector<Vec2> spread(const std::array<int, 3>& t) {
  return {place_of(t[0]), place_of(t[1]), place_of(t[2]), place_of(t[0])};
}

/// The faces of an octahedron that go round one way.
void draw_spread(support::Sketch& sketch, bool positive) {
  for_each_triangle(octahedron(), [&](int, const std::array<int, 3>& t) {
    const std::vector<Vec2> line = spread(t);
    const Vec2 e = line[1] - line[0], f = line[2] - line[0];
    if ((e.x() * f.y() - e.y() * f.x() > 0) == positive)
      sketch.curve(line, {positive ? "c0" : "c1", 1.2, 1, 0.27});
  });
}

/// All faces but one, as lines, and that one.
void draw_hole(support::Sketch& sketch) {
  for_each_triangle(octahedron(), [&](int, const std::array<int, 3>& t) {
    sketch.curve(spread(t), {"faint", 0.8});
  });
  sketch.curve(spread({0, 2, 4}), {"c2", 2.5, 1, 0.3});
}

}  // namespace

Table balance_table() {
  Table table({"surface", "open edges", "twice the sum of the areas, modulo 2⁶⁴"});
  const auto add = [&](const std::string& what, int open, const PolygonMesh& mesh) {
    table.add({what, std::to_string(open), std::to_string(balance_of(mesh))});
  };
  add("octahedron", 0, octahedron());
  add("two, one inside the other", 0, together(octahedron(), octahedron()));
  add("a face left out", 3, without_face(octahedron(), 0));
  add("a face turned", 0, with_face_flipped(octahedron(), 0));
  add("a face twice", 0, with_face(octahedron(), {0, 2, 4}));
  add("left out here, turned there", 3, without_face(with_face_flipped(octahedron(), 3), 0));
  return table;
}

std::string places_figure() {
  support::Sketch sketch(760, 300, "A surface with its vertices at random places", 19);
  const std::array<std::string, 3> words{"one way round", "the other way", "a hole: what is left"};
  for (int panel = 0; panel < 3; ++panel) {
    sketch.look({127 + 253.0 * panel, 130, 112});
    if (panel < 2)
      draw_spread(sketch, panel == 0);
    else
      draw_hole(sketch);
    for (int v = 0; v < 6; ++v) sketch.dot(place_of(v), "ink", 4.5);
    sketch.words({0, -1}, {0, 44}, words[static_cast<std::size_t>(panel)],
                 panel == 0   ? "c0"
                 : panel == 1 ? "c1"
                              : "c2",
                 "middle");
  }
  return sketch.svg();
}

// ── Depth along a line ──

namespace {

std::vector<Vec2> ring(const Vec2& middle, double radius, double squeeze) {
  std::vector<Vec2> line;
  for (int i = 0; i <= 72; ++i)
    line.push_back(middle +
                   radius * Vec2(std::cos(5 * degree * i), squeeze * std::sin(5 * degree * i)));
  return line;
}

/// Short arrows across a ring: outwards, or inwards.
void draw_looks(support::Sketch& sketch, const Vec2& middle, double radius, double squeeze,
                bool outwards, const std::string& colour) {
  for (int i = 0; i < 8; ++i) {
    const double t = (45 * i + 22.5) * degree;
    const Vec2 p = middle + radius * Vec2(std::cos(t), squeeze * std::sin(t));
    const Vec2 n = Vec2(squeeze * std::cos(t), std::sin(t)).normalized();
    sketch.arrow(p, p + (outwards ? 0.2 : -0.2) * n, {colour, 1.6});
  }
}

/// A body with a part in it, a line through both, and the depth along the line beside them.
void draw_depth(support::Sketch& sketch, bool outwards) {
  const Vec2 middle(0, 0), inner(0.15, -0.1);
  const std::string colour = outwards ? "c1" : "c0";
  sketch.curve(ring(middle, 1, 1.05), {"ink", 2, 1, 0.12});
  sketch.curve(ring(inner, 0.45, 1.1), {colour, 2, 1, 0.15});
  draw_looks(sketch, middle, 1, 1.05, true, "ink");
  draw_looks(sketch, inner, 0.45, 1.1, outwards, colour);
  const double line = 0.15, out = 1.05 * std::sqrt(1 - line * line), in = 0.45 * 1.1;
  sketch.arrow({line, -1.35}, {line, 1.4}, {"ink", 1.2});
  const std::array<double, 6> z{-1.35, -out, inner.y() - in, inner.y() + in, out, 1.35};
  const std::array<int, 5> depth{0, 1, outwards ? 2 : 0, 1, 0};
  std::vector<Vec2> steps;
  for (std::size_t i = 0; i < 5; ++i) {
    const double x = 1.45 + 0.22 * depth[i];
    steps.emplace_back(x, z[i]), steps.emplace_back(x, z[i + 1]);
    sketch.words({x, (z[i] + z[i + 1]) / 2}, {8, 6}, std::to_string(depth[i]),
                 depth[i] > 1 ? "c1" : "ink");
  }
  for (const double height : z)
    if (std::abs(height) < 1.3) sketch.dot({line, height}, "ink", 4);
  sketch.curve(steps, {colour, 2.4});
}

}  // namespace

std::string depth_figure() {
  support::Sketch sketch(760, 400, "Depth along a vertical line", 19);
  for (const bool outwards : {false, true}) {
    sketch.look({outwards ? 520.0 : 140.0, 172, 108});
    draw_depth(sketch, outwards);
    sketch.words({0, -1.35}, {20, 42}, outwards ? "the part counts twice" : "a cavity", "ink",
                 "middle");
  }
  return sketch.svg();
}

}  // namespace mirtich_chapter
