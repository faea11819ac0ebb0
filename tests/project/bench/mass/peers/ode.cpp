// Open Dynamics Engine: dMassSetTrimesh.
#include <ode/ode.h>

#include <memory>

#include "project/bench/mass/case.hpp"

namespace tumble::bench {
namespace {

/// A mesh as ODE wants it: the data, and a geometry made of it.
struct Geometry {
  std::vector<double> xyz;
  std::vector<dTriIndex> corners;
  dTriMeshDataID data;
  dGeomID geometry;

  explicit Geometry(const PolygonMesh& mesh) {
    dInitODE2(0);
    for (const Vec3& v : mesh.vertices) xyz.insert(xyz.end(), {v.x(), v.y(), v.z()});
    for (const int v : mesh.corners) corners.push_back(static_cast<dTriIndex>(v));
    data = dGeomTriMeshDataCreate();
    dGeomTriMeshDataBuildDouble(data, xyz.data(), 3 * sizeof(double),
                                static_cast<int>(mesh.vertices.size()), corners.data(),
                                static_cast<int>(corners.size()), 3 * sizeof(dTriIndex));
    geometry = dCreateTriMesh(nullptr, data, nullptr, nullptr, nullptr);
  }
  Geometry(const Geometry&) = delete;
  ~Geometry() {
    dGeomDestroy(geometry);
    dGeomTriMeshDataDestroy(data);
    dCloseODE();
  }
};

Answer measure(const Geometry& geometry) {
  dMass mass;
  dMassSetTrimesh(&mass, 1, geometry.geometry);
  Answer answer;
  answer.mass = mass.mass;
  answer.centre = {mass.c[0], mass.c[1], mass.c[2]};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) answer.inertia(i, j) = mass.I[4 * i + j];  // rows of four
  // Documented as about the origin of the body; what it means by it is the centre of mass.
  const Vec3& c = answer.centre;
  answer.inertia -= answer.mass * (c.squaredNorm() * Mat3::Identity() - c * c.transpose());
  return answer;
}

}  // namespace

void add_ode(std::vector<Method>& methods) {
  methods.push_back({"ODE",
                     [](const Body& body) -> Run {
                       const auto geometry = std::make_shared<Geometry>(body.mesh);
                       return [geometry] { return measure(*geometry); };
                     },
                     true});
}

}  // namespace tumble::bench
