#include "tumble/body/state.hpp"

#include <doctest/doctest.h>

#include "project/harness/inputs.hpp"
#include "tumble/body/matrix_state.hpp"
#include "tumble/quaternion/exp_log.hpp"
#include "tumble/rotation/exp.hpp"

using namespace tumble;

TEST_CASE("pack: thirteen numbers in the order x, (w, x, y, z), P, L") {
  const RigidBodyState<> state{Vec3(1, 2, 3), Quat(4, 5, 6, 7), Vec3(8, 9, 10), Vec3(11, 12, 13)};
  const PackedState<double> y = pack(state);
  for (int i = 0; i < 13; ++i) CHECK(y[i] == i + 1);
}

TEST_CASE("unpack: takes back pack bit for bit, in float and in double") {
  test::Random rng(111);
  for (int i = 0; i < 50; ++i) {
    const RigidBodyState<> state{rng.vector(), exp_quaternion<double>(3 * rng.vector()),
                                 rng.vector(), rng.vector()};
    const PackedState<double> y = pack(state);
    CHECK(pack(unpack<double>(y)) == y);
    const PackedState<float> z = y.cast<float>();
    CHECK(pack(unpack<float>(z)) == z);
    CHECK(unpack<double>(y).q.coeffs() == state.q.coeffs());
  }
}

TEST_CASE("RigidBodyState: at rest in the origin, not turned, unless said otherwise") {
  const RigidBodyState<> state;
  PackedState<double> y = PackedState<double>::Zero();
  y[3] = 1;
  CHECK(pack(state) == y);
}

TEST_CASE("pack: eighteen numbers with a matrix, R column by column") {
  rotation::MatrixState<> state{Vec3(1, 2, 3), Mat3::Zero(), Vec3(13, 14, 15), Vec3(16, 17, 18)};
  state.R << 4, 7, 10, 5, 8, 11, 6, 9, 12;
  const rotation::PackedMatrixState<double> y = pack(state);
  for (int i = 0; i < 18; ++i) CHECK(y[i] == i + 1);
  CHECK(rotation::unpack<double>(y).R == state.R);
  CHECK(pack(rotation::unpack<double>(y)) == y);
}
