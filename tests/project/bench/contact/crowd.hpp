#pragma once
/// @file
/// A crowd of balls in a room: what a collision costs, and how that grows with the crowd.

#include "project/bench/contact/contest.hpp"
#include "project/bench/speed_against_error.hpp"
#include "support/table.hpp"

namespace tumble::bench {

struct Crowd {
  support::Table table;
  std::string growth;  ///< of the cost of a collision, in words
  std::string broken;  ///< what of ours is not as we promise; empty if all is
};

/// Balls that fill 15 % of a room, e = 1, for each of the sizes: ours takes all collisions in
/// order, the others steps in which a ball goes a tenth of its radius.
Crowd crowd(const std::vector<int>& sizes, const std::vector<Stepper>& steppers,
            const Budget& budget);

}  // namespace tumble::bench
