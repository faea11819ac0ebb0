// CGAL: the volume of a closed surface mesh (apex in the origin). It has no inertia of a solid.
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <memory>

#include "project/bench/mass/case.hpp"

namespace tumble::bench {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;

std::shared_ptr<Surface> surface(const PolygonMesh& mesh) {
  auto result = std::make_shared<Surface>();
  for (const Vec3& v : mesh.vertices) result->add_vertex({v.x(), v.y(), v.z()});
  for_each_triangle(mesh, [&](int, const std::array<int, 3>& t) {
    const auto vertex = [](int v) { return Surface::Vertex_index(static_cast<unsigned>(v)); };
    result->add_face(vertex(t[0]), vertex(t[1]), vertex(t[2]));
  });
  return result;
}

}  // namespace

void add_cgal(std::vector<Method>& methods) {
  methods.push_back({"CGAL volume", [](const Body& body) -> Run {
                       return [mesh = surface(body.mesh)] {
                         Answer answer;
                         answer.mass = CGAL::Polygon_mesh_processing::volume(*mesh);
                         return answer;
                       };
                     }});
}

}  // namespace tumble::bench
