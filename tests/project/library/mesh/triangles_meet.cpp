#include "tumble/mesh/triangles_meet.hpp"

#include <doctest/doctest.h>

#include <cstdint>

#include "project/harness/inputs.hpp"

using namespace tumble;

namespace {

using Whole = std::array<std::int64_t, 3>;

/// The sign of (a − d) · ((b − d) × (c − d)) in whole numbers, which are exact: where products
/// wrap, the small sum is right all the same.
int side_in_whole_numbers(const Whole& a, const Whole& b, const Whole& c, const Whole& d) {
  using Wrapping = std::uint64_t;
  Wrapping wrapped = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    const auto less_d = [&d](const Whole& q, std::size_t n) {
      return static_cast<Wrapping>(q[n] - d[n]);
    };
    wrapped += less_d(a, i) * (less_d(b, j) * less_d(c, k) - less_d(b, k) * less_d(c, j));
  }
  const auto sum = static_cast<std::int64_t>(wrapped);
  return (sum > 0) - (sum < 0);
}

Vec3 scaled(const Whole& p, double scale, const Vec3& shift) {
  return scale * Vec3(double(p[0]), double(p[1]), double(p[2])) + shift;
}

}  // namespace

TEST_CASE(
    "side_of_plane: the sign is exact in a plane and beside it, near the origin and far away") {
  tumble::test::Random rng(2024);
  std::array<int, 3> seen{};
  for (int run = 0; run < 3000; ++run) {
    // Edges i (1, 0, a) + k (0, 1, b) whose cross product is as small as whole numbers can be,
    // sheared: the fourth point is in their plane or off it by one, far below the rounding of the
    // products.
    const auto random = [&] { return static_cast<std::int64_t>(rng.uniform(100, 250)); };
    const std::int64_t m = random(), slope_x = random(), slope_y = random();
    const Whole first{random(), random(), random()};
    const auto at = [&](std::int64_t i, std::int64_t k, std::int64_t off) -> Whole {
      const std::int64_t z = first[2] + i * slope_x + k * slope_y + off;
      return {first[0] + i + 3 * z, first[1] + k + 5 * z, z};
    };
    const std::array<Whole, 4> p{at(0, 0, 0), at(m, m + 1, 0), at(m + 1, m + 2, 0),
                                 at(3 * m, 2 * m, run % 3 - 1)};
    const int side = side_in_whole_numbers(p[0], p[1], p[2], p[3]);
    ++seen[static_cast<std::size_t>(side + 1)];
    // All places are exact in doubles, and so are their differences.
    for (const double scale : {0x1p-20, 0x1.8p-20, 0x1p60})
      for (const double shift : {0., 0x1p31}) {
        std::array<Vec3, 4> q;
        for (std::size_t i = 0; i < 4; ++i)
          q[i] = scaled(p[i], scale, Vec3::Constant(shift * scale));
        CHECK(detail::side_of_plane(q[0], q[1], q[2], q[3]) == side);
      }
  }
  for (const int count : seen) CHECK(count > 200);
}
