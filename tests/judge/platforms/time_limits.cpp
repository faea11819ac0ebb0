#include "judge/platforms/time_limits.hpp"

#include "tumble/core/require.hpp"

namespace tumble::judge {

TimeLimits time_limits(int usual, int most, const std::optional<int>& wanted) {
  constexpr int least = most_for_what_has_begun + 30;
  const int limit = wanted.value_or(usual);
  require(limit >= least && limit <= most, "the limit is ", limit, " s: it must be at least ",
          least, " s, which one exercise may need, and at most ", most, " s");
  return {limit - most_for_what_has_begun, limit};
}

}  // namespace tumble::judge
