/// @file
/// What the page asks its reader to predict, and what the mesh has to do with it.

#include "common.hpp"
#include "parts.hpp"

namespace point_sampling_chapter {

Table kilograms_table() {
  Table table({"kilograms at", "I_xx", "I_xy", "I_xz", "I_yz"});
  std::vector<PointMass> points;
  const auto add = [&](const std::string& name, const std::vector<Vec3>& places) {
    for (const Vec3& place : places) points.push_back({1, place});
    Mat3 I = Mat3::Zero();
    for (const PointMass& point : points) I += point_inertia(point.mass, point.position);
    table.add({name, number(I(0, 0)), number(I(0, 1)), number(I(0, 2)), number(I(1, 2))});
  };
  add("(1, 2, 3)", {{1, 2, 3}});
  add("… and (1, −2, −3)", {{1, -2, -3}});
  add("… and (−1, 2, −3), (−1, −2, 3)", {{-1, 2, -3}, {-1, -2, 3}});
  return table;
}

Table meshes_table() {
  Table table({"object", "triangles", "mass"});
  const auto add = [&table](const std::string& name, const objects::Object& object) {
    for (const int resolution : {object.for_drawings, 2, object.fine}) {
      const PolygonMesh mesh = object.mesh(resolution);
      int triangles = 0;
      for_each_triangle(mesh, [&triangles](int, const std::array<int, 3>&) { ++triangles; });
      const double mass = mesh_mass_properties(mesh, object.density).mass;
      table.add({name, number(triangles, 6), number(1000 * mass, 4) + " g"});
    }
  };
  add("mug", objects::all[3]);
  add("tennis racket", objects::all[2]);
  return table;
}

}  // namespace point_sampling_chapter
