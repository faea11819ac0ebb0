#pragma once
/// @file
/// What a course costs: measured on one and on two cores, computed from that for more of them.

#include "support/table.hpp"

namespace tumble::bench {

/// What some students of a class have cost.
struct MeasuredCost {
  std::size_t students = 0;
  double one_core = 0;   ///< [s] of wall time, for all of them
  double two_cores = 0;  ///< the same on two
  double processor = 0;  ///< [s] on one core

  /// What two cores do, beside twice what one does.
  double share_of_two() const { return one_core / (2 * two_cores); }
};

/// Wall time by students and cores. One core and two: what was measured, per student. More: as if
/// each core worked as those two did beside each other, and shards were of equal size.
support::Table cost_by_cores(const MeasuredCost& measured);

}  // namespace tumble::bench
