#pragma once
/// @file
/// Which of many steps a moment is in.

#include <algorithm>
#include <cstddef>
#include <vector>

namespace tumble::detail {

/// The i for which t is from steps[i] to steps[i + 1]: near where it would be if all were alike.
/// @param steps  ascending, two or more
/// @param t      from the first to before the last
/// @param time_of time_of(step)
template <class Step, class TimeOf>
std::size_t step_at(const std::vector<Step>& steps, double t, const TimeOf& time_of) {
  const std::size_t last = steps.size() - 2;
  const double begin = time_of(steps.front()), span = time_of(steps.back()) - begin;
  const double share = (t - begin) / span * static_cast<double>(last);
  auto i = std::min(last, static_cast<std::size_t>(share));
  for (int tries = 0; tries < 8; ++tries) {
    if (time_of(steps[i]) > t)
      --i;
    else if (time_of(steps[i + 1]) <= t)
      ++i;
    else
      return i;
  }
  const auto later = [&](double time, const Step& step) { return time < time_of(step); };
  const auto next = std::upper_bound(steps.begin() + 1, steps.end() - 1, t, later);
  return static_cast<std::size_t>(next - steps.begin()) - 1;
}

}  // namespace tumble::detail
