#include "project/bench/contact/standing.hpp"

#include <algorithm>
#include <cmath>

#include "project/bench/report.hpp"

namespace tumble::bench {
namespace {

using support::number;

int right(const Problem& problem, const Curve& curve) {
  return static_cast<int>(std::lround((1 - std::fmin(1, curve.best_error())) * problem.count));
}

/// Of the others, the one with the least error, and of several such the fastest.
const Curve* best_other(const std::vector<Curve>& curves) {
  const Curve* best = nullptr;
  const auto rank = [](const Curve& c) {
    return std::pair(c.best_error(), c.points.back().seconds);
  };
  for (const Curve& curve : curves)
    if (!curve.is_ours() && !curve.points.empty() && (!best || rank(curve) < rank(*best)))
      best = &curve;
  return best;
}

std::string errors(const Problem& problem, const Curve& ours, const Curve& other) {
  if (problem.count > 0)
    return std::to_string(right(problem, ours)) + " against " +
           std::to_string(right(problem, other)) + " of " + std::to_string(problem.count) +
           " right";
  const double least = std::max(ours.best_error(), 0x1p-53);  // what is exact counts a rounding
  if (other.best_error() <= least) return "both exact";
  return "error " + number(other.best_error() / least, 2) + " × smaller";
}

}  // namespace

support::Table counts_table(const Problem& problem, const std::vector<Curve>& curves) {
  support::Table table({"method", "right of " + std::to_string(problem.count), "µs", "with"});
  for (const Curve& curve : curves)
    table.add({curve.full_name(), std::to_string(right(problem, curve)),
               curve.points.empty() ? "–" : number(curve.points.back().seconds * 1e6),
               setting_name(curve)});
  return table;
}

std::string standing(const Problem& problem, const std::vector<Curve>& curves) {
  const Curve* other = best_other(curves);
  const Curve& ours = curves.front();
  if (!other || ours.points.empty()) return "";
  const double theirs = other->points.back().seconds;
  const double faster = theirs / ours.seconds_to_reach(other->best_error());
  return "tumble / " + other->full_name() + ": " + number(faster, 2) +
         " × faster at the peer's own best error, " + errors(problem, ours, *other) + '\n';
}

}  // namespace tumble::bench
