#pragma once
/// @file
/// Balls on a table without friction, in double-doubles: which of them collide, in their order.
/// Written on its own; each next collision is sought among all pairs.

#include "project/bench/contact/contest.hpp"

namespace tumble::bench {

/// Two balls; or a ball and a wall: then `other` is −1 less the number of the wall.
struct Collision {
  int ball, other;
  friend bool operator==(const Collision&, const Collision&) = default;
};

/// All collisions of equal balls with e = 1 and without gravity.
/// @param nudge of the first ball's velocity, relative: to see how far the digits reach
std::vector<Collision> billiards(const Scene& scene, double duration, double nudge = 0);

}  // namespace tumble::bench
