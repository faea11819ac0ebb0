// Open Dynamics Engine: its two steps, no threshold for restitution, nobody is disabled.
#include <ode/ode.h>

#include <array>

#include "project/bench/contact/contest.hpp"

namespace tumble::bench {
namespace {

using Step = int (*)(dWorldID, dReal);

class World {
 public:
  World(const Scene& scene, double h, Step step) : scene_(scene), h_(h), step_(step) {
    dWorldSetGravity(world_, scene.gravity.x(), scene.gravity.y(), scene.gravity.z());
    dWorldSetQuickStepNumIterations(world_, 50);
    for (const Wall& wall : scene.walls)
      dCreatePlane(space_, wall.normal.x(), wall.normal.y(), wall.normal.z(),
                   wall.normal.dot(wall.point));
    for (const Body& body : scene.bodies) add(body);
  }
  World(const World&) = delete;
  ~World() {
    dJointGroupDestroy(contacts_);
    dSpaceDestroy(space_);
    dWorldDestroy(world_);
  }

  void advance(int steps) {
    for (int i = 0; i < steps; ++i) {
      dSpaceCollide(space_, this, touch);
      step_(world_, h_);
      dJointGroupEmpty(contacts_);
    }
  }
  Motion motion(std::size_t i) const {
    const dReal* q = dBodyGetQuaternion(bodies_[i]);
    return {vector(dBodyGetPosition(bodies_[i])), vector(dBodyGetLinearVel(bodies_[i])),
            Quat(q[0], q[1], q[2], q[3]), vector(dBodyGetAngularVel(bodies_[i]))};
  }

 private:
  static Vec3 vector(const dReal* v) { return {v[0], v[1], v[2]}; }

  void add(const Body& body) {
    const dBodyID made = dBodyCreate(world_);
    dMass mass;
    const Vec3& I = body.moments;
    dMassSetParameters(&mass, body.mass, 0, 0, 0, I[0], I[1], I[2], 0, 0, 0);
    dBodySetMass(made, &mass);
    const auto& [x, v, q, omega] = body.start;
    const dQuaternion wxyz = {q.w(), q.x(), q.y(), q.z()};
    dBodySetPosition(made, x.x(), x.y(), x.z());
    dBodySetQuaternion(made, wxyz);
    dBodySetLinearVel(made, v.x(), v.y(), v.z());
    dBodySetAngularVel(made, omega.x(), omega.y(), omega.z());
    const Vec3& s = body.size;
    dGeomSetBody(body.form == Form::ball ? dCreateSphere(space_, body.radius())
                                         : dCreateBox(space_, s.x(), s.y(), s.z()),
                 made);
    bodies_.push_back(made);
  }

  static void touch(void* self, dGeomID a, dGeomID b) {
    static_cast<World*>(self)->add_contacts(a, b);
  }
  void add_contacts(dGeomID a, dGeomID b) {
    constexpr int most = 8;
    std::array<dContact, most> found{};
    const int count = dCollide(a, b, most, &found[0].geom, sizeof(dContact));
    for (int i = 0; i < count; ++i) {
      dContact& contact = found[static_cast<std::size_t>(i)];
      contact.surface.mode = dContactBounce | dContactApprox1;
      contact.surface.mu = scene_.mu;
      contact.surface.bounce = scene_.e;
      contact.surface.bounce_vel = 0;
      dJointAttach(dJointCreateContact(world_, contacts_, &contact), dGeomGetBody(a),
                   dGeomGetBody(b));
    }
  }

  Scene scene_;
  double h_;
  Step step_;
  dWorldID world_ = dWorldCreate();
  dSpaceID space_ = dSweepAndPruneSpaceCreate(nullptr, dSAP_AXES_XYZ);
  dJointGroupID contacts_ = dJointGroupCreate(0);
  std::vector<dBodyID> bodies_;
};

Stepper stepper(const std::string& name, Step step) {
  return {"ODE", name, [step](const Scene& scene, double h) {
            return std::make_unique<Fresh<World>>(
                [scene, h, step] { return std::make_unique<World>(scene, h, step); });
          }};
}

}  // namespace
}  // namespace tumble::bench

extern "C" void tumble_add_peer(std::vector<tumble::bench::Stepper>& steppers) {
  dInitODE2(0);
  steppers.push_back(tumble::bench::stepper("step", dWorldStep));
  steppers.push_back(tumble::bench::stepper("quickstep", dWorldQuickStep));
}
