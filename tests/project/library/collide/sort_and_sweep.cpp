#include "tumble/collide/sort_and_sweep.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "project/harness/inputs.hpp"
#include "project/harness/refusal.hpp"

using namespace tumble;

namespace {

std::vector<collide::Pair> pairs_by_force(const std::vector<collide::Bounds>& bounds) {
  std::vector<collide::Pair> pairs;
  for (int i = 0; i < static_cast<int>(bounds.size()); ++i)
    for (int j = i + 1; j < static_cast<int>(bounds.size()); ++j) {
      const collide::Bounds &a = bounds[static_cast<std::size_t>(i)],
                            &b = bounds[static_cast<std::size_t>(j)];
      bool overlap = true;
      for (int k = 0; k < 3; ++k)
        overlap = overlap && a.min()[k] <= b.max()[k] && b.min()[k] <= a.max()[k];
      if (overlap) pairs.push_back({i, j});
    }
  return pairs;
}

/// Boxes on a coarse grid, so that many touch or are equal, or points.
std::vector<collide::Bounds> coarse_boxes(test::Random& rng, int count, double span) {
  std::vector<collide::Bounds> bounds;
  for (int i = 0; i < count; ++i) {
    const Vec3 low = rng.vector(0, span).array().floor();
    const Vec3 size = rng.vector(0, 3).array().floor();
    bounds.emplace_back(low, low + size);
  }
  return bounds;
}

}  // namespace

TEST_CASE("sort_and_sweep: exactly the pairs of brute force, with boxes that touch and are equal") {
  test::Random rng(1101);
  std::size_t found = 0;
  for (int i = 0; i < 300; ++i) {
    const auto bounds = coarse_boxes(rng, i % 40, rng.uniform(2, 30));
    const auto expected = pairs_by_force(bounds);
    CHECK(collide::overlapping_pairs(bounds) == expected);
    found += expected.size();
  }
  CHECK(found > 1000);
}

TEST_CASE("sort_and_sweep: touching counts, one unit in the last place apart does not") {
  const double next = std::nextafter(1., 2.);
  const Vec3 zero = Vec3::Zero(), one = Vec3::Ones();
  for (int k = 0; k < 3; ++k) {
    Vec3 beside = zero, apart = zero;
    beside[k] = 1;
    apart[k] = next;
    const std::vector<collide::Bounds> touching{{zero, one}, {beside, beside + one}};
    const std::vector<collide::Bounds> parted{{zero, one}, {apart, apart + one}};
    CHECK(collide::overlapping_pairs(touching).size() == 1);
    CHECK(collide::overlapping_pairs(parted).empty());
  }
}

TEST_CASE("sort_and_sweep: the axis with the fewest overlaps is swept, each pair shown once") {
  std::vector<collide::Bounds> towers;  // one above the other, all alike in x and y
  for (int i = 0; i < 1000; ++i) {
    const double z = (i * 7919) % 1000;
    towers.emplace_back(Vec3(0, 0, z), Vec3(1, 1, z + 0.5));
  }
  int shown = 0;
  const auto cost = collide::sort_and_sweep(towers, [&](int, int) { ++shown; });
  CHECK(cost.axis == 2);
  CHECK(cost.comparisons == 0);
  CHECK(shown == 0);
  towers.emplace_back(Vec3(0, 0, 0), Vec3(1, 1, 1000));  // beside all of them
  const auto more = collide::sort_and_sweep(towers, [&](int first, int second) {
    CHECK(first < second);
    ++shown;
  });
  CHECK(more.comparisons == 1000);
  CHECK(shown == 1000);
}

TEST_CASE("swept_bounds: hold the ball at all times of the flight, and are no wider than that") {
  test::Random rng(1102);
  for (int i = 0; i < 200; ++i) {
    const double far = i % 2 ? 0 : 1e8, radius = rng.uniform(0, 1), duration = rng.uniform(0, 3);
    const collide::Parabola flight{rng.vector() + Vec3::Constant(far), 10 * rng.vector(),
                                   10 * rng.vector()};
    const collide::Bounds swept = collide::swept_bounds(flight, duration, radius);
    collide::Bounds seen;
    constexpr int parts = 2000;
    for (int k = 0; k <= parts; ++k) {
      const collide::Bounds now = collide::ball_bounds(flight.at(k * duration / parts), radius);
      CHECK(swept.contains(now));
      seen.extend(now);
    }
    // Near its turn a coordinate is missed by a (Δs)²/8 at most.
    const double step = duration / parts, missed = 10 * step * step / 8;
    const double wider = (swept.sizes() - seen.sizes()).maxCoeff();
    CHECK(wider < 2 * missed + 200 * test::eps * (far + 100));
  }
}

TEST_CASE("bounds that are none are refused, by number") {
  const std::vector<collide::Bounds> empty{{Vec3::Zero(), Vec3::Ones()}, collide::Bounds()};
  CHECK_REFUSED(collide::overlapping_pairs(empty), "bounds 1");
  const std::vector<collide::Bounds> bad{{Vec3::Constant(NAN), Vec3::Ones()}};
  CHECK_REFUSED(collide::overlapping_pairs(bad), "bounds 0", "not finite");
  CHECK_REFUSED(collide::swept_bounds({}, -1, 1), "duration");
  CHECK_REFUSED(collide::swept_bounds({}, 1, NAN), "radius");
  CHECK_REFUSED(collide::swept_bounds({.v = Vec3::Constant(NAN)}, 1, 1), "flight");
}
