/// @file
/// Who can meet at all: what sort and sweep compares.

#include <algorithm>

#include "common.hpp"
#include "parts.hpp"

namespace contact_chapter {

namespace {

using Bounds = Eigen::AlignedBox3d;

/// Cubes of 1 m, of which each has 8 m³ for itself.
std::vector<Bounds> scattered(int n) {
  support::Random random(11);
  const double side = 2 * std::cbrt(n);
  std::vector<Bounds> bounds;
  for (int i = 0; i < n; ++i) {
    const Vec3 low = random.vector(0, side);
    bounds.emplace_back(low, low + Vec3::Ones());
  }
  return bounds;
}

struct Counts {
  long compared = 0, overlapping = 0;
};

/// Sorted along x; each is compared with those that begin before it ends.
Counts swept(std::vector<Bounds> bounds) {
  std::sort(bounds.begin(), bounds.end(),
            [](const Bounds& a, const Bounds& b) { return a.min().x() < b.min().x(); });
  Counts counts;
  for (std::size_t i = 0; i < bounds.size(); ++i)
    for (std::size_t j = i + 1; j < bounds.size(); ++j) {
      if (bounds[j].min().x() > bounds[i].max().x()) break;
      ++counts.compared;
      if (bounds[i].intersects(bounds[j])) ++counts.overlapping;
    }
  return counts;
}

}  // namespace

Table sweep_table() {
  Table table({"bodies", "all pairs", "overlap along x", "bounds overlap"});
  for (const int n : {10, 100, 1000, 10'000}) {
    const Counts counts = swept(scattered(n));
    table.add({std::to_string(n), std::to_string(n * (n - 1L) / 2), std::to_string(counts.compared),
               std::to_string(counts.overlapping)});
  }
  return table;
}

}  // namespace contact_chapter
