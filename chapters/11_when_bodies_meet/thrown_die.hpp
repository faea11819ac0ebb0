#pragma once
/// @file
/// A die that is thrown on the floor: each flight is a formula, and each contact an impulse at a
/// corner.

#include <algorithm>
#include <limits>

#include "common.hpp"
#include "tumble/free_body.hpp"

namespace contact_chapter {

/// A solid cube over the floor z = 0, from contact to contact.
class ThrownDie {
 public:
  static constexpr double edge = 0.016, e = 0.85, mu = 0.1;  ///< [m]

  ThrownDie() : body_(mass, Mat3(mass * edge * edge / 6 * Mat3::Identity())) {
    now_ = state_of_motion<double>(body_, {0, 0, 0.09}, Quat(0.9, 0.3, 0.2, 0.25).normalized(),
                                   {0.45, 0, 0}, {10, 30, 4});
    start_ = energy_left();
  }

  const RigidBodyState<>& now() const { return now_; }
  int contacts() const { return contacts_; }

  /// Flies on by t [s], through all contacts on the way, until nothing worth drawing is left.
  void advance(double t) {
    for (double flown = 0; t > 0 && energy_left() > 2e-3 * start_; t -= flown) {
      flown = until_contact(t);
      now_ = in_flight(FreeTrajectory(body_, now_), flown);
      hit();
    }
  }

 private:
  static constexpr double mass = 0.005, touching = 1e-6;  // [kg], [m]

  static Vec3 corner(int i) {
    return edge / 2 * Vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
  }

  /// The weight bends the path of the centre, and doesn't turn the die.
  static RigidBodyState<> in_flight(const FreeTrajectory& free, double t) {
    RigidBodyState<> state = free.at(t);
    state.x.z() -= gravity * t * t / 2;
    state.P.z() -= mass * gravity * t;
    return state;
  }

  static double gap_of(const RigidBodyState<>& state) {
    double lowest = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 8; ++i) lowest = std::min(lowest, (state.x + state.q * corner(i)).z());
    return lowest;
  }

  Vec3 velocity_of_corner(const Derived<>& motion, int i) const {
    return point_velocity<double>(motion, corner(i));
  }

  bool lands(const RigidBodyState<>& state) const {
    const Derived<> motion = derived(body_, state);
    for (int i = 0; i < 8; ++i)
      if (point_position<double>(motion, corner(i)).z() <= touching &&
          velocity_of_corner(motion, i).z() < 0)
        return true;
    return false;
  }

  /// Conservative advancement to the next contact, or to `most`.
  double until_contact(double most) const {
    const FreeTrajectory free(body_, now_);
    const Derived<> start = derived(body_, now_);
    const double speed =
        start.v.norm() + gravity * most + start.omega.norm() * edge * std::sqrt(0.75);
    double t = 0;
    while (t < most) {
      const RigidBodyState<> state = in_flight(free, t);
      if (lands(state)) return t;
      t += std::max(gap_of(state), touching) / speed;
    }
    return most;
  }

  /// Impulses at the corners that touch and come down, one after the other.
  void hit() {
    for (int i = 0; i < 8; ++i) {
      const Derived<> motion = derived(body_, now_);
      const Vec3 point = point_position<double>(motion, corner(i)),
                 u = velocity_of_corner(motion, i);
      if (point.z() > touching || u.z() >= 0) continue;
      const Mat3 K = contact::contact_matrix(body_, motion, point);
      const Vec3 j = contact::collide_with_friction({K, u, Vec3::UnitZ(), e, mu}).impulse;
      now_ = contact::after_impulse(now_, j, point);
      ++contacts_;
    }
  }

  /// Above that of a die that lies on a face [J].
  double energy_left() const {
    return kinetic_energy(body_, now_) + mass * gravity * (now_.x.z() - edge / 2);
  }

  RigidBody<> body_;
  RigidBodyState<> now_;
  double start_;
  int contacts_ = 0;
};

}  // namespace contact_chapter
