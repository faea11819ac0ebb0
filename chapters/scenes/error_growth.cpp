#include "scenes/error_growth.hpp"

#include <algorithm>
#include <cmath>

#include "tumble/contact/simulate_contacts.hpp"
#include "tumble/quaternion/exp_log.hpp"

namespace tumble::scenes {
namespace {

constexpr double start_difference = 1e-9;

/// A body whose centre moves a billionth differently, and which turns a billionth differently.
contact::ContactBody disturbed(contact::ContactBody body, const Vec3& gravity) {
  const Derived<> now = derived(body.body, body.start);
  const double reach = body.shape.reach();
  const double speed = now.v.norm() + reach * now.omega.norm() + std::sqrt(gravity.norm() * reach);
  const Vec3 by = start_difference * speed * Vec3::Ones().normalized();
  body.start = state_of_motion<double>(body.body, body.start.x, body.start.q, now.v + by,
                                       now.omega + by / reach);
  return body;
}

}  // namespace

ErrorGrowth error_growth(const Contacts& contacts) {
  contact::ContactScene scene = contacts.scene;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    if (i % 2 == 0) scene.bodies[i] = disturbed(scene.bodies[i], scene.gravity);
  const contact::ContactRun second = simulate_contacts(scene, contacts.settings);
  const double t = std::min(contacts.run.t, second.t);
  ErrorGrowth growth{start_difference, 0, 0};
  for (int i = 0; i < static_cast<int>(scene.bodies.size()); ++i) {
    const RigidBodyState<> a = contacts.run.state(contacts.scene, i, t);
    const RigidBodyState<> b = second.state(scene, i, t);
    growth.distance = std::max(growth.distance, (a.x - b.x).norm());
    growth.angle = std::max(growth.angle, angle_between(a.q, b.q));
  }
  return growth;
}

}  // namespace tumble::scenes
