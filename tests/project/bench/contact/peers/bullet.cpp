// Bullet, in double precision: its world of rigid bodies, no threshold for restitution, nobody
// sleeps. By default it pushes bodies apart that will touch within a step, by so much that they
// just don't; where they bounce, part of the bounce is lost. And it adds to a bounce what pushes
// bodies out of each other. So it also goes without both. Its continuous detection holds bodies up
// at the time of impact for the rest of a step; that keeps them from tunnelling, which none does
// here, and costs accuracy, so it is off, as by default.
#include <btBulletDynamicsCommon.h>

#include "project/bench/contact/contest.hpp"

namespace tumble::bench {
namespace {

btVector3 vector(const Vec3& v) { return {v.x(), v.y(), v.z()}; }
Vec3 vector(const btVector3& v) { return {v.x(), v.y(), v.z()}; }

/// What can be chosen.
struct Options {
  double contact_to = BT_LARGE_FLOAT;  ///< the distance up to which two are in contact [m]
  double split_from = -0.04;  ///< the gap from which places are put right by themselves [m]
};

class World {
 public:
  World(const Scene& scene, double h, const Options& options) : h_(h), options_(options) {
    world_.setGravity(vector(scene.gravity));
    btContactSolverInfo& info = world_.getSolverInfo();
    info.m_restitutionVelocityThreshold = 0;
    info.m_numIterations = 50;
    info.m_splitImpulsePenetrationThreshold = options.split_from;
    for (const Wall& wall : scene.walls) add(wall);
    for (const Body& body : scene.bodies) add(body, scene);
  }
  World(const World&) = delete;
  ~World() {
    for (const auto& body : walls_) world_.removeRigidBody(body.get());
    for (const auto& body : bodies_) world_.removeRigidBody(body.get());
  }

  void advance(int steps) {
    for (int i = 0; i < steps; ++i)
      world_.stepSimulation(h_, 0);  // 0: one step of just this length
  }
  Motion motion(std::size_t i) const {
    const btRigidBody& body = *bodies_[i];
    const btQuaternion r = body.getWorldTransform().getRotation();
    return {vector(body.getWorldTransform().getOrigin()), vector(body.getLinearVelocity()),
            Quat(r.w(), r.x(), r.y(), r.z()), vector(body.getAngularVelocity())};
  }

 private:
  /// Of two in contact, the products of their coefficients count.
  void add(const Wall& wall) {
    shapes_.push_back(
        std::make_unique<btStaticPlaneShape>(vector(wall.normal), wall.normal.dot(wall.point)));
    walls_.push_back(std::make_unique<btRigidBody>(0, nullptr, shapes_.back().get()));
    walls_.back()->setRestitution(1);
    walls_.back()->setFriction(1);
    world_.addRigidBody(walls_.back().get());
  }
  void add(const Body& body, const Scene& scene) {
    if (body.form == Form::ball)
      shapes_.push_back(std::make_unique<btSphereShape>(body.radius()));
    else
      shapes_.push_back(std::make_unique<btBoxShape>(vector(Vec3(body.size / 2))));
    bodies_.push_back(std::make_unique<btRigidBody>(body.mass, nullptr, shapes_.back().get(),
                                                    vector(body.moments)));
    btRigidBody& made = *bodies_.back();
    const auto& [x, v, q, omega] = body.start;
    made.setRestitution(scene.e);
    made.setFriction(scene.mu);
    made.setContactProcessingThreshold(options_.contact_to);
    made.setActivationState(DISABLE_DEACTIVATION);
    made.setCenterOfMassTransform(btTransform(btQuaternion(q.x(), q.y(), q.z(), q.w()), vector(x)));
    made.setLinearVelocity(vector(v));
    made.setAngularVelocity(vector(omega));
    world_.addRigidBody(&made);
  }

  double h_;
  Options options_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> walls_, bodies_;
};

Stepper stepper(const std::string& name, const Options& options) {
  return {"Bullet (double)", name, [options](const Scene& scene, double h) {
            return std::make_unique<Fresh<World>>(
                [scene, h, options] { return std::make_unique<World>(scene, h, options); });
          }};
}

}  // namespace
}  // namespace tumble::bench

extern "C" void tumble_add_peer(std::vector<tumble::bench::Stepper>& steppers) {
  static_assert(sizeof(btScalar) == sizeof(double));
  steppers.push_back(tumble::bench::stepper("default", {}));
  steppers.push_back(tumble::bench::stepper("contact from touch on, split", {0, 0}));
}
