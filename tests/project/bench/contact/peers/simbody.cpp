// Simbody: elastic balls by Hertz' law and an adaptive integrator. For other restitutions than 1 it
// has a dissipation, which gives none that is the same at all speeds; and a stepper with impacts,
// said to be experimental, which Debian's version 3.7 prints all its thoughts with.
#include <Simbody.h>

#include <algorithm>
#include <cmath>

#include "project/bench/contact/contest.hpp"

namespace tumble::bench {
namespace {

SimTK::Vec3 vector(const Vec3& v) { return {v.x(), v.y(), v.z()}; }
Vec3 vector(const SimTK::Vec3& v) { return {v[0], v[1], v[2]}; }

/// A modulus [Pa] with which a contact at 1 m/s lasts about h. Source: Johnson, "Contact Mechanics"
/// (1985), eq. 11.24.
double modulus(const Body& ball, double h) {
  return std::sqrt(std::pow(2.87 / h, 5) * ball.mass * ball.mass / ball.radius());
}

class World {
 public:
  World(const Scene& scene, double h) : h_(h) {
    SimTK::Force::UniformGravity(forces_, matter_, vector(scene.gravity));
    const SimTK::ContactMaterial elastic(modulus(scene.bodies[0], h), 0, 0, 0, 0);
    for (const Wall& wall : scene.walls) add(wall, elastic);
    for (const Body& body : scene.bodies) add(body, elastic);
    SimTK::State state = system_.realizeTopology();
    for (std::size_t i = 0; i < bodies_.size(); ++i) put(bodies_[i], scene.bodies[i].start, state);
    integrator_.setAccuracy(1e-9);
    integrator_.setInternalStepLimit(100'000'000);
    integrator_.initialize(state);
  }

  /// The steps only say where it is looked at: it takes its own.
  void advance(int steps) {
    done_ += steps;
    while (integrator_.getTime() < done_ * h_) integrator_.stepTo(done_ * h_);
  }
  Motion motion(std::size_t i) const {
    const SimTK::State& state = integrator_.getState();
    system_.realize(state, SimTK::Stage::Velocity);
    const SimTK::MobilizedBody& body = bodies_[i];
    const SimTK::Quaternion q = body.getBodyRotation(state).convertRotationToQuaternion();
    return {vector(body.getBodyOriginLocation(state)), vector(body.getBodyOriginVelocity(state)),
            Quat(q[0], q[1], q[2], q[3]), vector(body.getBodyAngularVelocity(state))};
  }

 private:
  /// A half space's own normal is −x.
  void add(const Wall& wall, const SimTK::ContactMaterial& material) {
    const SimTK::Rotation R(SimTK::UnitVec3(vector(Vec3(-wall.normal))), SimTK::XAxis);
    matter_.updGround().updBody().addContactSurface(
        SimTK::Transform(R, vector(wall.point)),
        SimTK::ContactSurface(SimTK::ContactGeometry::HalfSpace(), material));
  }
  void add(const Body& ball, const SimTK::ContactMaterial& material) {
    SimTK::Body::Rigid body(
        SimTK::MassProperties(ball.mass, SimTK::Vec3(0), SimTK::Inertia(vector(ball.moments))));
    body.addContactSurface(
        SimTK::Transform(),
        SimTK::ContactSurface(SimTK::ContactGeometry::Sphere(ball.radius()), material));
    bodies_.push_back(SimTK::MobilizedBody::Free(matter_.Ground(), body));
  }
  static void put(const SimTK::MobilizedBody& body, const Motion& start, SimTK::State& state) {
    const auto& [x, v, q, omega] = start;
    const SimTK::Rotation R(SimTK::Quaternion(q.w(), q.x(), q.y(), q.z()));
    body.setQToFitTransform(state, SimTK::Transform(R, vector(x)));
    body.setUToFitVelocity(state, SimTK::SpatialVec(vector(omega), vector(v)));
  }

  double h_;
  int done_ = 0;
  SimTK::MultibodySystem system_;
  SimTK::SimbodyMatterSubsystem matter_{system_};
  SimTK::GeneralForceSubsystem forces_{system_};
  SimTK::ContactTrackerSubsystem tracker_{system_};
  SimTK::CompliantContactSubsystem contacts_{system_, tracker_};
  std::vector<SimTK::MobilizedBody> bodies_;
  SimTK::RungeKuttaMersonIntegrator integrator_{system_};
};

}  // namespace
}  // namespace tumble::bench

extern "C" void tumble_add_peer(std::vector<tumble::bench::Stepper>& steppers) {
  using namespace tumble::bench;
  const auto make = [](const Scene& scene, double h) -> std::unique_ptr<Simulation> {
    constexpr std::size_t many = 5;  // the billiard break takes it 8 s a run
    const bool is_round = std::all_of(scene.bodies.begin(), scene.bodies.end(),
                                      [](const Body& b) { return b.form == Form::ball; });
    if (!is_round || scene.e != 1 || scene.bodies.size() > many) return nullptr;
    return std::make_unique<Fresh<World>>([scene, h] { return std::make_unique<World>(scene, h); });
  };
  steppers.push_back({"Simbody", "elastic balls, a contact lasts a step", make});
}
