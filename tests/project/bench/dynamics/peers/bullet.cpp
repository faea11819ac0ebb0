// Bullet: its world of rigid bodies, with each of its ways to treat the gyroscopic term. Compiled
// once for each of its precisions that is there.
#include <btBulletDynamicsCommon.h>

#include "project/bench/dynamics/contest.hpp"

namespace tumble::bench {
namespace {

btVector3 vector(const Vec3& v) {
  return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), static_cast<btScalar>(v.z())};
}

btQuaternion quaternion(const Quat& q) {
  return {static_cast<btScalar>(q.x()), static_cast<btScalar>(q.y()), static_cast<btScalar>(q.z()),
          static_cast<btScalar>(q.w())};
}

/// Side by side on a lattice: in one row they would make its tree of boxes deep and slow.
btVector3 place(std::size_t i) {
  constexpr std::size_t side = 22;
  return btScalar(10) * btVector3(static_cast<btScalar>(i % side),
                                  static_cast<btScalar>(i / side % side),
                                  static_cast<btScalar>(i / side / side));
}

class World : public Simulation {
 public:
  World(const Scene& scene, double h, int gyroscopic)
      : scene_(scene), h_(static_cast<btScalar>(h)) {
    world_.setGravity({0, 0, 0});
    for (const Body& body : scene.bodies) {
      bodies_.push_back(std::make_unique<btRigidBody>(1, nullptr, &shape_, vector(body.moments)));
      bodies_.back()->setFlags(gyroscopic);
      bodies_.back()->setActivationState(DISABLE_DEACTIVATION);
      world_.addRigidBody(bodies_.back().get(), 0, 0);  // collides with nothing
    }
  }
  ~World() override {
    for (const auto& body : bodies_) world_.removeRigidBody(body.get());
  }

  void restart() override {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const auto& [q, omega] = scene_.bodies[i].start;
      bodies_[i]->setCenterOfMassTransform(btTransform(quaternion(q), place(i)));
      bodies_[i]->setAngularVelocity(vector(q * omega));
    }
  }
  void advance(int steps) override {
    for (int i = 0; i < steps; ++i) {
      if (!scene_.free()) apply_torques();
      world_.stepSimulation(h_, 0);  // 0: one step of just this length
    }
  }
  Spin spin(std::size_t body) const override {
    const btQuaternion r = bodies_[body]->getWorldTransform().getRotation();
    const btVector3& w = bodies_[body]->getAngularVelocity();
    const Quat q(r.w(), r.x(), r.y(), r.z());
    return {q, q.conjugate() * Vec3(w.x(), w.y(), w.z())};
  }

 private:
  void apply_torques() {
    const btVector3 force = vector(scene_.push.force), p_body = vector(scene_.push.p_body);
    for (const auto& body : bodies_)
      body->applyTorque((body->getWorldTransform().getBasis() * p_body).cross(force));
  }

  Scene scene_;
  btScalar h_;
  btSphereShape shape_{1};
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
};

Stepper stepper(const std::string& name, int gyroscopic) {
  const std::string precision = sizeof(btScalar) == sizeof(double) ? "double" : "float";
  return {"Bullet (" + precision + ")", name, [gyroscopic](const Scene& scene, double h) {
            return std::make_unique<World>(scene, h, gyroscopic);
          }};
}

}  // namespace
}  // namespace tumble::bench

extern "C" void tumble_add_peer(tumble::bench::Contestants& contestants) {
  using tumble::bench::stepper;
  contestants.steppers.push_back(
      stepper("implicit, body (default)", BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY));
  contestants.steppers.push_back(
      stepper("implicit, world", BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_WORLD));
  contestants.steppers.push_back(stepper("explicit", BT_ENABLE_GYROSCOPIC_FORCE_EXPLICIT));
  contestants.steppers.push_back(stepper("no gyroscopic term", 0));
}
