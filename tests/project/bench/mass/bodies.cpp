// The meshes: two of bodies, a large one, the same far away, and one so thin that doubles give up.
#include <filesystem>

#include "objects/mug.hpp"
#include "project/bench/mass/case.hpp"
#include "project/library/mesh/shapes.hpp"
#include "reference/exact_moments.hpp"
#include "tumble/mesh/read_obj.hpp"

namespace tumble::bench {
namespace {

Body body(const std::string& name, const PolygonMesh& mesh) {
  return {name, mesh, reference::exact_mass_properties(mesh, 1), reference::exact_centre(mesh),
          bounds(mesh).sizes().norm()};
}

PolygonMesh mapped(PolygonMesh mesh, const Mat3& A, const Vec3& d) {
  for (Vec3& x : mesh.vertices) x = A * x + d;
  return mesh;
}

}  // namespace

std::vector<Body> bodies(int triangles) {
  std::vector<Body> all;
  const Mat3 askew = Quat(0.3, 0.5, -0.7, 0.2).normalized().toRotationMatrix();
  all.push_back(body("mug", mapped(objects::mug(4), askew, Vec3::Zero())));
  // All its terms are equal: the worst that can happen to a sum.
  all.push_back(body("regular cube", shapes::regular_cube(16, 0x1.a7e4ba3505ep+0)));
  const std::filesystem::path spot = std::filesystem::path(TUMBLE_MESHES) / "spot.obj";
  if (std::filesystem::exists(spot)) all.push_back(body("Spot", detail::read_obj(spot.string())));
  // Twice as many round the ring as round the tube, two triangles to a quad.
  const int tube = static_cast<int>(std::lround(std::sqrt(triangles / 4.0)));
  const PolygonMesh torus = test::triangulated(test::torus(2 * tube, tube));
  const std::string size = std::to_string(torus.face_count());
  all.push_back(body("torus of " + size, torus));
  all.push_back(body("torus of " + size + ", 1e8 away",
                     mapped(torus, Mat3::Identity(), Vec3(1e8, -1e8, 1e8))));
  const PolygonMesh needle = test::triangulated(test::box(Vec3::Zero(), Vec3(1, 1e-8, 1e-8)));
  all.push_back(body("needle 1 × 1e-8 × 1e-8", mapped(needle, askew, Vec3::Zero())));
  return all;
}

}  // namespace tumble::bench
