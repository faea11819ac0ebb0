#pragma once
/// @file
/// When two bodies in flight, or a body and a wall, first meet.
///
/// Conservative advancement along the normal of the planes between them. Along a fixed direction
/// every point's place is known up to its acceleration, and that is bounded: so is the time before
/// which no point of one can reach a point of the other. The bound is quadratic in time, as the
/// flight is: a ball meets a wall in one step, other bodies converge quadratically.

#include "tumble/collide/contact_points.hpp"
#include "tumble/collide/first_contact.hpp"
#include "tumble/collide/motion.hpp"

namespace tumble::collide {

/// @addtogroup collide
/// @{

/// When two bodies first meet, and how they are to each other then.
struct Meeting {
  bool found = false;         ///< whether they meet at all
  double t = 0;               ///< when; otherwise the end of the search [s]
  Distance distance{};        ///< then
  ContactPoints points = {};  ///< where they touch; empty if they don't
  int queries = 0;            ///< distances that it took
};

/// @}

}  // namespace tumble::collide

namespace tumble::collide::detail {

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
    const Reach a = farthest_reach(a_.body, now_a_, n, s);
    const Reach b = farthest_reach(b_.body, now_b_, -n, s);
    return {n.dot(now_b_.x - now_a_.x) - a.value - b.value, -a.rate - b.rate};
  }
  /// Bound from below on the acceleration of any such gap.
  double acceleration(const Vec3& n) const {
    return n.dot(b_.motion.acceleration() - a_.motion.acceleration()) - turning_of(a_) -
           turning_of(b_);
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
  double acceleration(const Vec3& n) const {
    return -n.dot(a_.motion.acceleration()) - turning_of(a_);
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

/// How long, up to `most`, the planes with the normal n keep two things apart for sure. The gap is
/// the least one of pairs of points. Each pair's bound is a parabola, so the first zero of the one
/// that is lowest at some time is a better time, until none is lower there.
template <class Things>
double time_apart(const Things& things, const Vec3& n, double most) {
  const double a = std::fmin(0, things.acceleration(n));
  double s = most;
  while (s > 0) {
    const Reach lowest = things.gap_along(n, s);
    if (lowest.value + s * (lowest.rate + s / 2 * a) >= 0) return s;
    const double zero = landing_time(lowest.value, lowest.rate, a);
    if (!(zero < s)) return s;
    s = zero;
  }
  return 0;
}

/// The search, for two bodies or a body and a wall.
template <class Things>
Meeting first_meeting_of(Things things, double t0, double t1, double tolerance) {
  require(tolerance > 0, "first_meeting: the tolerance ", tolerance, " m is not positive");
  require(t0 <= t1 && std::isfinite(t1 - t0), "first_meeting: from t0 = ", t0, " to t1 = ", t1,
          " is no span");
  Meeting meeting;
  meeting.t = t0;
  while (true) {
    meeting.distance = things.look(meeting.t);
    ++meeting.queries;
    const Vec3& n = meeting.distance.normal;
    if (meeting.distance.gap <= tolerance) {
      meeting.points = things.touching(meeting.distance, tolerance);
      for (const Vec3& arm : meeting.points)
        if (n.dot(things.parting(arm)) < 0) meeting.found = true;
      if (meeting.found) return meeting;
      meeting.points.clear();
    }
    if (meeting.t >= t1) return meeting;
    // In this time nothing moves by more than a quarter of the tolerance.
    const double left = t1 - meeting.t, still = tolerance / (4 * things.speed(left));
    const double next = meeting.t + std::fmax(still, time_apart(things, n, left));
    meeting.t = std::fmin(t1, std::fmax(next, std::nextafter(meeting.t, t1)));
  }
}

}  // namespace tumble::collide::detail

namespace tumble::collide {

/// @addtogroup collide
/// @{

/// The first time at which two bodies are no farther apart than the tolerance, and come together at
/// one of the points where they touch. Before it they overlap nowhere by more than the tolerance,
/// however fast they are. Bodies that touch and part do not meet.
/// @param t0, t1    from when to when [s]
/// @param tolerance [m], positive
/// @throws std::invalid_argument if t1 < t0 or the tolerance is not positive
template <Motion A, Motion B>
Meeting first_meeting(const Moving<A>& a, const Moving<B>& b, double t0, double t1,
                      double tolerance) {
  return detail::first_meeting_of(detail::TwoBodies<A, B>(a, b), t0, t1, tolerance);
}

/// The same for a body and a floor or a wall.
template <Motion A>
Meeting first_meeting(const Moving<A>& a, const HalfSpace& wall, double t0, double t1,
                      double tolerance) {
  return detail::first_meeting_of(detail::BodyAndWall<A>(a, wall), t0, t1, tolerance);
}

/// @}

}  // namespace tumble::collide
