#include "tumble/mass/sample_points.hpp"

#include <doctest/doctest.h>

#include <vector>

#include "project/harness/inputs.hpp"
#include "project/harness/refusal.hpp"
#include "tumble/mass/grid_points.hpp"
#include "tumble/mass/low_discrepancy_points.hpp"
#include "tumble/mass/random_points.hpp"
#include "tumble/mass/stratified_points.hpp"

using namespace tumble;
using namespace tumble::detail;
using test::eps;

namespace {

template <sampling::SamplePoints P>
std::vector<Vec3> all_of(P points) {
  std::vector<Vec3> list;
  for (std::int64_t i = 0; i < points.count(); ++i) list.push_back(points.next());
  return list;
}

/// How many of the points are in each of the n × n × n cells of the cube.
std::vector<int> counts(const std::vector<Vec3>& points, int n) {
  std::vector<int> cells(static_cast<std::size_t>(n * n * n));
  for (const Vec3& p : points) {
    CHECK(p.minCoeff() >= 0);
    CHECK(p.maxCoeff() < 1);
    const Eigen::Vector3i cell = (n * p).cast<int>();
    ++cells[static_cast<std::size_t>((cell.z() * n + cell.y()) * n + cell.x())];
  }
  return cells;
}

}  // namespace

TEST_CASE("GridPoints: 2 per axis are the centres of the eight octants, x fastest") {
  const std::vector<Vec3> points = all_of(sampling::GridPoints(2));
  REQUIRE(points.size() == 8);
  CHECK(points[0] == Vec3(0.25, 0.25, 0.25));
  CHECK(points[1] == Vec3(0.75, 0.25, 0.25));
  CHECK(points[2] == Vec3(0.25, 0.75, 0.25));
  CHECK(points[7] == Vec3(0.75, 0.75, 0.75));
}

TEST_CASE("GridPoints: exactly one in every cell") {
  for (const int cell : counts(all_of(sampling::GridPoints(7)), 7)) CHECK(cell == 1);
}

TEST_CASE("RandomPoints: the same everywhere: the generator's standard says its 10000th number") {
  // [rand.predef]: the 10000th value of a default mt19937_64 is 9981545732273789042.
  sampling::RandomPoints points(3334, std::mt19937_64::default_seed);
  Vec3 last = Vec3::Zero();
  for (int i = 0; i < 3334; ++i) last = points.next();
  CHECK(last.x() == static_cast<double>(9981545732273789042ULL >> 11) * 0x1p-53);
}

TEST_CASE(
    "RandomPoints: equal seeds give equal points, others others; a copy goes on where it stands") {
  sampling::RandomPoints a(100, 7), b(100, 7), c(100, 8);
  const Vec3 first = a.next();
  CHECK(first == b.next());
  CHECK(first != c.next());
  sampling::RandomPoints copy = a;
  CHECK(copy.next() == a.next());
}

TEST_CASE("RandomPoints: even, as far as chance goes") {
  const int n = 4, per_cell = 500;
  double chi2 = 0;
  for (const int cell : counts(all_of(sampling::RandomPoints(n * n * n * per_cell, 3)), n))
    chi2 += double(cell - per_cell) * (cell - per_cell) / per_cell;
  // χ² with 63 degrees of freedom: mean 63, standard deviation √126.
  CHECK(std::abs(chi2 - 63) <= 4 * std::sqrt(126.0));
}

TEST_CASE("StratifiedPoints: exactly one in every cell, x fastest, and anywhere in it") {
  const int n = 7;
  const std::vector<Vec3> points = all_of(sampling::StratifiedPoints(n));
  for (const int cell : counts(points, n)) CHECK(cell == 1);
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const int k = static_cast<int>(i);
    const Vec3 in_cell = n * points[i] - Vec3(k % n, k / n % n, k / (n * n));
    CHECK(in_cell.minCoeff() >= -8 * eps * n);
    CHECK(in_cell.maxCoeff() <= 1 + 8 * eps * n);
    sum += in_cell;
  }
  // Uniform in the cell: 343 values of variance 1/12.
  CHECK((sum / 343 - Vec3::Constant(0.5)).cwiseAbs().maxCoeff() <= 4 / std::sqrt(12 * 343.0));
}

TEST_CASE("StratifiedPoints, R3Points: equal seeds give equal points, others others") {
  CHECK(all_of(sampling::StratifiedPoints(4, 7)) == all_of(sampling::StratifiedPoints(4, 7)));
  CHECK(all_of(sampling::StratifiedPoints(4, 7)) != all_of(sampling::StratifiedPoints(4, 8)));
  CHECK(all_of(sampling::R3Points(50, 7)) == all_of(sampling::R3Points(50, 7)));
  CHECK(all_of(sampling::R3Points(50, 7)) != all_of(sampling::R3Points(50, 8)));
}

TEST_CASE("R3Points: other seeds give the same set, moved round the cube") {
  const std::vector<Vec3> a = all_of(sampling::R3Points(200)),
                          b = all_of(sampling::R3Points(200, 5));
  for (std::size_t i = 1; i < a.size(); ++i) {
    const Vec3 change = (b[i] - a[i]) - (b[0] - a[0]);  // whole numbers, where one has wrapped
    CHECK((change - change.array().round().matrix()).norm() <= 8 * eps);
  }
}

TEST_CASE("random fractions of a part stay below 1") {
  std::mt19937_64 engine(1);
  for (int i = 0; i < 1000; ++i) CHECK(random_fraction_of_part(engine, 1999999, 2000000) < 1);
}

TEST_CASE(
    "R3Points: the recurrence ½ + i/gᵏ with g⁴ = g + 1, and no digit lost after many points") {
  const double g = 1.2207440846057596;
  CHECK(std::abs(g * g * g * g - g - 1) <= 16 * eps * 3);
  sampling::R3Points points(100000);
  for (int i = 1; i <= 100000; ++i) {
    const Vec3 p = points.next();
    if (i % 9999 > 3) continue;
    CAPTURE(i);
    for (int k = 0; k < 3; ++k) {
      const double exact = 0.5 + i / std::pow(g, k + 1);
      const double difference = p[k] - (exact - std::floor(exact));
      // pow and the quotient round by 4 eps of i; near 0 and 1 the fraction may be on
      // the other side.
      CHECK(std::abs(difference - std::round(difference)) <= 4 * eps * i);
    }
  }
}

TEST_CASE("R3Points: much more even than random") {
  for (const int count : {1000, 6400}) {
    double chi2 = 0;
    const double expected = count / 64.0;
    for (const int cell : counts(all_of(sampling::R3Points(count)), 4))
      chi2 += (cell - expected) * (cell - expected) / expected;
    CAPTURE(count);
    CHECK(chi2 <= 63 - 4 * std::sqrt(126.0));  // as even as 1 in 10⁴ random sets
  }
}

TEST_CASE("sample points: refuse counts that are none") {
  for (const int n : {0, -5}) {
    CAPTURE(n);
    CHECK_REFUSED(sampling::GridPoints(n), "grid points per axis is " + std::to_string(n));
    CHECK_REFUSED(sampling::RandomPoints(n), "random points is " + std::to_string(n));
    CHECK_REFUSED(sampling::StratifiedPoints(n),
                  "stratified points per axis is " + std::to_string(n));
    CHECK_REFUSED(sampling::R3Points(n), "low-discrepancy points is " + std::to_string(n));
  }
  CHECK_REFUSED(sampling::GridPoints(3'000'000), "3000000");
  CHECK_REFUSED(sampling::StratifiedPoints(3'000'000), "3000000");
}
