/// @file
/// What the boxes take, beside the exact integrals over the same mesh.

#include "common.hpp"
#include "parts.hpp"
#include "support/stopwatch.hpp"

namespace bounding_boxes_chapter {

namespace {

const Thing& fine_mug() {
  static const Thing body = thing("mug", objects::all[3], objects::all[3].fine);
  return body;
}

}  // namespace

Table times_table() {
  const Thing& body = fine_mug();
  support::Stopwatch stopwatch;
  const std::string vertices = number(static_cast<double>(body.points().size()), 6) + " vertices",
                    triangles = number(body.mesh.face_count(), 6) + " triangles";
  std::vector<std::string> errors, seen;
  const auto add_box = [&](const std::string& name,
                           boxes::OrientedBox (*find)(std::span<const Vec3>)) {
    stopwatch.add(
        name, [&body, find] { support::keep(find(body.points())); }, 1);
    const Mat3 I = at_true_mass(find(body.points()), body).inertia;
    seen.push_back(vertices);
    errors.push_back(percent(inertia_error(I, body.truth.inertia)));
  };
  const auto add_sum = [&](const std::string& name, auto&& find) {
    stopwatch.add(
        name, [&body, find] { support::keep(find(body.mesh)); }, 1);
    seen.push_back(triangles);
    errors.emplace_back("< 1e-14");
  };
  add_box("box along the axes", boxes::aligned_box);
  add_box("principal box", boxes::principal_box);
  add_box("smaller box", boxes::small_oriented_box);
  const double density = body.density;
  add_sum("exact sum, fast", [density](const PolygonMesh& mesh) {
    return unchecked_mass_properties(mesh, density, Accuracy::fast);
  });
  add_sum("exact sum, tight", [density](const PolygonMesh& mesh) {
    return unchecked_mass_properties(mesh, density, Accuracy::tight);
  });
  add_sum("fast, mesh checked", [density](const PolygonMesh& mesh) {
    return mesh_mass_properties(mesh, density, {Accuracy::fast});
  });
  add_sum("tight, mesh checked", [density](const PolygonMesh& mesh) {
    return mesh_mass_properties(mesh, density, {Accuracy::tight});
  });
  Table table({"for a mug's inertia", "time", "as a ratio", "looks at", "error"});
  const std::vector<support::Timing> timings = stopwatch.timings();
  for (std::size_t i = 0; i < timings.size(); ++i)
    table.add({timings[i].name, support::duration(timings[i].seconds),
               times(timings[i].seconds / timings[3].seconds), seen[i], errors[i]});
  return table;
}

}  // namespace bounding_boxes_chapter
