#include "tumble/simd/pack.hpp"

#include <doctest/doctest.h>

#include <limits>

#include "project/harness/inputs.hpp"
#include "tumble/simd/corners.hpp"
#include "tumble/simd/instruction_set.hpp"

using namespace tumble;
using namespace tumble::detail;
using namespace tumble::simd;

namespace {

/// Takes three numbers per lane through every operation, compiled for the instructions of a set.
struct Operations {
  const double* x;
  const double* y;
  int& failures;

  template <class P, Fma fma>
  TUMBLE_INLINE void run() const {
    P a{}, b{};
    for (int i = 0; i < lanes<P>; ++i) a[i] = x[i], b[i] = y[i];
    const P positive = absolute(a), low = smaller(a, b), high = larger(a, b), whole = rounded(a),
            yes = one_unless_greater(a, b), fused = fused_multiply_add(a, b, a);
    double sum = 0;
    for (int i = 0; i < lanes<P>; ++i) {
      sum += a[i];
      failures += positive[i] != std::abs(x[i]);
      failures += low[i] != std::min(x[i], y[i]);
      failures += high[i] != std::max(x[i], y[i]);
      failures += whole[i] != std::nearbyint(x[i]);
      failures += yes[i] != (x[i] <= y[i] ? 1 : 0);
      failures += fused[i] != std::fma(x[i], y[i], x[i]);
    }
    failures += std::abs(sum_of_lanes(a) - sum) > 64 * test::eps * sum_of_lanes(positive);
  }
};

/// Reads the corners of triangles whose coordinates tell where they come from.
struct Corners {
  const double* xyz;
  const int* corners;
  int& failures;

  template <class P, Fma>
  TUMBLE_INLINE void run() const {
    const CornerNumbers<P> numbers = load_numbers<P>(corners);
    for (int k = 0; k < 3; ++k) {
      const Point<P> p = load_corners<P>(xyz, corners, k);
      for (int i = 0; i < lanes<P>; ++i) {
        const int v = corners[3 * i + k];
        failures += p.x[i] != xyz[3 * v];
        failures += p.y[i] != xyz[3 * v + 1];
        failures += p.z[i] != xyz[3 * v + 2];
        failures += numbers.of_corner[k][i] != v;
      }
    }
  }
};

template <class Kernel, class... Inputs>
void check_on_all_sets(const Inputs&... inputs) {
  for (int i = 0; i <= static_cast<int>(best_instruction_set()); ++i) {
    int failures = 0;
    dispatch(static_cast<InstructionSet>(i), Kernel{inputs..., failures});
    CAPTURE(i);
    CHECK(failures == 0);
  }
}

}  // namespace

TEST_CASE("packs: every lane goes through the arithmetic of a double, with all instructions") {
  test::Random rng(31);
  for (int trial = 0; trial < 200; ++trial) {
    double x[8], y[8];
    for (int i = 0; i < 8; ++i) {
      x[i] = std::ldexp(rng.uniform(-1, 1), static_cast<int>(rng.uniform(-4, 30)));
      y[i] = trial % 3 == 0 && i % 2 == 0 ? x[i] : rng.uniform(-1, 1);
    }
    check_on_all_sets<Operations>(&x[0], &y[0]);
  }
}

TEST_CASE("packs: a comparison with NaN is not greater") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const FourDoubles x{nan, 1, nan, 2}, y{1, nan, nan, 1};
  const FourDoubles yes = one_unless_greater(x, y);
  CHECK(yes[0] == 1);
  CHECK(yes[1] == 1);
  CHECK(yes[2] == 1);
  CHECK(yes[3] == 0);
}

TEST_CASE(
    "load_corners, load_numbers: each triangle in its own lane, each coordinate in its pack") {
  test::Random rng(32);
  double xyz[3 * 40 + 1];
  for (int i = 0; i < 3 * 40 + 1; ++i) xyz[i] = i;
  for (int trial = 0; trial < 100; ++trial) {
    int corners[24];
    for (int& v : corners) v = static_cast<int>(rng.uniform(0, 40));
    check_on_all_sets<Corners>(&xyz[0], &corners[0]);
  }
}
