/// @file
/// A gem: what each of its faces contributes, and the shadows that they cast.

#include <array>
#include <cmath>

#include "common.hpp"
#include "parts.hpp"
#include "tumble/mass/principal_axes.hpp"

namespace mirtich_chapter {

namespace {

constexpr double gem_radius = 0.00325, diamond = 3510, carat = 0.0002;  // [m], [kg/m³], [kg]

/// Which part of the gem a face belongs to, in the order of the faces.
enum class Facet { table, crown, girdle, pavilion };

struct Gem {
  PolygonMesh mesh;
  std::vector<Facet> facets;

  void add(Facet facet, const std::vector<int>& corners) {
    mesh.add_face(corners);
    facets.push_back(facet);
  }
};

/// An octagon in the plane at height z, its first corner turned by `turn`.
void add_octagon(PolygonMesh& mesh, double R, double z, double turn) {
  for (int i = 0; i < 8; ++i) {
    const double angle = 45 * degree * i + turn;
    mesh.vertices.emplace_back(R * std::cos(angle), R * std::sin(angle), z);
  }
}

/// A gem with an octagonal table and girdle: 33 faces with 3, 4 and 8 corners.
/// @param R the girdle's radius; its tip is at `low`
Gem gem(double R, double low) {
  Gem g;
  add_octagon(g.mesh, 0.57 * R, low + 1.24 * R, 22.5 * degree);  // the table: vertices 0 … 7
  add_octagon(g.mesh, R, low + 0.92 * R, 0);                     // 8 … 15
  add_octagon(g.mesh, R, low + 0.86 * R, 0);                     // 16 … 23
  g.mesh.vertices.emplace_back(0, 0, low);
  g.add(Facet::table, {0, 1, 2, 3, 4, 5, 6, 7});
  for (int i = 0; i < 8; ++i) {
    const int next = (i + 1) % 8;
    g.add(Facet::crown, {i, 8 + i, 8 + next});
    g.add(Facet::crown, {i, 8 + next, next});
    g.add(Facet::girdle, {8 + i, 16 + i, 16 + next, 8 + next});
    g.add(Facet::pavilion, {16 + i, 24, 16 + next});
  }
  return g;
}

std::vector<Vec3> corners_of(const PolygonMesh& mesh, int f) {
  std::vector<Vec3> corners;
  for (const int v : mesh.face(f)) corners.push_back(mesh.vertex(v));
  return corners;
}

/// What the faces of one part bring, with shadows along z.
struct Brought {
  int faces = 0;
  double area = 0, shadow = 0, volume = 0;
};

}  // namespace

Table shadows_table() {
  const Gem g = gem(gem_radius, 0);
  std::array<Brought, 4> parts;
  for (int f = 0; f < g.mesh.face_count(); ++f) {
    const std::vector<Vec3> corners = corners_of(g.mesh, f);
    Brought& part = parts[static_cast<std::size_t>(g.facets[static_cast<std::size_t>(f)])];
    part.faces += 1;
    part.area += mirtich::vector_area(corners).norm();
    if (g.facets[static_cast<std::size_t>(f)] == Facet::girdle) continue;  // upright: no shadow
    const mirtich::Plane plane = mirtich::plane_of(corners, mirtich::vector_area(corners));
    const auto shadow = mirtich::projection_integrals(corners, 2);
    part.shadow += shadow.one;
    part.volume += plane.n.z() * mirtich::face_integrals(shadow, plane, 2).c;
  }
  Table table({"part", "faces", "area [mm²]", "of the shadows [mm²]", "Σ n_z ∬ z dA [mm³]"});
  const std::array names{"table", "crown", "girdle", "pavilion"};
  Brought all;
  const auto add = [&](const std::string& name, const Brought& part) {
    table.add({name, std::to_string(part.faces), number(part.area * 1e6, 4),
               std::abs(part.shadow) < 1e-15 ? "0" : number(part.shadow * 1e6, 4),
               part.volume == 0 ? "0" : number(part.volume * 1e9, 4)});
  };
  for (std::size_t i = 0; i < 4; ++i) {
    add(names[i], parts[i]);
    all.faces += parts[i].faces;
    all.area += parts[i].area;
    all.shadow += parts[i].shadow;
    all.volume += parts[i].volume;
  }
  add("all", all);
  return table;
}

namespace {

/// The gem's volume from rods along an axis, if the faces of some parts are turned round.
double volume_with_turned(const Gem& g, int axis, bool (*is_turned)(Facet)) {
  double volume = 0;
  for (int f = 0; f < g.mesh.face_count(); ++f) {
    std::vector<Vec3> corners = corners_of(g.mesh, f);
    for (Vec3& p : corners)  // the axis becomes x, along which face_moments() has its rods
      p = Vec3(p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3]);
    const double brought = mirtich::face_moments(corners).one;
    volume += is_turned(g.facets[static_cast<std::size_t>(f)]) ? -brought : brought;
  }
  return volume;
}

}  // namespace

Table turned_table() {
  const Gem g = gem(gem_radius, 0);
  Table table({"turned round", "rods along z [mm³]", "rods along x [mm³]"});
  const auto add = [&](const std::string& name, bool (*is_turned)(Facet)) {
    table.add({name, number(volume_with_turned(g, 2, is_turned) * 1e9, 4),
               number(volume_with_turned(g, 0, is_turned) * 1e9, 4)});
  };
  add("no face", [](Facet) { return false; });
  add("the table", [](Facet facet) { return facet == Facet::table; });
  add("all of the crown", [](Facet facet) { return facet == Facet::crown; });
  add("all faces", [](Facet) { return true; });
  return table;
}

Table gem_table() {
  const MassOptions textbook{Accuracy::textbook, Policy::refuse, anywhere};
  const PolygonMesh mesh = gem(gem_radius, 0).mesh;
  const MeshMassProperties stone = mesh_mass_properties(mesh, diamond, textbook);
  const Vec3 moments = principal_axes(stone.inertia).moments;
  Table table({"of the gem", "value"});
  table.add({"mass", number(stone.mass * 1e3) + " g = " + number(stone.mass / carat) + " carat"});
  table.add({"centre of mass, above the tip", number(stone.centre.z() * 1e3) + " mm"});
  table.add({"height", number(1.24 * gem_radius * 1e3) + " mm"});
  table.add({"moments across the axis",
             number(moments[0] * 1e12) + " and " + number(moments[1] * 1e12) + " mg mm²"});
  table.add({"moment about the axis", number(moments[2] * 1e12) + " mg mm²"});
  return table;
}

// ── The figure ──

namespace {

/// Seen from the front and a little from above.
Vec2 seen(const Vec3& p) {
  const double turn = 9 * degree, up = 24 * degree;
  const double x = std::cos(turn) * p.x() + std::sin(turn) * p.y();
  const double away = -std::sin(turn) * p.x() + std::cos(turn) * p.y();
  return {x, p.z() * std::cos(up) + away * std::sin(up)};
}

std::vector<Vec2> outline_of(const std::vector<Vec3>& corners) {
  std::vector<Vec2> line;
  for (const Vec3& p : corners) line.push_back(seen(p));
  line.push_back(line.front());
  return line;
}

void draw_floor(support::Sketch& sketch) {
  constexpr double half = 1.2;
  for (int i = -2; i <= 2; ++i) {
    const double at = half * i / 2;
    sketch.curve({seen({at, -half, 0}), seen({at, half, 0})}, {"grid", 1});
    sketch.curve({seen({-half, at, 0}), seen({half, at, 0})}, {"grid", 1});
  }
}

void draw_axes(support::Sketch& sketch) {
  const Vec3 corner(-1.2, -0.95, 0);
  const std::array<std::string, 3> names{"x", "y", "z"};
  for (Eigen::Index i = 0; i < 3; ++i) {
    const Vec2 from = seen(corner), to = seen(corner + 0.4 * Vec3::Unit(i));
    sketch.arrow(from, to, {"ink", 1.5});
    sketch.name_at_tip(from, to, names[static_cast<std::size_t>(i)]);
  }
}

/// How much a face is turned to a light from the upper left, from 0 to 1.
double brightness(const Vec3& n) { return 0.5 + 0.5 * n.dot(Vec3(-0.5, -0.6, 0.62).normalized()); }

/// The gem, on one side of the figure: the faces that look up, or those that look down, in colour.
void draw_side(support::Sketch& sketch, const Gem& g, bool up, const std::string& colour) {
  std::vector<int> order;
  for (int f = 0; f < g.mesh.face_count(); ++f) order.push_back(f);
  const auto distance = [&](int f) {
    double sum = 0;
    for (const Vec3& p : corners_of(g.mesh, f)) sum += p.y();
    return sum / static_cast<double>(g.mesh.face(f).size());
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](int f, int h) { return distance(f) > distance(h) + 1e-9; });
  const auto normal = [&](int f) -> Vec3 {
    return mirtich::vector_area(corners_of(g.mesh, f)).normalized();
  };
  for (const int f : order) {
    if (up ? normal(f).z() < 1e-9 : normal(f).z() > -1e-9) continue;
    std::vector<Vec3> shadow = corners_of(g.mesh, f);
    for (Vec3& p : shadow) p.z() = 0;
    sketch.curve(outline_of(shadow), {colour, 1, 1, 0.15 + 0.35 * brightness(normal(f))});
  }
  for (int v = up ? 0 : 16; v < (up ? 16 : 25); ++v) {
    const Vec3& p = g.mesh.vertex(v);
    sketch.curve({seen(p), seen({p.x(), p.y(), 0})}, {"faint", 0.7, 0.7});
  }
  for (const int f : order)
    if (up == (normal(f).z() < 1e-9))
      sketch.curve(outline_of(corners_of(g.mesh, f)), {"faint", 0.8, 0.8});
  for (const int f : order) {
    if (up ? normal(f).z() < 1e-9 : normal(f).z() > -1e-9) continue;
    sketch.curve(outline_of(corners_of(g.mesh, f)),
                 {colour, 1.3, 1, 0.2 + 0.6 * brightness(normal(f))});
  }
}

}  // namespace

std::string gem_figure() {
  support::Sketch sketch(760, 400, "The faces of a gem and their shadows", 19);
  const Gem g = gem(1, 0.42);
  for (const bool up : {true, false}) {
    sketch.look({up ? 190.0 : 570.0, 300, 148});
    draw_floor(sketch);
    if (!up) draw_axes(sketch);  // once, in the middle of the figure
    draw_side(sketch, g, up, up ? "c0" : "c1");
    sketch.words(seen({0, 0, 0}), {0, 92},
                 up ? "look up: shadows count plus" : "look down: shadows count minus",
                 up ? "c0" : "c1", "middle");
  }
  return sketch.svg();
}

}  // namespace mirtich_chapter
