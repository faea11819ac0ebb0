/// @file
/// 3.3 rotation_dot: its laws, and what goes wrong.
#include "tumble/rotation/rotation_dot.hpp"
#include "03_rotation_matrices/contract.hpp"
#include "03_rotation_matrices/inputs.hpp"
#include "judge/spec/spec.hpp"
#include "tumble/rotation/euler_angles.hpp"
#include "tumble/rotation/exp.hpp"
#include "tumble/rotation/nearest_rotation.hpp"

using namespace tumble::judge;
using tumble::Mat3;
using tumble::Vec3;

namespace student {
const Function<decltype(rotation_matrices::rotation_dot)> rotation_dot{TUMBLE_UNIT};
}

namespace {

Mat3 reference(const Mat3& R, const Vec3& omega) {
  return tumble::rotation::rotation_dot(R, omega);
}

/// Two products and a sum a number, on either side.
double rounding(const Mat3& R, const Vec3& omega) { return 8 * eps * omega.norm() * R.norm(); }

Vec3 any_omega() { return any_vector(5); }

}  // namespace

TEST_SUITE(TUMBLE_UNIT) {
  TEST_CASE("any orientation, any angular velocity: each axis of the body moves as ω × axis") {
    for (int n = 0; n < 20; ++n) {
      const Mat3 R = any_rotation();
      const Vec3 omega = any_omega();
      REQUIRE(student::rotation_dot(R, omega) == close_to(reference(R, omega), rounding(R, omega)));
    }
  }

  TEST_CASE("upright body, turning about z: its x axis moves along y, its y axis along −x") {
    Mat3 expected;
    expected << Vec3::UnitY(), -Vec3::UnitX(), Vec3::Zero();
    REQUIRE(student::rotation_dot(Mat3::Identity(), Vec3::UnitZ()) == close_to(expected, 0));
  }

  TEST_CASE("ω is in world axes: a body that lies on its side turns about the world's x axis") {
    Mat3 side, expected;
    side << Vec3::UnitY(), -Vec3::UnitX(), Vec3::UnitZ();
    expected << Vec3::UnitZ(), Vec3::Zero(), -Vec3::UnitY();  // x × y, x × −x, x × z
    REQUIRE(student::rotation_dot(side, Vec3::UnitX()) == close_to(expected, 0));
  }

  TEST_CASE("a drifted R is taken as it is: every column moves as ω × column") {
    for (int n = 0; n < 20; ++n) {
      const Mat3 R = drifted_rotation(0.2);
      const Vec3 omega = any_omega();
      REQUIRE(student::rotation_dot(R, omega) == close_to(reference(R, omega), rounding(R, omega)));
    }
  }

  TEST_CASE("lengths and angles between the axes do not change: RᵀṘ + ṘᵀR = 0") {
    for (int n = 0; n < 20; ++n) {
      const Mat3 R = drifted_rotation(0.2);
      const Vec3 omega = any_omega();
      const auto rate = student::rotation_dot(R, omega);
      const Mat3 change = R.transpose() * rate.value();
      // 4 eps for the rate's numbers, 3 for those of the product, twice.
      REQUIRE(rate == obeys("RᵀṘ + ṘᵀR = 0", (change + change.transpose()).norm(),
                            16 * eps * omega.norm() * R.squaredNorm()));
    }
  }

  TEST_CASE("Ṙ is the slope of a steady turn about ω") {
    for (int n = 0; n < 20; ++n) {
      const Mat3 R = any_rotation();
      const Vec3 omega = any_omega();
      const double h = 1e-5;
      const Mat3 slope = (tumble::exp_rotation<double>(h * omega) * R -
                          tumble::exp_rotation<double>(-h * omega) * R) /
                         (2 * h);
      // A central difference misses h²/6 times the third derivative, and rounds by a few eps / h.
      const double speed = omega.norm();
      REQUIRE(student::rotation_dot(R, omega) ==
              close_to(slope, h * h * speed * speed * speed + 16 * eps / h));
    }
  }

  TEST_CASE("zero, tiny and huge angular velocities") {
    for (const double size : {0., 1e-150, 1e-8, 1e8, 1e150}) {
      for (const Mat3& R : {Mat3(Mat3::Identity()), any_rotation(), drifted_rotation(0.2)}) {
        const Vec3 omega = any_vector(size);
        REQUIRE(student::rotation_dot(R, omega) ==
                close_to(reference(R, omega), rounding(R, omega)));
      }
    }
  }
}

const Misconceptions<decltype(rotation_matrices::rotation_dot)> misconceptions{
    TUMBLE_UNIT,
    {{"ω taken in body axes",
      "This is the rate for an ω that is given in the axes of the body. Here ω is in world axes: "
      "look at the order of the two factors.",
      "Angular velocity",
      [](const Mat3& R, const Vec3& omega) -> Mat3 {
        return tumble::rotation::rotation_dot_body(R, omega);
      }},
     {"ω turned into body axes first",
      "You have turned ω into body axes, and multiplied it from the left, as if it were in world "
      "axes. ω and the columns of R are both in world axes already.",
      "Angular velocity",
      [](const Mat3& R, const Vec3& omega) -> Mat3 { return reference(R, R.transpose() * omega); }},
     {"Rᵀ for R",
      "You have multiplied by Rᵀ: the rows of R, in columns. The axes of the body, which ω carries "
      "along, are the columns of R.",
      "Columns are axes",
      [](const Mat3& R, const Vec3& omega) -> Mat3 { return reference(R.transpose(), omega); }},
     {"matrix of ω in other axes",
      "This is the matrix of ω turned to other axes, R [ω]× Rᵀ. The rate of an orientation has R "
      "once.",
      "Angular velocity",
      [](const Mat3& R, const Vec3& omega) -> Mat3 {
        return R * tumble::rotation::skew(omega) * R.transpose();
      }},
     {"turned the other way",
      "Every number has the wrong sign: the body turns against ω. A point r of it moves as ω × r, "
      "not r × ω.",
      "Angular velocity",
      [](const Mat3& R, const Vec3& omega) -> Mat3 { return -reference(R, omega); }},
     {"rows for columns",
      "You have multiplied ω with the rows of R. The axes of the body, which ω carries along, are "
      "the columns.",
      "Columns are axes",
      [](const Mat3& R, const Vec3& omega) -> Mat3 {
        return reference(R.transpose(), omega).transpose();
      }},
     {"transposed",
      "The rates of the three axes are right, but they are in the rows. They belong in the "
      "columns, "
      "like the axes themselves.",
      "Columns are axes",
      [](const Mat3& R, const Vec3& omega) -> Mat3 { return reference(R, omega).transpose(); }},
     {"halved",
      "Everything is half as large as it should be. The ½ belongs to the rate of a quaternion; a "
      "matrix has none.",
      "Angular velocity",
      [](const Mat3& R, const Vec3& omega) -> Mat3 { return 0.5 * reference(R, omega); }},
     {"R left out",
      "This is the matrix of ω alone. The rate of an axis also depends on where that axis points.",
      "Angular velocity",
      [](const Mat3&, const Vec3& omega) -> Mat3 { return tumble::rotation::skew(omega); }},
     {"rate added to R",
      "Your result contains R itself. Return the rate alone; the step is the solver's business.",
      "Angular velocity",
      [](const Mat3& R, const Vec3& omega) -> Mat3 { return R + reference(R, omega); }},
     {"by way of the body axes",
      "You have taken ω into body axes first. That is the same only while Rᵀ is the inverse of R, "
      "and this R has drifted.",
      "Drift",
      [](const Mat3& R, const Vec3& omega) -> Mat3 {
        return tumble::rotation::rotation_dot_body<double>(R, R.transpose() * omega);
      }},
     {"columns normalised on the way",
      "Your rate belongs to columns of length 1. A rate takes the state as it is, also where it "
      "has drifted; repair it between the steps.",
      "Drift",
      [](const Mat3& R, const Vec3& omega) -> Mat3 {
        return reference(R.colwise().normalized(), omega);
      }},
     {"repaired on the way",
      "Your rate belongs to a rotation near R. A rate takes the state as it is; repair it between "
      "the steps.",
      "Drift", [](const Mat3& R, const Vec3& omega) -> Mat3 {
        return reference(tumble::nearest_rotation(R), omega);
      }}}};
