#include "support/envelope.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace tumble::support;

namespace {

Series enveloped(int points, double (*f)(int)) {
  Envelope envelope(static_cast<std::size_t>(points));
  for (int i = 0; i < points; ++i) envelope.add(i, f(i));
  Series series;
  envelope.write_to(series);
  return series;
}

}  // namespace

TEST_CASE("envelope: few points stay as they are") {
  for (const int points : {1, 2, 100, 2400}) {
    const Series series = enveloped(points, [](int i) { return std::sin(i); });
    REQUIRE(series.x.size() == static_cast<std::size_t>(points));
    for (int i = 0; i < points; ++i) {
      CHECK(series.x[static_cast<std::size_t>(i)] == i);
      CHECK(series.y[static_cast<std::size_t>(i)] == std::sin(i));
    }
  }
  CHECK(enveloped(0, nullptr).x.empty());
}

TEST_CASE("envelope: of many points those are left that can be seen, a single spike with them") {
  for (const int points : {2401, 100'000, 1'234'567}) {
    const Series series = enveloped(points, [](int i) {
      return i == 1703 ? 9. : i == 1704 ? -9. : std::sin(i);
    });
    CHECK(series.x.size() == series.y.size());
    CHECK(series.x.size() <= 2400);
    CHECK(series.x.front() == 0);
    CHECK(series.x.back() == points - 1);
    CHECK(std::is_sorted(series.x.begin(), series.x.end()));
    CHECK(std::count(series.y.begin(), series.y.end(), 9.) == 1);
    CHECK(std::count(series.y.begin(), series.y.end(), -9.) == 1);
  }
}
