/// @file
/// 4.1 product: its laws, and what goes wrong.
#include "04_quaternions/contract.hpp"
#include "judge/spec/spec.hpp"
#include "tumble/quaternion/convert.hpp"

using namespace tumble::judge;
using quaternions::Quaternion;

namespace student {
const Function<decltype(quaternions::product)> product{TUMBLE_UNIT};
}

namespace {

Quaternion reference(const Quaternion& a, const Quaternion& b) {
  return tumble::coefficients(tumble::from_coefficients(a) * tumble::from_coefficients(b));
}

/// Four products and three sums a component.
double rounding(const Quaternion& a, const Quaternion& b) { return 8 * eps * a.norm() * b.norm(); }

const Quaternion one(1, 0, 0, 0), i(0, 1, 0, 0), j(0, 0, 1, 0), k(0, 0, 0, 1);

}  // namespace

TEST_SUITE(TUMBLE_UNIT) {
  TEST_CASE("any two quaternions multiply by Hamilton's rule") {
    for (int n = 0; n < 20; ++n) {
      const Quaternion a = any_quaternion(), b = any_quaternion();
      REQUIRE(student::product(a, b) == close_to(reference(a, b), rounding(a, b)));
    }
  }

  TEST_CASE("i j = k, j k = i, k i = j, and the other way round with a minus") {
    REQUIRE(student::product(i, j) == close_to(k, 0));
    REQUIRE(student::product(j, k) == close_to(i, 0));
    REQUIRE(student::product(k, i) == close_to(j, 0));
    REQUIRE(student::product(j, i) == close_to(Quaternion(-k), 0));
  }

  TEST_CASE("i² = j² = k² = −1") {
    for (const Quaternion& unit : {i, j, k})
      REQUIRE(student::product(unit, unit) == close_to(Quaternion(-one), 0));
  }

  TEST_CASE("1 changes nothing, from either side") {
    const Quaternion a = any_quaternion();
    REQUIRE(student::product(one, a) == close_to(a, 0));
    REQUIRE(student::product(a, one) == close_to(a, 0));
  }

  TEST_CASE("zero, tiny and huge factors: nothing is normalised, nothing is lost") {
    const Quaternion a = any_quaternion();
    for (const double size : {0., 1e-150, 1e150}) {
      const Quaternion b = size * any_quaternion();
      REQUIRE(student::product(a, b) == close_to(reference(a, b), rounding(a, b)));
    }
  }
}

const Misconceptions<decltype(quaternions::product)> misconceptions{
    TUMBLE_UNIT,
    {{"operands swapped",
      "This is b a. The product does not commute: look at the sign of the cross product.",
      "The product", [](const Quaternion& a, const Quaternion& b) { return reference(b, a); }},
     {"cross product forgotten",
      "The vector part lacks the term that makes the product depend on the order.", "The product",
      [](const Quaternion& a, const Quaternion& b) -> Quaternion {
        return 0.5 * (reference(a, b) + reference(b, a));
      }},
     {"dot product added", "The scalar part has the wrong sign on u·v: i² must be −1.",
      "The product",
      [](const Quaternion& a, const Quaternion& b) {
        Quaternion c = reference(a, b);
        c[0] = a.dot(b);
        return c;
      }},
     {"multiplied entry by entry",
      "Quaternions do not multiply component by component, as a vector's array product does.",
      "The product",
      [](const Quaternion& a, const Quaternion& b) -> Quaternion { return a.cwiseProduct(b); }},
     {"scalar stored last",
      "The numbers are those of the order (x, y, z, w). Here w comes first: q[0] is the scalar.",
      "Conventions",
      [](const Quaternion& a, const Quaternion& b) -> Quaternion {
        const auto rotated = [](const Quaternion& q) { return Quaternion(q[3], q[0], q[1], q[2]); };
        const Quaternion c = reference(rotated(a), rotated(b));
        return {c[1], c[2], c[3], c[0]};
      }},
     {"normalised",
      "The result was scaled to length 1. The lengths of the factors multiply: |a b| = |a| |b|.",
      "The product", [](const Quaternion& a, const Quaternion& b) -> Quaternion {
        return reference(a, b).normalized();
      }}}};
