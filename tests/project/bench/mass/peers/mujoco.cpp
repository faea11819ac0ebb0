// MuJoCo: what its compiler makes of a mesh, as a whole (reading the model, its own checks, the
// convex hull), since nothing smaller can be called.
#include <mujoco/mujoco.h>

#include <cstring>
#include <memory>
#include <sstream>

#include "project/bench/mass/case.hpp"

namespace tumble::bench {
namespace {

/// The body as a model in MuJoCo's own language.
std::string model_of(const PolygonMesh& mesh, const std::string& exact) {
  std::ostringstream xml;
  xml.precision(17);
  xml << "<mujoco><compiler exactmeshinertia=\"" << exact
      << "\"/><asset><mesh name=\"m\" vertex=\"";
  for (const Vec3& v : mesh.vertices) xml << v.x() << ' ' << v.y() << ' ' << v.z() << ' ';
  xml << "\" face=\"";
  for (const int v : mesh.corners) xml << v << ' ';
  xml << "\"/></asset><worldbody><body><freejoint/><geom type=\"mesh\" mesh=\"m\" density=\"1\"/>"
         "</body></worldbody></mujoco>";
  return xml.str();
}

Answer measure(mjVFS& files) {
  Answer answer;
  char error[1000] = "";
  mjModel* model = mj_loadXML("body.xml", &files, error, sizeof error);
  if (model == nullptr) return answer;
  const mjtNum* p = model->body_ipos + 3;
  const mjtNum* q = model->body_iquat + 4;
  const mjtNum* I = model->body_inertia + 3;
  const Mat3 R = Quat(q[0], q[1], q[2], q[3]).toRotationMatrix();
  answer.mass = model->body_mass[1];
  answer.centre = {p[0], p[1], p[2]};
  answer.inertia = R * Vec3(I[0], I[1], I[2]).asDiagonal() * R.transpose();
  mj_deleteModel(model);
  return answer;
}

Method method(const std::string& name, const std::string& exact) {
  return {name,
          [exact](const Body& body) -> Run {
            const std::string xml = model_of(body.mesh, exact);
            const auto files = std::make_shared<mjVFS>();
            mj_defaultVFS(files.get());
            const int size = static_cast<int>(xml.size()) + 1;
            mj_makeEmptyFileVFS(files.get(), "body.xml", size);
            std::memcpy(files->filedata[mj_findFileVFS(files.get(), "body.xml")], xml.c_str(),
                        xml.size() + 1);
            return [files] { return measure(*files); };
          },
          true};
}

}  // namespace

void add_mujoco(std::vector<Method>& methods) {
  methods.push_back(method("MuJoCo, default", "false"));
  methods.push_back(method("MuJoCo, exact", "true"));
}

}  // namespace tumble::bench
