// Open Dynamics Engine: its two steps, with and without its finite rotation and gyroscopic term.
#include <ode/ode.h>

#include "project/bench/dynamics/contest.hpp"

namespace tumble::bench {
namespace {

/// What can be chosen.
struct Options {
  int (*step)(dWorldID, dReal);
  int gyroscopic = 1;
  int finite_rotation = 0;
};

class World : public Simulation {
 public:
  World(const Scene& scene, double h, const Options& options)
      : scene_(scene), h_(h), step_(options.step) {
    for (const Body& body : scene.bodies) {
      bodies_.push_back(dBodyCreate(world_));
      dMass mass;
      dMassSetParameters(&mass, 1, 0, 0, 0, body.moments[0], body.moments[1], body.moments[2], 0, 0,
                         0);
      dBodySetMass(bodies_.back(), &mass);
      dBodySetGyroscopicMode(bodies_.back(), options.gyroscopic);
      dBodySetFiniteRotationMode(bodies_.back(), options.finite_rotation);
    }
  }
  World(const World&) = delete;
  ~World() override { dWorldDestroy(world_); }

  void restart() override {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const auto& [q, omega] = scene_.bodies[i].start;
      const dQuaternion wxyz = {q.w(), q.x(), q.y(), q.z()};
      dBodySetQuaternion(bodies_[i], wxyz);
      const Vec3 world = q * omega;
      dBodySetAngularVel(bodies_[i], world.x(), world.y(), world.z());
    }
  }
  void advance(int steps) override {
    for (int i = 0; i < steps; ++i) {
      if (!scene_.free()) apply_torques();
      step_(world_, h_);
    }
  }
  Spin spin(std::size_t body) const override {
    const dReal* wxyz = dBodyGetQuaternion(bodies_[body]);
    const dReal* omega = dBodyGetAngularVel(bodies_[body]);
    const Quat q(wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
    return {q, q.conjugate() * Vec3(omega[0], omega[1], omega[2])};
  }

 private:
  void apply_torques() {
    for (const dBodyID body : bodies_) {
      dVector3 arm;
      const Vec3& p = scene_.push.p_body;
      dBodyVectorToWorld(body, p.x(), p.y(), p.z(), arm);
      const Vec3 torque = Vec3(arm[0], arm[1], arm[2]).cross(scene_.push.force);
      dBodyAddTorque(body, torque.x(), torque.y(), torque.z());
    }
  }

  Scene scene_;
  double h_;
  int (*step_)(dWorldID, dReal);
  dWorldID world_ = dWorldCreate();
  std::vector<dBodyID> bodies_;
};

Stepper stepper(const std::string& name, const Options& options) {
  return {"ODE", name, [options](const Scene& scene, double h) {
            return std::make_unique<World>(scene, h, options);
          }};
}

}  // namespace
}  // namespace tumble::bench

extern "C" void tumble_add_peer(tumble::bench::Contestants& contestants) {
  using tumble::bench::stepper;
  dInitODE2(0);
  contestants.steppers.push_back(stepper("step", {dWorldStep}));
  contestants.steppers.push_back(stepper("step, finite rotation", {dWorldStep, 1, 1}));
  contestants.steppers.push_back(stepper("quickstep", {dWorldQuickStep}));
  contestants.steppers.push_back(stepper("step, no gyroscopic term", {dWorldStep, 0}));
}
