#pragma once
/// @file
/// The gap between two bodies in flight, or a body and a wall, and bounds on how it changes.

#include "tumble/collide/contact_points.hpp"
#include "tumble/collide/motion.hpp"
#include "tumble/collide/turning_planes.hpp"

namespace tumble::collide::detail {

/// A gap over time: value + rate s + acceleration s²/2.
struct GapOfBalls {
  double value, rate, acceleration;
};

/// Two bodies at one time.
template <Motion A, Motion B>
class TwoBodies {
 public:
  TwoBodies(const Moving<A>& a, const Moving<B>& b) : a_(a), b_(b) {}

  Distance look(double t) {
    now_a_ = a_.motion.at(t);
    now_b_ = b_.motion.at(t);
    return collide::distance(a_.body, pose_of(now_a_), b_.body, pose_of(now_b_));
  }
  /// The gap along n between the points that are nearest at the time s from now.
  Reach gap_along(const Vec3& n, double s) const {
    return gap_between(a_.body, now_a_, b_.body, now_b_, n, s);
  }
  /// The same between planes that turn with what touches them.
  TurningPlanes<A, B> turning_planes(const Vec3& n) const { return {a_, now_a_, b_, now_b_, n}; }
  /// The same of the balls around the centres that hold them.
  GapOfBalls balls_along(const Vec3& n) const {
    return {n.dot(now_b_.x - now_a_.x) - a_.body.reach() - b_.body.reach(),
            n.dot(now_b_.v - now_a_.v), n.dot(b_.motion.acceleration() - a_.motion.acceleration())};
  }
  /// Bound from below on the acceleration of any such gap within a time.
  double acceleration(const Vec3& n, double within) const {
    return n.dot(b_.motion.acceleration() - a_.motion.acceleration()) -
           turning_along(a_, now_a_, n, within) - turning_along(b_, now_b_, n, within);
  }
  /// Bound on how fast a point of one comes to a point of the other within a time.
  double speed(double within) const {
    const Vec3 faster = within * (b_.motion.acceleration() - a_.motion.acceleration());
    return (now_b_.v - now_a_.v).norm() + faster.norm() + a_.body.reach() * a_.motion.most_spin() +
           b_.body.reach() * b_.motion.most_spin();
  }
  ContactPoints touching(const Distance& found, double tolerance) const {
    return contact_points(a_.body, pose_of(now_a_), b_.body, pose_of(now_b_), found, tolerance);
  }
  /// The velocity of b's point less that of a's.
  Vec3 parting(const Vec3& arm) const {
    const Vec3 arm_b = arm - (now_b_.x - now_a_.x);
    return now_b_.v + now_b_.omega.cross(arm_b) - now_a_.v - now_a_.omega.cross(arm);
  }

 private:
  Moving<A> a_;
  Moving<B> b_;
  Derived<> now_a_{}, now_b_{};
};

/// A body and a wall at one time.
template <Motion A>
class BodyAndWall {
 public:
  BodyAndWall(const Moving<A>& a, const HalfSpace& wall) : a_(a), wall_(wall) {}

  Distance look(double t) {
    now_ = a_.motion.at(t);
    return collide::distance(a_.body, pose_of(now_), wall_);
  }
  Reach gap_along(const Vec3& n, double s) const {
    const Reach a = farthest_reach(a_.body, now_, n, s);
    return {n.dot(wall_.point - now_.x) - a.value, -a.rate};
  }
  GapOfBalls balls_along(const Vec3& n) const {
    return {n.dot(wall_.point - now_.x) - a_.body.reach(), -n.dot(now_.v),
            -n.dot(a_.motion.acceleration())};
  }
  double acceleration(const Vec3& n, double within) const {
    return -n.dot(a_.motion.acceleration()) - turning_along(a_, now_, n, within);
  }
  double speed(double within) const {
    return now_.v.norm() + within * a_.motion.acceleration().norm() +
           a_.body.reach() * a_.motion.most_spin();
  }
  ContactPoints touching(const Distance& found, double tolerance) const {
    return contact_points(a_.body, pose_of(now_), found, tolerance);
  }
  Vec3 parting(const Vec3& arm) const { return -(now_.v + now_.omega.cross(arm)); }

 private:
  Moving<A> a_;
  HalfSpace wall_;
  Derived<> now_{};
};

}  // namespace tumble::collide::detail
