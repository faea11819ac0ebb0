#pragma once
/// @file
/// A ball that spins and jumps on a floor, in a plane.

#include <algorithm>

#include "common.hpp"
#include "laws.hpp"

namespace contact_chapter {

/// A ball over a floor in the plane of x and z, with its spin about y.
struct SpinningBall {
  Vec2 x, v;     ///< of its centre [m], [m/s]
  double omega;  ///< [rad/s]; positive rolls to the right
};

constexpr double ball_radius = 0.04;

/// Along the floor, of the ball's lowest point.
inline double slip_of(const SpinningBall& ball) { return ball.v.x() - ball_radius * ball.omega; }

inline SpinningBall in_flight(const SpinningBall& ball, double t) {
  const Vec2 fallen(0, gravity * t * t / 2);
  return {ball.x + t * ball.v - fallen, ball.v - Vec2(0, gravity * t), ball.omega};
}

/// Until its lowest point is on the floor.
inline double flight_time(const SpinningBall& ball) {
  const double above = ball.x.y() - ball_radius, v = ball.v.y();
  return (v + std::sqrt(v * v + 2 * gravity * std::max(0., above))) / gravity;
}

/// After a contact with the floor. For 1 kg: 1/m + r²/I = 7/2 along the floor.
inline SpinningBall after_floor(SpinningBall ball, double e, double mu) {
  const Mat2 K = Vec2(3.5, 1).asDiagonal();
  const Vec2 j = stronge_law({K, {slip_of(ball), ball.v.y()}, e, mu}).impulse;
  ball.v += j;
  ball.omega -= j.x() / (0.4 * ball_radius);
  return ball;
}

}  // namespace contact_chapter
