#pragma once
/// @file
/// The impulses of a contact that touches at several points, as a face on a floor does.
///
/// One rule: the points that come together act as one, at their mean, where each counts by how fast
/// it comes. That is repeated as long as any comes. So a cube that lands flat leaves flat, no
/// energy is created, and a single point is what it was. Real bodies decide by how they deform,
/// which rigid ones do not know.

#include <algorithm>
#include <vector>

#include "tumble/collide/contact_points.hpp"
#include "tumble/contact/contact_matrix.hpp"
#include "tumble/contact/friction_impulse.hpp"

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

inline MeanPoint mean_of_coming(const Touching& touching, const collide::ContactPoints& points,
                                const Vec3& normal) {
  MeanPoint mean;
  double sum = 0;
  for (const Vec3& arm : points) {
    const double coming = std::max(0., -normal.dot(touching.velocity(arm)));
    mean.arm += coming * arm;
    sum += coming;
    mean.fastest = std::max(mean.fastest, coming);
  }
  if (sum > 0) mean.arm /= sum;
  return mean;
}

}  // namespace tumble::contact::detail

namespace tumble::contact {

/// @addtogroup contact
/// @{

/// Changes the momenta of a body, and of the other one if it is no wall, by the impulses of a
/// contact.
/// @param b      the second body, or nullptr for a wall
/// @param points from the centre of the first body, in world axes [m]
/// @return the impulses, in turn; none if no point comes together
inline std::vector<PointImpulse> collide_at_points(Colliding& a, Colliding* b,
                                                   const collide::ContactPoints& points,
                                                   const Surface& surface) {
  constexpr int max_impulses = 100;
  constexpr double nothing = 1e-12;  // of the speed at which the first point comes
  detail::Touching touching(a, b);
  std::vector<PointImpulse> impulses;
  double first = 0;
  for (int i = 0; i < max_impulses; ++i) {
    const auto mean = detail::mean_of_coming(touching, points, surface.normal);
    if (mean.fastest <= nothing * first) break;
    first = std::max(first, mean.fastest);
    const ImpactResult result = collide_with_friction(
        {touching.K(mean.arm), touching.velocity(mean.arm), surface.normal, surface.e, surface.mu});
    touching.push(result.impulse, mean.arm);
    impulses.push_back({mean.arm, result});
  }
  return impulses;
}

/// The least speed at which one of the points parts [m/s]; below 0 where one comes together.
inline double least_parting(Colliding& a, Colliding* b, const collide::ContactPoints& points,
                            const Vec3& normal) {
  const detail::Touching touching(a, b);
  double least = std::numeric_limits<double>::infinity();
  for (const Vec3& arm : points) least = std::min(least, normal.dot(touching.velocity(arm)));
  return least;
}

/// @}

}  // namespace tumble::contact
