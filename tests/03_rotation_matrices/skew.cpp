/// @file
/// 3.2 skew: its laws, and what goes wrong.
#include "tumble/rotation/skew.hpp"
#include <tuple>

#include "03_rotation_matrices/contract.hpp"
#include "judge/spec/spec.hpp"

using namespace tumble::judge;
using tumble::Mat3;
using tumble::Vec3;

namespace student {
const Function<decltype(rotation_matrices::skew)> skew{TUMBLE_UNIT};
}

namespace {

const Vec3 e_x = Vec3::UnitX(), e_y = Vec3::UnitY(), e_z = Vec3::UnitZ();

}  // namespace

TEST_SUITE(TUMBLE_UNIT) {
  TEST_CASE("the numbers of any vector are in their places, unrounded") {
    for (int n = 0; n < 20; ++n) {
      const Vec3 a = any_vector(10);
      REQUIRE(student::skew(a) == close_to(tumble::rotation::skew(a), 0));
    }
  }

  TEST_CASE("the matrix of a times b is a × b") {
    for (int n = 0; n < 20; ++n) {
      const Vec3 a = any_vector(), b = any_vector();
      const auto S = student::skew(a);
      // Two products and a sum a component, on either side.
      REQUIRE(S == obeys("skew(a) b = a × b", (S.value() * b - a.cross(b)).norm(),
                         8 * eps * a.norm() * b.norm()));
    }
  }

  TEST_CASE("x × y = z, y × z = x, z × x = y, and the other way round with a minus") {
    for (const auto& [a, b, c] :
         {std::tuple(e_x, e_y, e_z), std::tuple(e_y, e_z, e_x), std::tuple(e_z, e_x, e_y)}) {
      const Mat3 turned = c * b.transpose() - b * c.transpose();  // b ↦ c, c ↦ −b
      REQUIRE(student::skew(a) == close_to(turned, 0));
      REQUIRE(student::skew(-a) == close_to(Mat3(-turned), 0));
    }
  }

  TEST_CASE("the transpose is the negative, and a × a = 0") {
    for (int n = 0; n < 20; ++n) {
      const Vec3 a = any_vector();
      const auto S = student::skew(a);
      REQUIRE(S == obeys("Sᵀ = −S", (S.value() + S.value().transpose()).norm(), 0));
      REQUIRE(S == obeys("S a = 0", (S.value() * a).norm(), 4 * eps * a.squaredNorm()));
    }
  }

  TEST_CASE("zero, tiny and huge vectors: the numbers are in their places as they are") {
    for (const double size : {0., 1e-300, 1e-8, 1e150, 1e300}) {
      const Vec3 a = any_vector(size);
      REQUIRE(student::skew(a) == close_to(tumble::rotation::skew(a), 0));
    }
  }
}

const Misconceptions<decltype(rotation_matrices::skew)> misconceptions{
    TUMBLE_UNIT,
    {{"transposed",
      "All signs are the other way round: your matrix makes b × a. Write out the first component "
      "of a × b and compare it with your first row. If your signs are right, Eigen may have read a "
      "C array column by column: it stores matrices so.",
      "Angular velocity",
      [](const Vec3& a) -> Mat3 { return tumble::rotation::skew(a).transpose(); }},
     {"minus signs forgotten",
      "Your matrix is symmetric. Each component of a cross product is a difference, so in each row "
      "one of the two numbers has a minus.",
      "Angular velocity",
      [](const Vec3& a) -> Mat3 {
        Mat3 S;
        // clang-format off
        S <<   0.,  a.z(), a.y(),
            a.z(),     0., a.x(),
            a.y(),  a.x(),    0.;
        // clang-format on
        return S;
      }},
     {"sign of y",
      "The two places of a's y component have the wrong sign. The second component of a cross "
      "product begins with z: z, x is its order, not x, z.",
      "Angular velocity",
      [](const Vec3& a) -> Mat3 {
        return tumble::rotation::skew<double>({a.x(), -a.y(), a.z()});
      }},
     {"sign of x",
      "The two places of a's x component have the wrong sign. The first component of a cross "
      "product is y times z minus z times y.",
      "Angular velocity",
      [](const Vec3& a) -> Mat3 {
        return tumble::rotation::skew<double>({-a.x(), a.y(), a.z()});
      }},
     {"sign of z",
      "The two places of a's z component have the wrong sign. The third component of a cross "
      "product is x times y minus y times x.",
      "Angular velocity",
      [](const Vec3& a) -> Mat3 {
        return tumble::rotation::skew<double>({a.x(), a.y(), -a.z()});
      }},
     {"x and y swapped",
      "You have exchanged the x and y components of a. The row for x holds everything "
      "but a's x component.",
      "Angular velocity",
      [](const Vec3& a) -> Mat3 {
        return tumble::rotation::skew<double>({a.y(), a.x(), a.z()});
      }},
     {"ones on the diagonal",
      "There are ones on the diagonal, as in a rotation matrix. In a cross product no component of "
      "b stays in its place.",
      "Angular velocity",
      [](const Vec3& a) -> Mat3 { return tumble::rotation::skew(a) + Mat3::Identity(); }},
     {"x and z swapped",
      "You have filled in the components in the order in which you read them, x first. But the row "
      "for x holds everything but a's x component.",
      "Angular velocity",
      [](const Vec3& a) -> Mat3 {
        return tumble::rotation::skew<double>({a.z(), a.y(), a.x()});
      }},
     {"one half only",
      "The numbers below the diagonal are missing: each component of a appears in the matrix "
      "twice.",
      "Angular velocity",
      [](const Vec3& a) -> Mat3 {
        Mat3 S = tumble::rotation::skew(a);
        S(1, 0) = S(2, 0) = S(2, 1) = 0;
        return S;
      }},
     {"on the diagonal",
      "A diagonal matrix multiplies component by component. In a cross product no component of b "
      "stays in its place: the diagonal is empty.",
      "Angular velocity", [](const Vec3& a) -> Mat3 { return a.asDiagonal(); }},
     {"normalised",
      "You have scaled the vector to length 1. A cross product grows with its factors, and ω has "
      "the speed of the turn in its length.",
      "Angular velocity",
      [](const Vec3& a) -> Mat3 { return tumble::rotation::skew(Vec3(a.normalized())); }}}};
