/// @file
/// Who can meet at all: what sort and sweep compares.

#include "common.hpp"
#include "parts.hpp"
#include "tumble/collide/sort_and_sweep.hpp"

namespace contact_chapter {

namespace {

using collide::Bounds;

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

}  // namespace

Table sweep_table() {
  Table table({"bodies", "all pairs", "compared", "bounds overlap"});
  for (const int n : {10, 100, 1000, 10'000}) {
    int overlapping = 0;
    const auto cost =
        collide::sort_and_sweep(scattered(n), [&overlapping](int, int) { ++overlapping; });
    table.add({std::to_string(n), std::to_string(n * (n - 1L) / 2),
               std::to_string(cost.comparisons), std::to_string(overlapping)});
  }
  return table;
}

}  // namespace contact_chapter
