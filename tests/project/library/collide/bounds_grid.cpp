#include "tumble/collide/bounds_grid.hpp"

#include <doctest/doctest.h>

#include <set>

#include "project/harness/inputs.hpp"
#include "project/harness/refusal.hpp"

using namespace tumble;
using collide::Bounds;
using collide::BoundsGrid;

namespace {

/// Places in [0, 10]³, sizes up to 1; now and then all that there is, a point, or far away.
Bounds random_bounds(test::Random& rng, int i) {
  const Vec3 at = rng.vector(0, 10);
  if (i % 17 == 0) return {Vec3::Constant(-1e3), Vec3::Constant(1e3)};
  if (i % 13 == 0) return {at, at};
  if (i % 11 == 0) return {Vec3::Constant(1e18), Vec3::Constant(2e18)};
  return {at, at + rng.vector(0, 1)};
}

std::set<int> overlapping(BoundsGrid& grid, int i) {
  std::set<int> found;
  grid.overlapping(i, [&](int j) { CHECK(found.insert(j).second); });
  return found;
}

}  // namespace

TEST_CASE("BoundsGrid: finds what all comparisons find, while bounds change one by one") {
  test::Random rng(1161);
  constexpr int count = 200;
  for (const double cell : {0.1, 1., 30.}) {
    CAPTURE(cell);
    BoundsGrid grid(count, cell);
    std::vector<Bounds> all(count);
    std::size_t pairs = 0;
    for (int change = 0; change < 3 * count; ++change) {
      const int i = change % count;
      all[static_cast<std::size_t>(i)] = random_bounds(rng, change);
      grid.put(i, all[static_cast<std::size_t>(i)]);
      std::set<int> expected;
      for (int j = 0; j < std::min(change + 1, count); ++j)
        if (j != i && grid[i].intersects(all[static_cast<std::size_t>(j)])) expected.insert(j);
      REQUIRE(overlapping(grid, i) == expected);
      pairs += expected.size();
    }
    CHECK(pairs > 1000);
  }
}

TEST_CASE("BoundsGrid: bounds that touch overlap, empty ones don't, a cell needs a length") {
  BoundsGrid grid(3, 1);
  grid.put(0, {Vec3::Zero(), Vec3::Ones()});
  grid.put(1, {Vec3(1, 0, 0), Vec3(2, 1, 1)});
  CHECK(overlapping(grid, 0) == std::set<int>{1});
  CHECK(overlapping(grid, 2).empty());
  grid.put(1, {});
  CHECK(overlapping(grid, 0).empty());
  CHECK_REFUSED(BoundsGrid(3, 0), "cell");
  CHECK_REFUSED(BoundsGrid(3, NAN), "cell");
}
