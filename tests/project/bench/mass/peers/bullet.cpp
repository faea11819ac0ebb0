// Bullet: btConvexTriangleMeshShape, which takes volumes without their sign (right for convex
// bodies).
#include <BulletCollision/CollisionShapes/btConvexTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btTriangleMesh.h>

#include <memory>

#include "project/bench/mass/case.hpp"

namespace tumble::bench {
namespace {

btVector3 vector(const Vec3& v) {
  return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), static_cast<btScalar>(v.z())};
}

Answer measure(const btConvexTriangleMeshShape& shape) {
  btTransform principal;
  btVector3 moments;
  btScalar volume = 0;
  shape.calculatePrincipalAxisTransform(principal, moments, volume);
  Mat3 R;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) R(i, j) = principal.getBasis()[i][j];
  const auto centre = principal.getOrigin();
  Answer answer;
  answer.mass = volume;
  answer.centre = {centre.x(), centre.y(), centre.z()};
  // Moments for mass 1.
  answer.inertia =
      volume * (R * Vec3(moments.x(), moments.y(), moments.z()).asDiagonal() * R.transpose());
  return answer;
}

}  // namespace

void add_bullet(std::vector<Method>& methods) {
  methods.push_back({"Bullet",
                     [](const Body& body) -> Run {
                       const auto mesh = std::make_shared<btTriangleMesh>();
                       for_each_triangle(body.mesh, [&](int, const std::array<int, 3>& t) {
                         mesh->addTriangle(vector(body.mesh.vertex(t[0])),
                                           vector(body.mesh.vertex(t[1])),
                                           vector(body.mesh.vertex(t[2])));
                       });
                       const auto shape = std::make_shared<btConvexTriangleMeshShape>(mesh.get());
                       return [mesh, shape] { return measure(*shape); };
                     },
                     true});
}

}  // namespace tumble::bench
