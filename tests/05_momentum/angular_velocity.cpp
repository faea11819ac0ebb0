/// @file
/// 5.5 angular_velocity: its laws, and what goes wrong.
#include <Eigen/LU>

#include "05_momentum/contract.hpp"
#include "judge/spec/spec.hpp"
#include "tumble/body/derived.hpp"

using namespace tumble::judge;
using tumble::Mat3, tumble::Vec3;

namespace student {
const Function<decltype(momentum::angular_velocity)> angular_velocity{TUMBLE_UNIT};
}

namespace {

/// Moments about the principal axes that some body has: sums of two of three positive numbers.
Vec3 any_moments() {
  const Vec3 s{any_number(0.2, 2), any_number(0.2, 2), any_number(0.2, 2)};
  return {s.y() + s.z(), s.z() + s.x(), s.x() + s.y()};
}

/// The tensor with these principal values about the columns of `axes`, exactly symmetric.
Mat3 tensor(const Vec3& values, const Mat3& axes) {
  const Mat3 M = axes * values.asDiagonal() * axes.transpose();
  return (M + M.transpose()) / 2;
}

/// I_body⁻¹ of any body, in any body axes.
Mat3 any_inverse() {
  const Vec3 moments = any_moments();
  return tensor(moments.cwiseInverse(), any_rotation());
}

Vec3 reference(const Mat3& R, const Mat3& I_body_inv, const Vec3& L) {
  const Mat3 inverse = R * I_body_inv * R.transpose();
  return inverse * L;
}

/// Three products of a matrix and a vector round by 5 eps of ‖I_body⁻¹‖ |L| each, two of matrices
/// by some 10, and an R that is a rotation up to rounding adds as much: 32 on either side.
double rounding(const Mat3& I_body_inv, const Vec3& L) {
  return 64 * eps * I_body_inv.norm() * L.norm();
}

Vec3 any_momentum() { return any_vector(5); }

}  // namespace

TEST_SUITE(TUMBLE_UNIT) {
  TEST_CASE("any body, turned in any way, with any angular momentum") {
    for (int n = 0; n < 20; ++n) {
      const Mat3 R = any_rotation(), I_body_inv = any_inverse();
      const Vec3 L = any_momentum();
      REQUIRE(student::angular_velocity(R, I_body_inv, L) ==
              close_to(reference(R, I_body_inv, L), rounding(I_body_inv, L)));
    }
  }

  TEST_CASE("about a principal axis the body turns by L over the moment, along that axis") {
    for (int n = 0; n < 10; ++n) {
      const Vec3 moments = any_moments();
      const Mat3 R = any_rotation(), I_body_inv = moments.cwiseInverse().asDiagonal();
      for (int k = 0; k < 3; ++k) {
        const double size = any_number(-5, 5);
        const Vec3 L = size * R.col(k), omega = size / moments[k] * R.col(k);
        REQUIRE(student::angular_velocity(R, I_body_inv, L) ==
                close_to(omega, rounding(I_body_inv, L)));
      }
    }
  }

  TEST_CASE("L = I ω: what is put in as an angular velocity comes out again") {
    for (int n = 0; n < 10; ++n) {
      const double mass = any_number(1, 5);
      const Vec3 moments = any_moments();
      const tumble::RigidBody<> body(mass, tensor(moments, any_rotation()));
      const Mat3 R = any_rotation(), I_body_inv = body.I_body_inv();
      const Vec3 omega = any_vector(4), L = tumble::angular_momentum<double>(body, R, omega);
      // The tensor and its inverse are rounded: that counts by the condition number, once each.
      const double condition = body.I_body().norm() * I_body_inv.norm();
      REQUIRE(student::angular_velocity(R, I_body_inv, L) ==
              close_to(omega, rounding(I_body_inv, L) + 64 * eps * condition * omega.norm()));
    }
  }

  TEST_CASE("body and angular momentum turned together: ω turns with them") {
    for (int n = 0; n < 10; ++n) {
      const Mat3 R = any_rotation(), I_body_inv = any_inverse(), turn = any_rotation();
      const Vec3 L = any_momentum();
      const auto before = student::angular_velocity(R, I_body_inv, L);
      const Vec3 expected = turn * before.value();
      // √3 of what the first answer may be off, and what the turned inputs are rounded by.
      REQUIRE(student::angular_velocity(turn * R, I_body_inv, turn * L) ==
              close_to(expected, 4 * rounding(I_body_inv, L)));
    }
  }

  TEST_CASE("the same body, described in other body axes, turns alike") {
    for (int n = 0; n < 10; ++n) {
      const Mat3 R = any_rotation(), axes = any_rotation();
      const Vec3 values = any_moments().cwiseInverse(), L = any_momentum();
      // The body with its principal axes for body axes, and the same body described in others.
      const Mat3 principal = values.asDiagonal(), others = tensor(values, axes);
      const auto omega = student::angular_velocity(R, principal, L);
      REQUIRE(student::angular_velocity(R * axes.transpose(), others, L) ==
              close_to(omega.value(), 2 * rounding(others, L)));
    }
  }

  TEST_CASE("a ball turns along L, by L over its moment; other bodies at less than a right angle") {
    for (int n = 0; n < 10; ++n) {
      const Mat3 R = any_rotation(), I_body_inv = any_inverse();
      const Mat3 ball = any_number(0.1, 5) * Mat3::Identity();
      const Vec3 L = any_momentum(), along_L = ball(0, 0) * L;
      REQUIRE(student::angular_velocity(R, ball, L) == close_to(along_L, rounding(ball, L)));
      const auto omega = student::angular_velocity(R, I_body_inv, L);
      REQUIRE(omega == obeys("ω · L > 0", -omega->dot(L), 0));
    }
  }

  TEST_CASE("a needle, a thousand times easier to turn about its own axis") {
    for (int n = 0; n < 10; ++n) {
      const Mat3 R = any_rotation(), I_body_inv = tensor({1, 1, 1000}, any_rotation());
      const Vec3 L = any_momentum();
      REQUIRE(student::angular_velocity(R, I_body_inv, L) ==
              close_to(reference(R, I_body_inv, L), rounding(I_body_inv, L)));
    }
  }

  TEST_CASE("no angular momentum, tiny and huge ones, specks of dust and planets") {
    for (const double inertia : {1e-100, 1e-8, 1e8, 1e100}) {
      for (const double size : {0., 1e-100, 1e-8, 1e8, 1e100}) {
        const Mat3 R = any_rotation(), I_body_inv = any_inverse() / inertia;
        const Vec3 L = any_vector(size);
        REQUIRE(student::angular_velocity(R, I_body_inv, L) ==
                close_to(reference(R, I_body_inv, L), rounding(I_body_inv, L)));
      }
    }
  }
}

const Misconceptions<decltype(momentum::angular_velocity)> misconceptions{
    TUMBLE_UNIT,
    {{"not turned",
      "You have multiplied the tensor in body axes with L in world axes. A product needs both "
      "in the same frame: bring in the orientation.",
      "Frames of reference",
      [](const Mat3&, const Mat3& I_body_inv, const Vec3& L) -> Vec3 { return I_body_inv * L; }},
     {"turned the wrong way",
      "You have turned L by R, which takes body axes to world axes, and the result back by its "
      "transpose. Do it the other way round: L is in world axes.",
      "Frames of reference",
      [](const Mat3& R, const Mat3& I_body_inv, const Vec3& L) {
        return reference(R.transpose(), I_body_inv, L);
      }},
     {"turned twice the same way",
      "R is on both sides of your tensor. What turns L into body axes has to undo what "
      "turns ω out of them.",
      "Frames of reference",
      [](const Mat3& R, const Mat3& I_body_inv, const Vec3& L) -> Vec3 {
        return R * (I_body_inv * (R * L));
      }},
     {"left in body axes", "This is ω in body axes. You have not turned it back into world axes.",
      "Frames of reference",
      [](const Mat3& R, const Mat3& I_body_inv, const Vec3& L) -> Vec3 {
        return I_body_inv * (R.transpose() * L);
      }},
     {"L not turned into body axes",
      "You have multiplied the tensor in body axes with L in world axes, and turned only the "
      "result.",
      "Frames of reference",
      [](const Mat3& R, const Mat3& I_body_inv, const Vec3& L) -> Vec3 {
        return R * (I_body_inv * L);
      }},
     {"inverted once more",
      "This is as if L were an angular velocity and ω a momentum: you have used the tensor "
      "itself, not its inverse. What you are given as I_body_inv is inverted already.",
      "Angular momentum",
      [](const Mat3& R, const Mat3& I_body_inv, const Vec3& L) {
        return reference(R, I_body_inv.inverse(), L);
      }},
     {"divided component by component",
      "You have divided the components of L in body axes by the numbers on the diagonal. They "
      "are inverse moments already, and the other six numbers of the tensor count too.",
      "Angular momentum",
      [](const Mat3& R, const Mat3& I_body_inv, const Vec3& L) -> Vec3 {
        return R * (R.transpose() * L).cwiseQuotient(I_body_inv.diagonal());
      }},
     {"diagonal only",
      "You have used only the three numbers on the diagonal of the tensor. That is right if the "
      "body's axes are its principal axes; here they need not be.",
      "Angular momentum",
      [](const Mat3& R, const Mat3& I_body_inv, const Vec3& L) {
        return reference(R, I_body_inv.diagonal().asDiagonal(), L);
      }},
     {"upper triangle only",
      "You have left out the numbers of the tensor below its diagonal, or above it. It is "
      "symmetric, but both halves are in the product.",
      "Angular momentum",
      [](const Mat3& R, const Mat3& I_body_inv, const Vec3& L) {
        return reference(R, I_body_inv.triangularView<Eigen::Upper>(), L);
      }},
     {"against L",
      "Your body turns the other way round. Energy is ½ L·ω, and that is never negative.",
      "Angular momentum",
      [](const Mat3& R, const Mat3& I_body_inv, const Vec3& L) {
        return reference(R, I_body_inv, -L);
      }},
     {"diagonal only, and not turned",
      "You have multiplied each component of L with one number of the tensor. That is right for "
      "an upright body with its principal axes along the world's, and for no other.",
      "Angular momentum",
      [](const Mat3&, const Mat3& I_body_inv, const Vec3& L) -> Vec3 {
        return I_body_inv.diagonal().cwiseProduct(L);
      }},
     {"a single moment",
      "You have replaced the tensor by one number, the mean of its diagonal, so ω is along L. "
      "Only a ball turns like that.",
      "Angular momentum", [](const Mat3&, const Mat3& I_body_inv, const Vec3& L) -> Vec3 {
        return I_body_inv.trace() / 3 * L;
      }}}};
