#include "tumble/mesh/triangles_meet.hpp"

#include <doctest/doctest.h>

#include <cstdint>

#include "project/harness/inputs.hpp"

using namespace tumble;

namespace {

using Whole = std::array<std::int64_t, 3>;

/// The sign of (a − d) · ((b − d) × (c − d)) in whole numbers, which are exact: below 2¹⁹ in size.
int side_in_whole_numbers(const Whole& a, const Whole& b, const Whole& c, const Whole& d) {
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    sum += (a[i] - d[i]) * ((b[j] - d[j]) * (c[k] - d[k]) - (b[k] - d[k]) * (c[j] - d[j]));
  }
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
    std::array<Whole, 4> p;
    for (Whole& point : p)
      for (std::int64_t& x : point) x = static_cast<std::int64_t>(rng.uniform(-4e5, 4e5)) & ~1;
    // The fourth in the plane of the others, between two of them; or off by one in one direction.
    for (std::size_t i = 0; i < 3; ++i) p[3][i] = (p[0][i] + p[1][i]) / 2;
    p[3][static_cast<std::size_t>(run % 3)] += run % 5 == 0 ? 1 : 0;
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
