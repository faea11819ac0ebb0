#pragma once
/// @file
/// Bodies, floors and walls that can hit each other.

#include <string>
#include <vector>

#include "tumble/body/derived.hpp"
#include "tumble/collide/distance.hpp"
#include "tumble/collide/sort_and_sweep.hpp"

namespace tumble::contact {

/// @addtogroup contact
/// @{

/// A body with a shape, and how it starts.
struct ContactBody {
  std::string name;
  RigidBody<> body;
  collide::Convex shape;  ///< in body coordinates: the centre of mass is its origin
  RigidBodyState<> start;
};

/// What moves, and what it can hit.
struct ContactScene {
  std::vector<ContactBody> bodies;
  std::vector<collide::HalfSpace> walls;  ///< floors, too
  Vec3 gravity = {0, 0, -9.80665};        ///< [m/s²]
  double e = 0.5;                         ///< coefficient of restitution of every contact, 0 … 1
  double mu = 0;                          ///< coefficient of friction of every contact, ≥ 0

  const ContactBody& body(int i) const { return bodies[static_cast<std::size_t>(i)]; }
  const collide::HalfSpace& wall(int i) const { return walls[static_cast<std::size_t>(i)]; }

  /// @param tolerance by which bodies may overlap at the start [m]
  /// @throws std::invalid_argument for coefficients that are none, a wall without a normal, a state
  ///         that is not finite, and for bodies that overlap: who, and by how much
  void require_valid(double tolerance) const {
    require(e >= 0 && e <= 1, "contacts: restitution e = ", e, " is not in 0 … 1");
    require(mu >= 0 && std::isfinite(mu), "contacts: friction mu = ", mu, " is not finite and ≥ 0");
    require(gravity.allFinite(), "contacts: gravity is not finite");
    for (const collide::HalfSpace& wall : walls) wall.require_valid();
    for (const ContactBody& b : bodies)
      require(pack(b.start).allFinite() && b.start.q.squaredNorm() > 0, "contacts: the state of ",
              b.name, " is not finite, or its quaternion is shorter than 1e-162");
    require_apart(tolerance);
  }

 private:
  void require_apart(double tolerance) const {
    std::vector<collide::Bounds> bounds;
    for (const ContactBody& b : bodies) {
      for (std::size_t w = 0; w < walls.size(); ++w) {
        const double gap = distance(b.shape, pose_of_start(b), walls[w]).gap;
        require(gap >= -tolerance, "contacts: ", b.name, " overlaps wall ", w, " by ", -gap,
                " m at the start");
      }
      bounds.push_back(bounds_of(b.shape, pose_of_start(b)));
    }
    for (const auto& [i, j] : collide::overlapping_pairs(bounds)) {
      const ContactBody &a = body(i), &b = body(j);
      const double gap = distance(a.shape, pose_of_start(a), b.shape, pose_of_start(b)).gap;
      require(gap >= -tolerance, "contacts: ", a.name, " and ", b.name, " overlap by ", -gap,
              " m at the start");
    }
  }
  static collide::Pose pose_of_start(const ContactBody& b) {
    return {b.start.x, to_matrix(b.start.q)};
  }
};

/// @}

namespace detail {

/// Kinetic energy, and potential energy in the uniform gravity [J].
inline double energy_in(const Vec3& gravity, const RigidBody<>& body,
                        const RigidBodyState<>& state) {
  return kinetic_energy(body, state) - body.mass() * gravity.dot(state.x);
}

}  // namespace detail

}  // namespace tumble::contact
