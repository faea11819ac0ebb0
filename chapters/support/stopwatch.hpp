#pragma once
/// @file
/// How long something takes, on a machine that is also doing other things: the least
/// of several runs.

#include <algorithm>
#include <chrono>
#include <limits>

namespace tumble::support {

/// The shortest run of `action` [s], out of as many as fit into `budget` seconds, at least one.
template <class Action>
double shortest_run(double budget, Action&& action) {
  using Clock = std::chrono::steady_clock;
  const auto seconds_since = [](Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  };
  double least = std::numeric_limits<double>::infinity();
  const Clock::time_point begin = Clock::now();
  do {
    const Clock::time_point start = Clock::now();
    action();
    least = std::min(least, seconds_since(start));
  } while (seconds_since(begin) < budget);
  return least;
}

/// Keeps the compiler from leaving out the computation of `value`.
template <class T>
void keep(const T& value) {
  asm volatile("" : : "g"(&value) : "memory");
}

}  // namespace tumble::support
