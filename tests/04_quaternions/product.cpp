/// @file
/// 4.1 product: its laws, and what goes wrong.
#include "04_quaternions/contract.hpp"
#include "judge/spec/shared/quaternion_reference.hpp"
#include "judge/spec/spec.hpp"

using namespace tumble::judge;
using quaternions::Quaternion;

namespace student {
const Function<decltype(quaternions::product)> product{TUMBLE_UNIT};
}

namespace {

using reference::i, reference::j, reference::k, reference::one;

/// Four products and three sums a component are 4 roundings of at most |a| |b|, and as many in the
/// reference; twice that for other ways to sum.
double rounding(const Quaternion& a, const Quaternion& b) { return 16 * eps * a.norm() * b.norm(); }

}  // namespace

TEST_SUITE(TUMBLE_UNIT) {
  TEST_CASE("any two quaternions multiply by Hamilton's rule") {
    for (int n = 0; n < 20; ++n) {
      const Quaternion a = any_quaternion(), b = any_quaternion();
      REQUIRE(student::product(a, b) == close_to(reference::product(a, b), rounding(a, b)));
    }
  }

  TEST_CASE("i j = k, j k = i, k i = j, and the other way round with a minus") {
    REQUIRE(student::product(i, j) == close_to(k, rounding(i, j)));
    REQUIRE(student::product(j, k) == close_to(i, rounding(j, k)));
    REQUIRE(student::product(k, i) == close_to(j, rounding(k, i)));
    REQUIRE(student::product(j, i) == close_to(Quaternion(-k), rounding(j, i)));
    REQUIRE(student::product(k, j) == close_to(Quaternion(-i), rounding(k, j)));
    REQUIRE(student::product(i, k) == close_to(Quaternion(-j), rounding(i, k)));
  }

  TEST_CASE("i² = j² = k² = −1") {
    for (const Quaternion& unit : {i, j, k})
      REQUIRE(student::product(unit, unit) == close_to(Quaternion(-one), rounding(unit, unit)));
  }

  TEST_CASE("1 changes nothing, from either side; what is only close to 1 changes a little") {
    const Quaternion a = any_quaternion();
    REQUIRE(student::product(one, a) == close_to(a, rounding(one, a)));
    REQUIRE(student::product(a, one) == close_to(a, rounding(a, one)));
    // What is close to 1, as the turn of a short step, is not 1.
    for (const double small : {1e-13, 1e-10, 1e-7}) {
      const Quaternion b = one + small * any_quaternion();
      REQUIRE(student::product(a, b) == close_to(reference::product(a, b), rounding(a, b)));
      REQUIRE(student::product(b, a) == close_to(reference::product(b, a), rounding(b, a)));
    }
  }

  TEST_CASE("zero, tiny and huge factors: nothing is normalised, nothing is lost") {
    const Quaternion a = any_quaternion();
    for (const double size : {0., 1e-150, 1e150}) {
      const Quaternion b = size * any_quaternion();
      REQUIRE(student::product(a, b) == close_to(reference::product(a, b), rounding(a, b)));
      REQUIRE(student::product(b, a) == close_to(reference::product(b, a), rounding(b, a)));
    }
  }
}

const Misconceptions<decltype(quaternions::product)> misconceptions{
    TUMBLE_UNIT,
    {{"operands swapped",
      "This is b a. The product does not commute: look at the sign of your cross product.",
      "The product",
      [](const Quaternion& a, const Quaternion& b) { return reference::product(b, a); }},
     {"cross product forgotten",
      "Your vector part lacks the term that makes the product depend on the order.", "The product",
      [](const Quaternion& a, const Quaternion& b) -> Quaternion {
        return 0.5 * (reference::product(a, b) + reference::product(b, a));
      }},
     {"cross product with a wrong sign in y",
      "The y component of your cross product has the wrong sign; x and z are right. The three "
      "follow from each other if you go round x → y → z → x.",
      "The product",
      [](const Quaternion& a, const Quaternion& b) {
        Quaternion c = reference::product(a, b);
        c[2] = reference::product(b, a)[2];
        return c;
      }},
     {"dot product added", "Your scalar part has the wrong sign on u·v: i² must be −1.",
      "The product",
      [](const Quaternion& a, const Quaternion& b) {
        Quaternion c = reference::product(a, b);
        c[0] = a.dot(b);
        return c;
      }},
     {"dot product forgotten",
      "Your scalar part is the product of the scalars alone. The vector parts add to it: i² is "
      "−1.",
      "The product",
      [](const Quaternion& a, const Quaternion& b) {
        Quaternion c = reference::product(a, b);
        c[0] = a[0] * b[0];
        return c;
      }},
     {"no scalar part",
      "Your vector part is right, but the scalar part is always 0. Two vectors, too, have a "
      "product with a scalar part: i² = −1.",
      "The product",
      [](const Quaternion& a, const Quaternion& b) {
        Quaternion c = reference::product(a, b);
        c[0] = 0;
        return c;
      }},
     {"second factor conjugated",
      "This is a times the conjugate of b. A product takes both factors as they are.",
      "The product",
      [](const Quaternion& a, const Quaternion& b) {
        return reference::product(a, reference::conjugate(b));
      }},
     {"multiplied entry by entry",
      "You have multiplied component by component, like two arrays. In a product of quaternions "
      "every number meets every other.",
      "The product",
      [](const Quaternion& a, const Quaternion& b) -> Quaternion { return a.cwiseProduct(b); }},
     {"scalar stored last",
      "Your numbers are those of the order (x, y, z, w). Here w comes first: q[0] is the scalar.",
      "Conventions",
      [](const Quaternion& a, const Quaternion& b) {
        return reference::store_scalar_last(
            reference::product(reference::read_scalar_last(a), reference::read_scalar_last(b)));
      }},
     {"scalar read from the end",
      "You read w where z is, and store it first. A Quaternion is an Eigen::Vector4d, and w() of a "
      "Vector4d is the last of its four numbers. Here q[0] is the scalar.",
      "Conventions",
      [](const Quaternion& a, const Quaternion& b) {
        return reference::product(reference::read_scalar_last(a), reference::read_scalar_last(b));
      }},
     {"normalised",
      "You have scaled the result to length 1. The lengths of the factors multiply: |a b| = |a| "
      "|b|.",
      "The product", [](const Quaternion& a, const Quaternion& b) -> Quaternion {
        return reference::product(a, b).normalized();
      }}}};
