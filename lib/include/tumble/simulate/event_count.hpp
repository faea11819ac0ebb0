#pragma once
/// @file
/// Events that come to no end.

#include "tumble/core/require.hpp"

namespace tumble::detail {

/// Notices events that follow each other ever faster, whose times come to an end before the motion
/// does: with rounding the last ones would not be seen, and the motion go on as if they weren't.
class EventCount {
 public:
  explicit EventCount(double span) : shortest_(1e-7 * span) {}

  /// @param gap the time since the last event, or since the start
  /// @throws std::runtime_error if there is no end of events
  void count(double t, double gap) {
    constexpr int many = 100'000, in_a_row = 10;
    shorter_ = gap < last_gap_ ? shorter_ + 1 : 0;
    last_gap_ = gap;
    if (++count_ < many && (gap > shortest_ || shorter_ < in_a_row) && gap > 0) return;
    throw_error<std::runtime_error>("simulate_changes: ", count_, " events until t = ", t,
                                    ", each sooner after the other, and no end of them; let the "
                                    "change return nothing to end the motion");
  }

 private:
  double shortest_, last_gap_ = 0;
  int count_ = 0, shorter_ = 0;
};

}  // namespace tumble::detail
