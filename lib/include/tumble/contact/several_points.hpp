#pragma once
/// @file
/// The impulses of a contact that touches at several points, as a face on a floor does.
///
/// One rule: the points that come together act as one, at their mean, where each counts by how fast
/// it comes. That is repeated as long as any comes. So a cube that lands flat leaves flat, no
/// energy is created, and a single point is what it was. Real bodies decide by how they deform,
/// which rigid ones do not know.

#include <vector>

#include "tumble/collide/contact_points.hpp"
#include "tumble/contact/contact_matrix.hpp"
#include "tumble/contact/impact.hpp"

namespace tumble::contact {

/// @addtogroup contact
/// @{

/// A body in a contact.
struct Colliding {
  const RigidBody<>& body;
  RigidBodyState<> state;
};

/// What one impulse of a contact did.
struct PointImpulse {
  Vec3 arm;  ///< where, from the centre of the first body, in world axes [m]
  ImpactResult result;
};

/// How a contact rubs and bounces.
struct Surface {
  Vec3 normal;  ///< unit, out of the second body
  double e;     ///< coefficient of restitution
  double mu;    ///< coefficient of friction
};

/// @}

}  // namespace tumble::contact

namespace tumble::contact::detail {

/// A body and the other one, or a wall that nothing moves.
class Touching {
 public:
  Touching(Colliding& a, Colliding* b) : a_(a), b_(b) {}

  /// Velocity of the first body's point less that of the second one's.
  Vec3 velocity(const Vec3& arm) const {
    return velocity_of(a_, arm) - (b_ ? velocity_of(*b_, from_b(arm)) : Vec3(Vec3::Zero()));
  }
  Mat3 K(const Vec3& arm) const {
    return matrix_of(a_, arm) + (b_ ? matrix_of(*b_, from_b(arm)) : Mat3(Mat3::Zero()));
  }
  void push(const Vec3& impulse, const Vec3& arm) {
    push(a_.state, impulse, arm);
    if (b_) push(b_->state, -impulse, from_b(arm));
  }

 private:
  Vec3 from_b(const Vec3& arm) const { return arm - (b_->state.x - a_.state.x); }

  static Vec3 velocity_of(const Colliding& c, const Vec3& arm) {
    const Derived<> now = derived(c.body, c.state);
    return now.v + now.omega.cross(arm);
  }
  /// About the centre, so that no digit is lost far away from the origin.
  static Mat3 matrix_of(const Colliding& c, const Vec3& arm) {
    Derived<> now = derived(c.body, c.state);
    now.x = Vec3::Zero();
    return contact_matrix(c.body, now, arm);
  }
  static void push(RigidBodyState<>& state, const Vec3& impulse, const Vec3& arm) {
    state.P += impulse;
    state.L += arm.cross(impulse);
  }

  Colliding& a_;
  Colliding* b_;
};

/// The mean of the points that come together, each counted by how fast it comes.
struct MeanPoint {
  Vec3 arm = Vec3::Zero();
  double fastest = 0;  ///< speed at which a point comes [m/s]
};

MeanPoint mean_of_coming(const Touching& touching, const collide::ContactPoints& points,
                         const Vec3& normal);

}  // namespace tumble::contact::detail

namespace tumble::contact {

/// @addtogroup contact
/// @{

/// Changes the momenta of a body, and of the other one if it is no wall, by the impulses of a
/// contact.
/// @param b      the second body, or nullptr for a wall
/// @param points from the centre of the first body, in world axes [m]
/// @return the impulses, in turn; none if no point comes together
std::vector<PointImpulse> collide_at_points(Colliding& a, Colliding* b,
                                            const collide::ContactPoints& points,
                                            const Surface& surface);

/// The least speed at which one of the points parts [m/s]; below 0 where one comes together.
double least_parting(Colliding& a, Colliding* b, const collide::ContactPoints& points,
                     const Vec3& normal);

/// @}

}  // namespace tumble::contact

#ifndef TUMBLE_COMPILED
#include "tumble/contact/several_points.inl"
#endif
