#include "scenes/read_shape.hpp"

#include <iostream>

#include "objects/shapes.hpp"
#include "scenes/round_solids.hpp"
#include "support/mesh_notes.hpp"
#include "support/printable.hpp"
#include "support/table.hpp"
#include "support/view.hpp"
#include "tumble/collide/hull_points.hpp"
#include "tumble/mesh/read_mesh.hpp"
#include "tumble/mesh/weld_if_open.hpp"

namespace tumble::scenes {
namespace {

using support::Place;
constexpr int drawn_sides = 20;  // of what is round

template <class S>
ReadShape closed_form(const S& solid) {
  return {solid, mass_properties(solid, 1)};
}

ReadShape round_shape(const std::string& kind, const Place& place) {
  place.require_some({"radius", "height"});
  const double radius = place["radius"].number(), height = place["height"].number();
  if (kind == "cylinder") return closed_form(Cylinder{radius, height});
  if (kind == "cone") return closed_form(Cone{radius, height});
  return closed_form(Capsule{radius, height});
}

void print_notes(const Place& place, int welded, const std::vector<MeshDefect>& findings) {
  for (const std::string& note : support::mesh_notes(welded, findings))
    std::cerr << "tumble: note: " << place.name() << ": " << note << '\n';
}

ReadShape mesh_shape(const Place& place, const std::filesystem::path& folder,
                     const parts::Densities& densities) {
  parts::LabelledMesh mesh = read_mesh(mesh_path(place, folder).string());
  const int welded = detail::weld_if_open(mesh);
  const auto noted = [&](const auto& body) {
    print_notes(place, welded, body.findings);
    return ReadShape{mesh, body};
  };
  if (densities.empty()) return noted(mesh_mass_properties(mesh, 1));
  return noted(parts::mass_properties(mesh, densities));
}

PolygonMesh moved(PolygonMesh mesh, const Vec3& by) {
  for (Vec3& vertex : mesh.vertices) vertex += by;
  return mesh;
}

/// By how much a vertex reaches beyond the plane of a face of the mesh: 0 if the mesh is convex.
double bulges(const PolygonMesh& mesh, const collide::Convex& hull) {
  double most = 0;
  for_each_triangle(mesh, [&](int, const std::array<int, 3>& corners) {
    const Vec3& a = mesh.vertex(corners[0]);
    const Vec3 normal = (mesh.vertex(corners[1]) - a).cross(mesh.vertex(corners[2]) - a);
    if (normal.norm() == 0) return;
    const Vec3 out = normal.normalized();
    most = std::max(most, out.dot(hull.point(hull.farthest(out)) - a));
  });
  return most;
}

BodyShape shape_around(const Ball& ball, const Vec3&) {
  const Ellipsoid sphere{Vec3::Constant(ball.radius)};
  return {collide::Convex::ball(ball.radius), polyhedron_in(sphere, drawn_sides).mesh, "a ball"};
}

BodyShape shape_around(const Box& box, const Vec3&) {
  return {collide::Convex::box(box.size), shapes::box_mesh(box.size), "a box"};
}

/// What is round and no ball collides as a fine polyhedron.
template <class Round>
BodyShape shape_around(const Round& round, const Vec3& centre) {
  constexpr bool bent = std::same_as<Round, Ellipsoid> || std::same_as<Round, Capsule>;
  const Polyhedron fine = polyhedron_in(round, bent ? 64 : 128);
  const collide::Convex hull = collide::Convex::hull(fine.mesh, centre);
  return {hull, moved(polyhedron_in(round, drawn_sides).mesh, -centre),
          "a polyhedron with " + std::to_string(hull.points().size()) + " corners on the surface",
          fine.missing};
}

BodyShape shape_around(const PolygonMesh& mesh, const Vec3& centre) {
  constexpr int many = 600, cells = 18;  // of what is drawn
  const PolygonMesh centred = moved(mesh, -centre);
  const collide::Convex hull = collide::Convex::hull(collide::hull_points(centred.vertices));
  const bool convex = bulges(centred, hull) <= 1e-6 * hull.reach();
  const std::string points = std::to_string(hull.points().size()) + " points";
  return {hull, mesh.face_count() > many ? support::coarsened(centred, cells) : centred,
          convex ? "the hull of " + points
                 : "the hull of " + points +
                       ". The mesh is not convex: its hollows collide as if they were filled"};
}

}  // namespace

std::filesystem::path mesh_path(const Place& mesh, const std::filesystem::path& folder) {
  const std::string name = mesh.text();
  require(name.find('\0') == std::string::npos, mesh.name(), " is \"", support::escaped(name),
          "\": no file has \\u0000 in its name");  // the system would open what stands before it
  return folder / name;
}

ReadShape read_shape(const Place& shape, const std::filesystem::path& folder,
                     const parts::Densities& densities) {
  const std::string kind = shape.only_key(
      {"ball", "box", "cylinder", "cone", "capsule", "ellipsoid", "mesh"}, "a body has one shape");
  const Place place = shape[kind.c_str()];
  return place.refused_here([&]() -> ReadShape {
    if (kind == "mesh") return mesh_shape(place, folder, densities);
    require(densities.empty(),
            "only a mesh has parts with densities of their own: give one density");
    if (kind == "ball") return closed_form(Ball{place.number()});
    if (kind == "box") return closed_form(Box{place.vector()});
    if (kind == "ellipsoid") return closed_form(Ellipsoid{place.vector()});
    return round_shape(kind, place);
  });
}

BodyShape body_shape(const ReadShape& shape) {
  return std::visit([&](const auto& solid) { return shape_around(solid, shape.unit.centre); },
                    shape.solid);
}

}  // namespace tumble::scenes
