// volInt.c, the program that came with Mirtich's paper, in the form that takes meshes of any size
// (Carcich's poly_props). Its main() is not used, nor how it reads files.
#include <Eigen/Geometry>
#include <memory>

#include "project/bench/mass/case.hpp"

#define main volint_main
#include <volInt.c>
#undef main
#undef X
#undef Y
#undef Z

namespace tumble::bench {
namespace {

/// A mesh as volInt wants it, with the planes of its faces.
struct Volint {
  std::vector<Vec3> vertices;
  std::vector<double*> rows;
  std::vector<FACE> faces;
  POLYHEDRON polyhedron{};

  explicit Volint(const PolygonMesh& mesh) : vertices(mesh.vertices) {
    for (Vec3& v : vertices) rows.push_back(v.data());
    for (int f = 0; f < mesh.face_count(); ++f) faces.push_back(face_of(mesh.face(f)));
    polyhedron.numVerts = static_cast<int>(vertices.size());
    polyhedron.numFaces = mesh.face_count();
    polyhedron.verts = rows.data();
    polyhedron.faces = faces.data();
  }
  Volint(const Volint&) = delete;

 private:
  FACE face_of(std::span<const int> corners) {
    FACE face{};
    face.poly = &polyhedron;
    face.numVerts = static_cast<int>(corners.size());
    std::copy(corners.begin(), corners.end(), face.iverts);
    const auto corner = [&](std::size_t k) -> const Vec3& {
      return vertices[static_cast<std::size_t>(corners[k])];
    };
    const Vec3 n = (corner(1) - corner(0)).cross(corner(2) - corner(1)).normalized();
    Eigen::Map<Vec3>(face.norm) = n;
    face.w = -n.dot(corner(0));
    return face;
  }
};

/// What its main() makes of the integrals.
Answer measure(Volint& volint) {
  compVolumeIntegrals(&volint.polyhedron);
  Answer answer;
  answer.mass = T0;
  answer.centre = Vec3(T1[0], T1[1], T1[2]) / T0;
  answer.inertia << T2[1] + T2[2], -TP[0], -TP[2],  //
      -TP[0], T2[2] + T2[0], -TP[1],                //
      -TP[2], -TP[1], T2[0] + T2[1];
  const Vec3& c = answer.centre;
  answer.inertia -= answer.mass * (c.squaredNorm() * Mat3::Identity() - c * c.transpose());
  return answer;
}

}  // namespace

void add_volint(std::vector<Method>& methods) {
  methods.push_back({"volInt, planes given", [](const Body& body) -> Run {
                       const auto volint = std::make_shared<Volint>(body.mesh);
                       return [volint] { return measure(*volint); };
                     }});
}

}  // namespace tumble::bench
