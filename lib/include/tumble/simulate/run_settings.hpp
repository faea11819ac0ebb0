#pragma once
/// @file
/// How a run under any forces goes from one end of the span to the other.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "tumble/core/rounding.hpp"

namespace tumble::detail {

/// That a run takes.
inline constexpr double most_steps = 1e6;

/// Whether a run's start and times are some roundings beside the given ones, and on which side.
enum class Side { other = -1, none, one };

/// How the times at which a run asks the forces differ from the given ones, to see what their
/// rounding does.
struct AskedTimes {
  double late = 0;    ///< [s]
  double coarse = 0;  ///< a number so large that a sum with it has the digits that are left [s]

  /// @param t the latest in size [s]
  static AskedTimes beside(Side side, double t) {
    if (side == Side::none) return {};
    // Both sides round otherwise than the given moments do, and than each other.
    const double digits = side == Side::one ? 0x1.8p54 : 0x1.8p53;
    return {.late = static_cast<int>(side) * 4 * unit_roundoff * t,
            .coarse = digits * (std::nextafter(t, 2 * t) - t)};
  }
};

/// How a run goes from one end of the span to the other.
struct RunSettings {
  double tolerance;                ///< of a step
  double longest;                  ///< step [s]
  std::vector<double> breaks;      ///< times after t0 that no step goes across, ascending [s]
  std::vector<double> guide = {};  ///< the ends of another run's steps, see StepGuide
  Side side = Side::none;
  bool stiff = false;    ///< by Radau5
  bool watched = false;  ///< whether to stop where the scene turns out to be stiff
  double max_steps = most_steps;
};

/// Why a run ended.
enum class RunEnd { complete, stiff, too_many_steps };

/// Steps at most a few times as long as another run's there: what one run has gone into, no other
/// jumps over.
class StepGuide {
 public:
  /// @param ends of the other run's steps, ascending; none or one guides nothing
  explicit StepGuide(std::vector<double> ends) : ends_(std::move(ends)) {}

  /// @param s where it is, never before where it was
  /// @param h how far it would go
  double longest(double s, double h) {
    constexpr double few = 4;
    while (at_ + 2 < ends_.size() && ends_[at_ + 1] <= s) ++at_;
    for (std::size_t i = at_; i + 1 < ends_.size() && ends_[i] < s + h; ++i)
      h = std::min(h, std::max(0.0, ends_[i] - s) + few * (ends_[i + 1] - ends_[i]));
    return h;
  }

 private:
  std::vector<double> ends_;
  std::size_t at_ = 0;
};

}  // namespace tumble::detail
