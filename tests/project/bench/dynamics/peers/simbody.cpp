// Simbody: its adaptive integrators, on a body held by a ball joint.
#include <Simbody.h>

#include "project/bench/dynamics/contest.hpp"

namespace tumble::bench {
namespace {

SimTK::Vec3 vector(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

template <class Integrator>
class World {
 public:
  World(const Problem& problem, double tolerance) : duration_(problem.duration) {
    const SimTK::Inertia inertia(vector(problem.body().moments));
    body_ = SimTK::MobilizedBody::Ball(
        matter_.Ground(), SimTK::Body::Rigid(SimTK::MassProperties(1, SimTK::Vec3(0), inertia)));
    const Push& push = problem.scene.push;
    if (!problem.scene.free())
      SimTK::Force::ConstantForce(forces_, body_, vector(push.p_body), vector(push.force));
    start_ = system_.realizeTopology();
    const auto& [q, omega] = problem.body().start;
    body_.setQToFitRotation(start_, SimTK::Rotation(SimTK::Quaternion(q.w(), q.x(), q.y(), q.z())));
    body_.setUToFitAngularVelocity(start_, vector(q * omega));
    integrator_ = std::make_unique<Integrator>(system_);
    integrator_->setAccuracy(tolerance);
    integrator_->setAllowInterpolation(false);
    integrator_->setFinalTime(duration_);
    integrator_->setInternalStepLimit(1'000'000);  // CPodes complains after every 500
  }

  Quat end() {
    integrator_->initialize(start_);
    while (integrator_->getTime() < duration_) integrator_->stepTo(duration_);
    const SimTK::Quaternion q =
        body_.getBodyRotation(integrator_->getState()).convertRotationToQuaternion();
    return {q[0], q[1], q[2], q[3]};
  }

 private:
  double duration_;
  SimTK::MultibodySystem system_;
  SimTK::SimbodyMatterSubsystem matter_{system_};
  SimTK::GeneralForceSubsystem forces_{system_};
  SimTK::MobilizedBody::Ball body_;
  SimTK::State start_;
  std::unique_ptr<Integrator> integrator_;
};

template <class Integrator>
Method method(const std::string& name) {
  const auto prepare = [](const Problem& problem, double tolerance) -> Run {
    return
        [world = std::make_shared<World<Integrator>>(problem, tolerance)] { return world->end(); };
  };
  return {"Simbody", name, Knob::tolerance, prepare};
}

}  // namespace
}  // namespace tumble::bench

extern "C" void tumble_add_peer(tumble::bench::Contestants& contestants) {
  using namespace tumble::bench;
  contestants.methods.push_back(method<SimTK::RungeKuttaMersonIntegrator>("RungeKuttaMerson"));
  contestants.methods.push_back(method<SimTK::RungeKuttaFeldbergIntegrator>("RungeKuttaFeldberg"));
  // Its default, BDF: with Adams' formulas version 3.7 stops early on all of the problems.
  contestants.methods.push_back(method<SimTK::CPodesIntegrator>("CPodes"));
}
