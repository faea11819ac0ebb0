#include <algorithm>
#include <numeric>

#include "contract.hpp"

namespace when_bodies_meet {

namespace {

bool overlap(const Bounds& a, const Bounds& b) {
  return (a.low.array() <= b.high.array()).all() && (b.low.array() <= a.high.array()).all();
}

}  // namespace

std::vector<Pair> overlapping_pairs(const std::vector<Bounds>& bounds, const Meet& meet) {
  std::vector<int> order(bounds.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](int i, int j) { return bounds[i].low.x() < bounds[j].low.x(); });
  std::vector<Pair> pairs;
  std::vector<int> open;  // those that reach to where the sweep is
  for (const int j : order) {
    std::erase_if(open, [&](int i) { return bounds[i].high.x() < bounds[j].low.x(); });
    for (const int i : open) {
      const Pair pair{std::min(i, j), std::max(i, j)};
      if (overlap(bounds[i], bounds[j]) && meet(pair.first, pair.second)) pairs.push_back(pair);
    }
    open.push_back(j);
  }
  std::sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) {
    return a.first < b.first || (a.first == b.first && a.second < b.second);
  });
  return pairs;
}

}  // namespace when_bodies_meet
