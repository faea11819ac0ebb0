#include "tumble/rotation/euler_angles.hpp"

#include <doctest/doctest.h>

#include "project/harness/inputs.hpp"
#include "project/harness/refusal.hpp"
#include "tumble/rotation/exp.hpp"

using namespace tumble;
using namespace tumble::detail;
using test::eps;

namespace {

constexpr double pi = std::numbers::pi;

template <class Visit>
void for_each_sequence(Visit&& visit) {
  for (int i = 0; i < 12; ++i) visit(static_cast<EulerSequence>(i));
}

bool is_proper(EulerSequence sequence) {
  const std::array<int, 3> axes = axes_of(sequence);
  return axes[0] == axes[2];
}

}  // namespace

TEST_CASE("Euler angles: a worked number, yaw pitch roll of an aircraft") {
  // Yaw by 90° about z, then pitch by 90° about the new y: the nose (x) ends up pointing down.
  const Mat3 R = euler_angles_to_matrix(Vec3(pi / 2, pi / 2, 0), EulerSequence::zyx);
  CHECK((R * Vec3::UnitX() - Vec3(0, 0, -1)).norm() <= 4 * eps);
  CHECK((R * Vec3::UnitY() - Vec3(-1, 0, 0)).norm() <= 4 * eps);
}

TEST_CASE("Euler angles: all twelve sequences have different matrices") {
  std::vector<Mat3> matrices;
  for_each_sequence([&](EulerSequence sequence) {
    const Mat3 R = euler_angles_to_matrix(Vec3(0.3, 0.7, 1.1), sequence);
    for (const Mat3& other : matrices) CHECK((R - other).norm() > 0.1);
    matrices.push_back(R);
  });
}

TEST_CASE("Euler angles: the axes are turned about in order, each the newest one") {
  for_each_sequence([](EulerSequence sequence) {
    const std::array<int, 3> axes = axes_of(sequence);
    const Vec3 angles(0.3, -0.7, 1.1);
    Mat3 R = Mat3::Identity();
    for (int turn = 0; turn < 3; ++turn) {
      const auto axis = static_cast<std::size_t>(turn);
      // A turn about the body's own axis, written as a turn about where that axis is in
      // the world now.
      const Vec3 world_axis = R.col(axes[axis]);
      R = exp_rotation<double>(angles[turn] * world_axis) * R;
    }
    CAPTURE(static_cast<int>(sequence));
    CHECK((euler_angles_to_matrix(angles, sequence) - R).norm() <= 32 * eps);
  });
}

TEST_CASE("fixed angles: turns about the world's axes, the reverse of the rotating ones") {
  const Vec3 angles(0.3, -0.7, 1.1), reversed(1.1, -0.7, 0.3);
  CHECK(fixed_angles_to_matrix(angles, EulerSequence::xyz) ==
        euler_angles_to_matrix(reversed, EulerSequence::zyx));
  CHECK((fixed_angles_to_matrix(Vec3(pi / 2, 0, pi / 2), EulerSequence::xyz) * Vec3::UnitY() -
         Vec3::UnitZ())
            .norm() <= 4 * eps);
}

TEST_CASE("Euler angles: there and back gives the same matrix, gimbal lock included") {
  for_each_sequence([](EulerSequence sequence) {
    CAPTURE(static_cast<int>(sequence));
    const double locked = is_proper(sequence) ? 0 : pi / 2;
    test::Random rng(21);
    std::vector<Mat3> matrices;
    for (const Vec3& w : test::rotation_vectors(22)) matrices.push_back(exp_rotation(w));
    for (const double off : {0.0, 1e-16, 1e-12, 1e-8, 1e-4, -1e-16, -1e-8})
      matrices.push_back(euler_angles_to_matrix(
          Vec3(rng.uniform(-pi, pi), locked + off, rng.uniform(-pi, pi)), sequence));
    for (const Mat3& R : matrices) {
      const Vec3 angles = matrix_to_euler_angles(R, sequence);
      CAPTURE(angles.transpose());
      CHECK((euler_angles_to_matrix(angles, sequence) - R).norm() <= 32 * eps);
    }
  });
}

TEST_CASE("Euler angles: back and there gives the same angles, in the documented ranges") {
  for_each_sequence([](EulerSequence sequence) {
    CAPTURE(static_cast<int>(sequence));
    test::Random rng(23);
    for (int i = 0; i < 200; ++i) {
      const double beta = is_proper(sequence) ? rng.uniform(0.1, pi - 0.1) : rng.uniform(-1.5, 1.5);
      const Vec3 angles(rng.uniform(-pi, pi), beta, rng.uniform(-pi, pi));
      CAPTURE(angles.transpose());
      const Mat3 R = euler_angles_to_matrix(angles, sequence);
      // Near the singular β the angles are as ill-conditioned as 1 / its distance, here at most 15.
      CHECK((matrix_to_euler_angles(R, sequence) - angles).norm() <= 15 * 16 * eps);
    }
  });
}

TEST_CASE("Euler angles: what is no angle or no sequence is refused") {
  CHECK_REFUSED(euler_angles_to_matrix(Vec3(0, NAN, 0), EulerSequence::xyz), "finite", "nan");
  CHECK_REFUSED(fixed_angles_to_matrix(Vec3(INFINITY, 0, 0), EulerSequence::xyz), "finite", "inf");
  CHECK_REFUSED(axes_of(static_cast<EulerSequence>(12)), "no Euler sequence", "12");
}
