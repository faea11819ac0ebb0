// libigl: moments (det(a, b, c) about the origin of the world).
#include <igl/moments.h>

#include "project/bench/mass/case.hpp"

namespace tumble::bench {

void add_libigl(std::vector<Method>& methods) {
  methods.push_back({"libigl moments", [](const Body& body) -> Run {
                       Eigen::MatrixXd V(body.mesh.vertices.size(), 3);
                       Eigen::MatrixXi F(body.mesh.face_count(), 3);
                       for (std::size_t i = 0; i < body.mesh.vertices.size(); ++i)
                         V.row(static_cast<Eigen::Index>(i)) = body.mesh.vertices[i].transpose();
                       for (int f = 0; f < body.mesh.face_count(); ++f)
                         for (int k = 0; k < 3; ++k)
                           F(f, k) = body.mesh.face(f)[static_cast<std::size_t>(k)];
                       return [V, F] {
                         Answer answer;
                         Vec3 first;
                         igl::moments(V, F, answer.mass, first, answer.inertia);
                         answer.centre = first / answer.mass;
                         return answer;
                       };
                     }});
}

}  // namespace tumble::bench
