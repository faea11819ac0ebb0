#include "tumble/mesh/integer_determinant.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "project/harness/inputs.hpp"
#include "tumble/mesh/triangles_meet.hpp"

using namespace tumble;
using namespace tumble::detail;

namespace {

/// The sign of (a − d) · ((b − d) × (c − d)) by a sum of all products without an error.
int side_by_sum(const std::array<Vec3, 4>& p) {
  ExactSum<96> sum;
  add_determinant(sum, 1, p[0], p[1], p[2]);
  add_determinant(sum, -1, p[0], p[1], p[3]);
  add_determinant(sum, 1, p[0], p[2], p[3]);
  add_determinant(sum, -1, p[1], p[2], p[3]);
  return sum.sign();
}

std::optional<int> side_by_integers(const std::array<Vec3, 4>& p) {
  std::array<std::array<double, 4>, 3> axes{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 4; ++k) axes[i][k] = p[k][static_cast<int>(i)];
  return integer_sign_of_determinant(axes);
}

}  // namespace

#ifdef __SIZEOF_INT128__

TEST_CASE("integer determinant: the sign of a sum without an error, for points next to a plane") {
  tumble::test::Random rng(7);
  std::array<int, 3> seen{};
  int refused = 0;
  for (int run = 0; run < 20000; ++run) {
    // Full mantissas; each axis has a size of its own. Every fourth time one number is so small
    // that the axis needs more bits than there are, every fifth the last point is one of the
    // others.
    const Vec3 size(std::ldexp(1, run % 40), std::ldexp(1, -run % 30), std::ldexp(1, run % 7));
    std::array<Vec3, 4> p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = rng.vector(0.05, 1).cwiseProduct(size);
    if (run % 4 == 0) p[0].x() *= 0x1p-9;
    const double s = rng.uniform(-0.2, 1), t = rng.uniform(-0.2, 1);
    p[3] = run % 5 == 0 ? p[1] : Vec3(p[0] + s * (p[1] - p[0]) + t * (p[2] - p[0]));
    const std::optional<int> side = side_by_integers(p);
    refused += !side;
    if (!side) continue;
    CHECK(*side == side_by_sum(p));
    ++seen[static_cast<std::size_t>(*side + 1)];
  }
  for (const int count : seen) CHECK(count > 2000);
  CHECK(refused > 2000);
  CHECK(refused < 10000);
}

TEST_CASE("integer determinant: of differences that are exact themselves") {
  tumble::test::Random rng(8);
  std::array<int, 3> seen{};
  for (int run = 0; run < 5000; ++run) {
    // Two rows nearly alike: what is left of the products is far below them.
    const Vec3 x = rng.vector(), z = rng.vector();
    Vec3 y = x;
    if (run % 3 != 0) y.y() = std::nextafter(y.y(), run % 3 == 1 ? 2. : -2.);
    ExactSum<24> sum;
    add_determinant(sum, 1, x, y, z);
    const auto sign = integer_sign_of_determinant<3>(
        {{{x.x(), y.x(), z.x()}, {x.y(), y.y(), z.y()}, {x.z(), y.z(), z.z()}}});
    if (!sign) continue;
    CHECK(*sign == sum.sign());
    ++seen[static_cast<std::size_t>(*sign + 1)];
  }
  for (const int count : seen) CHECK(count > 800);
}

TEST_CASE("integer determinant: the largest components do not overflow") {
  constexpr std::int64_t M = (std::int64_t{1} << (integer_bits + 1)) - 1;  // of a difference
  using Row = std::array<std::int64_t, 3>;
  const Row x{-M, M, M}, y{M, -M, M}, z{M, M, -M};  // 4 M³, from products of two of 2 M²
  CHECK(sign_of_determinant(x, y, z) == 1);
  CHECK(sign_of_determinant(y, x, z) == -1);
  CHECK(sign_of_determinant(x, x, z) == 0);
}

TEST_CASE("integer determinant: what is left of large products may be 1 or −1") {
  constexpr std::int64_t M = std::int64_t{1} << integer_bits;
  using Row = std::array<std::int64_t, 3>;
  const Row y{M, M + 1, 0}, z{M - 1, M, 0};  // M² − (M + 1)(M − 1) = 1
  for (const std::int64_t one : {1, -1}) {
    const Row x{0, 0, one};
    CHECK(sign_of_determinant(x, y, z) == one);
    CHECK(sign_of_determinant(x, z, y) == -one);
    CHECK(sign_of_determinant(y, z, x) == one);
    CHECK(sign_of_determinant(z, x, y) == one);
  }
  const Row e0{1, 0, 0}, e1{0, 1, 0}, e2{0, 0, 1};
  CHECK(sign_of_determinant(e0, e1, e2) == 1);
  CHECK(sign_of_determinant(e1, e0, e2) == -1);
  CHECK(sign_of_determinant(e0, e1, e1) == 0);
}

#endif

TEST_CASE("integer determinant: refuses what has too many bits, or is not finite") {
  CHECK_FALSE(as_integers(std::array{0x1p59, 1.}));
  CHECK(as_integers(std::array{0x1p58, 1.}));
  CHECK(as_integers(std::array{0x1p900, 0x1p880, 0.}));
  CHECK(*as_integers(std::array{0., -0.}) == std::array<std::int64_t, 2>{0, 0});
  using Limits = std::numeric_limits<double>;
  for (const double bad : {Limits::quiet_NaN(), Limits::infinity(), Limits::denorm_min()})
    CHECK_FALSE(as_integers(std::array{bad, 1.}));
}
