#pragma once
/// @file
/// When two bodies in flight, or a body and a wall, first meet.
///
/// Conservative advancement along the normal of the planes between them. Along a fixed direction
/// every point's place is known up to its acceleration, and that is bounded: so is the time before
/// which no point of one can reach a point of the other. The bound is quadratic in time, as the
/// flight is: a ball meets a wall in one step, other bodies converge quadratically.

#include <limits>

#include "tumble/collide/first_contact.hpp"
#include "tumble/collide/moving_gap.hpp"

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

/// How long, up to `most`, the planes with the normal n keep two things apart for sure. The gap is
/// the least one of pairs of points. Each pair's bound is a parabola, so the first zero of the one
/// that is lowest at some time is a better time, until none is lower there.
template <class Things>
double time_apart(const Things& things, const Vec3& n, double most) {
  const double a = std::fmin(0, things.acceleration(n, most));
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

/// How long they keep the balls around the bodies apart, which may turn as they like.
template <class Things>
double time_balls_apart(const Things& things, const Vec3& n) {
  const GapOfBalls gap = things.balls_along(n);
  return gap.value > 0 ? landing_time(gap.value, gap.rate, gap.acceleration) : 0;
}

/// Whether bodies that neither meet nor part stay in touch, as two that spin on each other: what
/// parts at a fraction f of the fastest point's speed takes some 4/f looks to leave the tolerance.
bool stay_in_touch(int looks, double parting, double speed);

/// After so many looks, planes that turn are tried, too.
inline constexpr int many_looks = 100;

/// Where a search has been left. The rest is in its meeting: before that time they do not meet.
struct SearchState {
  int touching = 0;  ///< looks in turn at bodies that touch
  bool is_over = false;
};

/// One look at two bodies, or a body and a wall: they meet, or cannot meet before a later time.
template <class Things>
void look_once(Things& things, double t1, double tolerance, Meeting& meeting, SearchState& search) {
  meeting.distance = things.look(meeting.t);
  ++meeting.queries;
  const Vec3& n = meeting.distance.normal;
  search.touching = meeting.distance.gap <= tolerance ? search.touching + 1 : 0;
  if (search.touching > 0) {
    meeting.points = things.touching(meeting.distance, tolerance);
    double parting = std::numeric_limits<double>::infinity();  // of the slowest point
    for (const Vec3& arm : meeting.points) parting = std::fmin(parting, n.dot(things.parting(arm)));
    meeting.found =
        parting < 0 || stay_in_touch(search.touching, parting, things.speed(t1 - meeting.t));
    if (!meeting.found) meeting.points.clear();
  }
  search.is_over = meeting.found || meeting.t >= t1;
  if (search.is_over) return;
  // In this time nothing moves by more than a quarter of the tolerance.
  const double left = t1 - meeting.t, still = tolerance / (4 * things.speed(left));
  double apart = std::fmax(time_balls_apart(things, n), time_apart(things, n, left));
  if constexpr (requires { things.turning_planes(n); })
    if (meeting.queries >= many_looks)
      apart = std::fmax(apart, time_apart(things.turning_planes(n), n, left));
  meeting.t =
      std::fmin(t1, std::fmax(meeting.t + std::fmax(still, apart), std::nextafter(meeting.t, t1)));
}

/// The search, for two bodies or a body and a wall.
template <class Things>
Meeting first_meeting_of(Things things, double t0, double t1, double tolerance) {
  require(tolerance > 0, "first_meeting: the tolerance ", tolerance, " m is not positive");
  require(t0 <= t1 && std::isfinite(t1 - t0), "first_meeting: from t0 = ", t0, " to t1 = ", t1,
          " is not a span of time: t1 must be finite, and not before t0");
  Meeting meeting;
  meeting.t = t0;
  for (SearchState search; !search.is_over;) look_once(things, t1, tolerance, meeting, search);
  return meeting;
}

}  // namespace tumble::collide::detail

namespace tumble::collide {

/// @addtogroup collide
/// @{

/// The first time at which two bodies are no farther apart than the tolerance, and come together at
/// one of the points where they touch. Before it they overlap nowhere by more than the tolerance,
/// however fast they are. Bodies that touch and part do not meet. Bodies that stay in touch, as two
/// that spin on each other, are said to meet after some looks: a hundred if they part at less than
/// 4e-5 of the fastest point's speed, else a hundred thousand.
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

#ifndef TUMBLE_COMPILED
#include "tumble/collide/first_meeting.inl"
#endif
