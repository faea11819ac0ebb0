// The three repairs of a drifted rotation matrix, on the same inputs.
#include <doctest/doctest.h>

#include "project/harness/inputs.hpp"
#include "project/harness/refusal.hpp"
#include "tumble/rotation/exp.hpp"
#include "tumble/rotation/gram_schmidt.hpp"
#include "tumble/rotation/nearest_rotation.hpp"
#include "tumble/rotation/newton_rotation.hpp"
#include "tumble/rotation/orthonormality.hpp"

using namespace tumble;
using test::eps;

namespace {

using Repair = Mat3 (*)(const Mat3&);
struct NamedRepair {
  std::string name;
  Repair repair;
};
const NamedRepair repairs[] = {{"gram_schmidt", rotation::gram_schmidt},
                               {"nearest_rotation", nearest_rotation},
                               {"newton_rotation", rotation::newton_rotation}};

Mat3 random_matrix(test::Random& rng) {
  Mat3 M;
  M << rng.vector(), rng.vector(), rng.vector();
  return M;
}

}  // namespace

TEST_CASE("repair: gives a rotation, from a little drift and from a lot") {
  test::Random rng(41);
  for (const NamedRepair& r : repairs) {
    CAPTURE(r.name);
    for (const double drift : {0.0, 1e-16, 1e-8, 1e-3, 0.2}) {
      CAPTURE(drift);
      for (const Vec3& w : test::rotation_vectors(42, 20)) {
        const Mat3 M = exp_rotation(w) + drift * random_matrix(rng);
        const double error = rotation::orthonormality_error(r.repair(M));
        CHECK(error <= 64 * eps);  // the sweeps of the SVD; the others stay below 8 eps
        CHECK(r.repair(M).determinant() > 0);
      }
    }
  }
}

TEST_CASE("repair: leaves a rotation alone") {
  for (const NamedRepair& r : repairs) {
    CAPTURE(r.name);
    for (const Vec3& w : test::rotation_vectors()) {
      const Mat3 R = exp_rotation(w);
      CHECK((r.repair(R) - R).norm() <= 32 * eps);
    }
  }
}

TEST_CASE("repair: commutes with turning the world") {
  test::Random rng(43);
  for (const NamedRepair& r : repairs) {
    CAPTURE(r.name);
    for (int i = 0; i < 50; ++i) {
      const Mat3 M = exp_rotation(rng.vector()) + 0.1 * random_matrix(rng);
      const Mat3 Q = exp_rotation<double>(3 * rng.vector());
      CHECK((r.repair(Q * M) - Q * r.repair(M)).norm() <= 64 * eps);
    }
  }
}

TEST_CASE("gram_schmidt: keeps the direction of the first column, and the plane of the first two") {
  test::Random rng(44);
  for (int i = 0; i < 50; ++i) {
    const Mat3 M = exp_rotation(rng.vector()) + 0.1 * random_matrix(rng);
    const Mat3 R = rotation::gram_schmidt(M);
    CHECK(R.col(0) == M.col(0).normalized());
    CHECK(std::abs(R.col(2).dot(M.col(1))) <= 8 * eps);
  }
}

TEST_CASE("nearest_rotation: no small turn brings it nearer") {
  test::Random rng(45);
  for (int i = 0; i < 50; ++i) {
    const Mat3 M = exp_rotation(rng.vector()) + 0.3 * random_matrix(rng);
    const Mat3 R = nearest_rotation(M);
    const double distance = (R - M).norm();
    CHECK(distance <= (rotation::gram_schmidt(M) - M).norm() + 8 * eps);
    // A turn by h changes the squared distance by about tr(S)h², h = 1e-4: far above rounding.
    for (int k = 0; k < 6; ++k)
      CHECK((exp_rotation<double>(1e-4 * rng.direction()) * R - M).norm() > distance);
  }
}

TEST_CASE("nearest_rotation: of a reflection is still a rotation") {
  const Mat3 mirror = Vec3(1, 1, -1).asDiagonal();
  CHECK(rotation::is_rotation(nearest_rotation(mirror), 4 * eps));
}

TEST_CASE("newton_rotation: is the nearest rotation, even of a badly stretched matrix") {
  test::Random rng(46);
  for (int i = 0; i < 50; ++i) {
    const Mat3 R = exp_rotation<double>(3 * rng.vector()), Q = exp_rotation(rng.vector());
    for (const Vec3& stretch :
         {Vec3(1, 1, 1), Vec3(0.5, 1, 2), Vec3(1e-3, 1, 1e3), Vec3(7e8, 5e8, 9e8)}) {
      CAPTURE(stretch.transpose());
      // R S with S symmetric positive definite has the polar factor R; rounding is
      // amplified by 1/σ_min.
      const Mat3 S = Q * stretch.asDiagonal() * Q.transpose();
      const double condition = stretch.maxCoeff() / stretch.minCoeff();
      CHECK((rotation::newton_rotation(R * S) - R).norm() <= 32 * eps * condition);
    }
  }
}

TEST_CASE("newton_rotation_step: squares the error") {
  test::Random rng(47);
  for (const double drift : {1e-2, 1e-3, 1e-4, 1e-6}) {
    CAPTURE(drift);
    const Mat3 M = exp_rotation(rng.vector()) + drift * random_matrix(rng);
    const double before = rotation::orthonormality_error(M);
    // σ → ½(σ + 1/σ): an error e = |σ² − 1| becomes e²/4 to leading order.
    CHECK(rotation::orthonormality_error(rotation::newton_rotation_step(M)) <=
          before * before / 3 + 8 * eps);
  }
}

TEST_CASE("repair: what is near no rotation is refused") {
  const Mat3 zero = Mat3::Zero(), mirror = Vec3(1, 1, -1).asDiagonal();
  Mat3 dependent = Mat3::Identity(), nan = Mat3::Identity();
  dependent.col(1) = 2 * dependent.col(0);
  nan(1, 2) = NAN;
  for (const Mat3& bad : {zero, mirror, dependent, nan}) {
    CHECK_REFUSED(rotation::gram_schmidt(bad), "not near a rotation");
    CHECK_REFUSED(rotation::newton_rotation(bad), "not near a rotation", "det");
    CHECK_REFUSED(rotation::newton_rotation_step(bad), "not near a rotation", "det");
  }
  CHECK_REFUSED(nearest_rotation(zero), "rank 0");
  CHECK_REFUSED(nearest_rotation(nan), "not finite");
}
