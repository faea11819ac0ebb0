#pragma once
/// @file
/// Planes between two bodies in flight that turn with what touches them.
///
/// Where an edge slides on an edge, a plane that stands still is soon passed by the far end of an
/// edge that turns, though nothing is there that it could meet: what is known of the gap is lost in
/// a time of gap/speed. In a plane that turns so that both edges stay in it, nothing of them moves,
/// and the bound lasts for a time of √(gap/acceleration).
///
/// In a frame that turns with the constant Ω, Ω·n = 0, the normal n stands still. With y from one
/// centre to the other, V a bound on |ẏ|, and w = ω − Ω of a body, accelerations there are
///
///     of y:           a − 2 Ω × u − Ω × (Ω × y),  u = ẏ − Ω × y
///     of an arm r:    w × (w × r) + (ω̇ − Ω × w) × r
///
/// so that along n the first is at least −|a| − |Ω| (2 V + 3 |Ω| |y|), and the second at least
/// −(w₊ |w| + |ω̇| + |Ω| |w|) |r|, with w₊ the part of w across n (see turning_along()).

#include <algorithm>

#include "tumble/collide/motion.hpp"
#include "tumble/ode/linear_solver.hpp"

namespace tumble::collide::detail {

/// Two bodies at one time, seen from a frame that turns about the first one's centre.
template <Motion A, Motion B>
class TurningPlanes {
 public:
  /// @param n of a plane between them, from a to b
  TurningPlanes(const Moving<A>& a, const Derived<>& now_a, const Moving<B>& b,
                const Derived<>& now_b, const Vec3& n)
      : a_(a), b_(b), seen_a_(now_a), seen_b_(now_b), velocity_(now_b.v - now_a.v) {
    Mat3 sum = Mat3::Zero();
    Vec3 right = Vec3::Zero();
    add_edges(a.body, now_a, n, sum, right);
    add_edges(b.body, now_b, -n, sum, right);
    if (sum.isZero(0)) return;
    // Where the edges leave a part of Ω open, it is 0.
    sum += sum.trace() * (1e-12 * Mat3::Identity() + n * n.transpose());
    turning_ = tumble::detail::SmallLu<Mat3>(sum).solve(right);
    turning_ -= n.dot(turning_) * n;
    seen_a_.omega -= turning_;
    seen_b_.omega -= turning_;
    seen_b_.v -= turning_.cross(now_b.x - now_a.x);
  }

  /// As of TwoBodies.
  Reach gap_along(const Vec3& n, double s) const {
    return gap_between(a_.body, seen_a_, b_.body, seen_b_, n, s);
  }
  double acceleration(const Vec3& n, double within) const {
    const Vec3 pull = b_.motion.acceleration() - a_.motion.acceleration();
    const double turning = turning_.norm(), speed = velocity_.norm() + pull.norm() * within,
                 apart = (seen_b_.x - seen_a_.x).norm() + speed * within;
    return -pull.norm() - turning * (2 * speed + 3 * turning * apart) -
           turning_seen(a_, seen_a_, n, within) - turning_seen(b_, seen_b_, n, within);
  }

 private:
  /// Ω moves no point of an edge e along n: (ω − Ω)·(e × n) = 0, the longer the more it counts.
  static void add_edges(const Convex& body, const Derived<>& now, const Vec3& n, Mat3& sum,
                        Vec3& right) {
    const Vec3 along = now.R.transpose() * n;
    const std::vector<Vec3>& points = body.points();
    const Vec3& first = points[static_cast<std::size_t>(body.farthest(along))];
    const double in_plane = along.dot(first) - 1e-6 * body.reach();
    for (const Vec3& p : points) {
      if (along.dot(p) < in_plane) continue;
      const Vec3 across = (now.R * (p - first)).cross(n);
      sum += across * across.transpose();
      right += across.dot(now.omega) * across;
    }
  }

  /// turning_along() of what is seen.
  template <Motion M>
  double turning_seen(const Moving<M>& moving, const Derived<>& seen, const Vec3& n,
                      double within) const {
    const double faster = moving.motion.most_angular_acceleration(), turning = turning_.norm();
    constexpr double rounding = 16 * tumble::detail::unit_roundoff;  // of ω and Ω
    const double lost = rounding * (moving.motion.most_spin() + turning);
    const double spin = seen.omega.norm() + faster * within + lost;
    const double changes = faster + turning * spin;
    const double across = std::fmin(spin, n.cross(seen.omega).norm() + changes * within + lost);
    return (moving.body.reach() - moving.body.radius()) * (across * spin + changes);
  }

  Moving<A> a_;
  Moving<B> b_;
  Derived<> seen_a_, seen_b_;
  Vec3 velocity_;
  Vec3 turning_ = Vec3::Zero();  ///< Ω [rad/s]
};

}  // namespace tumble::collide::detail
