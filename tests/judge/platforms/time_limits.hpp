#pragma once
/// @file
/// The time that platforms give a submission, and when the judge has to stop beginning exercises.

#include <optional>
#include <string>

namespace tumble::judge {

/// What has begun is finished after this long, whatever it is [s]: a compiler and a linker that run
/// into their walls, and two cases that never answer; or the curves of an engine.
inline constexpr int most_for_what_has_begun = 120;

/// When to begin no more, and when the platform ends everything [s].
struct TimeLimits {
  int deadline, limit;
};

/// @param usual  the platform's limit if nobody has changed it
/// @param most   the longest that it can be set to
/// @param wanted the one that was set
/// @throws std::invalid_argument if it is too short to judge anything, or longer than that
TimeLimits time_limits(int usual, int most, const std::optional<int>& wanted);

}  // namespace tumble::judge
