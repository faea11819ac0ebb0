#include "tumble/mass/validity.hpp"

#include <doctest/doctest.h>

#include "project/harness/inputs.hpp"
#include "project/harness/refusal.hpp"
#include "tumble/mass/transform.hpp"

using namespace tumble;
using test::Random;

namespace {

Mat3 diagonal(double A, double B, double C) { return Vec3(A, B, C).asDiagonal(); }

}  // namespace

TEST_CASE("require_valid_inertia: worked numbers") {
  CHECK(detail::is_valid_inertia(diagonal(2, 3, 4)));
  CHECK_FALSE(detail::is_valid_inertia(diagonal(1, 1, 3)));
  CHECK_NOTHROW(detail::require_valid_inertia(diagonal(1, 1, 1)));
}

TEST_CASE("require_valid_inertia: lets every body through, in every position") {
  Random rng(31);
  for (const Vec3& v : test::rotation_vectors(31)) {
    const Mat3 R =
        Eigen::AngleAxisd(v.norm(), v.norm() > 0 ? Vec3(v.normalized()) : Vec3(Vec3::UnitX()))
            .toRotationMatrix();
    // ∫ x², ∫ y², ∫ z² may be any positive numbers: lengths to thicknesses from 1 to 1e5.
    const Vec3 s(1, std::pow(10, rng.uniform(-10, 0)), std::pow(10, rng.uniform(-10, 0)));
    const Mat3 I = R * diagonal(s.y() + s.z(), s.z() + s.x(), s.x() + s.y()) * R.transpose();
    CAPTURE(s.transpose());
    CAPTURE(v.transpose());
    CHECK(detail::inertia_defect(I) == "");
  }
}

TEST_CASE("require_valid_inertia: a flat body, I_zz = I_xx + I_yy, is a body in every position") {
  for (const Vec3& v : test::rotation_vectors(32)) {
    const Mat3 R =
        Eigen::AngleAxisd(v.norm(), v.norm() > 0 ? Vec3(v.normalized()) : Vec3(Vec3::UnitX()))
            .toRotationMatrix();
    const Mat3 flat = diagonal(0.1, 0.2, 0.1 + 0.2);
    CAPTURE(v.transpose());
    CHECK(detail::inertia_defect(R * flat * R.transpose()) == "");
  }
  // Just beyond what rounding explains it is none.
  CHECK_FALSE(detail::is_valid_inertia(diagonal(0.1, 0.2, 0.3 + 64 * test::eps * 0.6)));
}

TEST_CASE("require_valid_inertia: says which condition fails, with numbers") {
  Mat3 I = diagonal(2, 3, 4);
  I(0, 1) = 0.5;
  CHECK_REFUSED(detail::require_valid_inertia(I),
                "not symmetric: it differs from its transpose by 0.5");
  CHECK_REFUSED(detail::require_valid_inertia(diagonal(1, 2, 4)), "triangle inequality");
  CHECK_REFUSED(detail::require_valid_inertia(diagonal(1, 2, 4)), "1 + 2 are less than 4, by 1,");
  CHECK_REFUSED(detail::require_valid_inertia(diagonal(1, 1, 2.0000001)),
                "1 + 1 are less than 2.0000001, by 1e-07, so no body has it");
  CHECK_REFUSED(detail::require_valid_inertia(diagonal(1, 1, 2 + 1e-13)),
                "1 + 1 are less than 2, by 1e-13");
  CHECK_REFUSED(detail::require_valid_inertia(diagonal(-1, 2, 2)), "not positive definite");
  CHECK_REFUSED(detail::require_valid_inertia(diagonal(0, 2, 2)), "not positive definite");
  CHECK_REFUSED(detail::require_valid_inertia(Mat3::Zero()), "not positive definite");
  CHECK_REFUSED(detail::require_valid_inertia(-Mat3::Identity()), "not positive definite");
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    I = diagonal(2, 3, 4);
    I(1, 2) = bad;
    CHECK_REFUSED(detail::require_valid_inertia(I), "not a finite number");
  }
}

TEST_CASE("require_valid_inertia: has no unit: a speck of dust and a planet are judged alike") {
  for (const double unit : {1e-40, 1e-12, 1e12, 1e40}) {
    CAPTURE(unit);
    CHECK(detail::is_valid_inertia(unit * diagonal(2, 3, 4)));
    CHECK_FALSE(detail::is_valid_inertia(unit * diagonal(1, 1, 3)));
  }
}

TEST_CASE("require_valid: refuses what is wrong with mass or centre") {
  const MassProperties good{1, Vec3(1, 2, 3), diagonal(2, 3, 4)};
  CHECK_NOTHROW(require_valid(good));
  for (const double mass : {0.0, -2.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    MassProperties bad = good;
    bad.mass = mass;
    CAPTURE(mass);
    CHECK_REFUSED(require_valid(bad), "the mass");
  }
  MassProperties bad = good;
  bad.centre.y() = std::nan("");
  CHECK_REFUSED(require_valid(bad), "centre of mass (1, nan, 3)");
  bad = good;
  bad.inertia(0, 0) = 20;
  CHECK_REFUSED(require_valid(bad), "triangle");
  CHECK_THROWS_AS(require_valid(MassProperties{}), std::invalid_argument);
}
