#pragma once
/// @file
/// How long something takes, on a machine that is also doing other things: the least
/// of several runs.

#include <algorithm>
#include <chrono>
#include <functional>
#include <limits>
#include <string>
#include <vector>

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

/// What one call of something takes.
struct Timing {
  std::string name;
  double seconds;
};

/// Measures several things that take turns, so that all see the same machine.
class Stopwatch {
 public:
  /// @param times in a row: enough to outlast the clock's own time
  template <class Action>
  void add(const std::string& name, Action action, int times = 1000) {
    const auto batch = [action, times]() mutable {
      for (int i = 0; i < times; ++i) action();
    };
    entries_.push_back({name, times, batch});
  }

  /// In the order in which they were added: the shortest run of each.
  std::vector<Timing> timings() const {
    constexpr int rounds = 5;
    constexpr double budget = 0.008;  // of each in each round [s]
    std::vector<Timing> timings;
    for (const Entry& entry : entries_)
      timings.push_back({entry.name, std::numeric_limits<double>::infinity()});
    for (int round = 0; round < rounds; ++round)
      for (std::size_t i = 0; i < entries_.size(); ++i) {
        const double seconds = shortest_run(budget, entries_[i].batch) / entries_[i].times;
        timings[i].seconds = std::min(timings[i].seconds, seconds);
      }
    return timings;
  }

 private:
  struct Entry {
    std::string name;
    int times;
    std::function<void()> batch;
  };
  std::vector<Entry> entries_;
};

/// Keeps the compiler from leaving out the computation of `value`.
template <class T>
void keep(const T& value) {
  asm volatile("" : : "g"(&value) : "memory");
}

}  // namespace tumble::support
