#include "tumble/elliptic/integrals.hpp"

#include <doctest/doctest.h>

#include "project/harness/inputs.hpp"

using namespace tumble;
using namespace tumble::detail;
using test::eps;

TEST_CASE("carlson_rf: the values of Carlson's paper, and its symmetry and scale") {
  CHECK(carlson_rf(1, 2, 0) == doctest::Approx(1.3110287771460599052).epsilon(4 * eps));
  CHECK(carlson_rf(0.5, 1, 0) == doctest::Approx(1.8540746773013719184).epsilon(4 * eps));
  CHECK(carlson_rf(2, 3, 4) == doctest::Approx(0.58408284167715170669).epsilon(4 * eps));
  CHECK(carlson_rf(4, 2, 3) == doctest::Approx(carlson_rf(2, 3, 4)).epsilon(4 * eps));
  CHECK(carlson_rf(2e200, 3e200, 4e200) ==
        doctest::Approx(carlson_rf(2, 3, 4) * 1e-100).epsilon(8 * eps));
  CHECK(carlson_rf(3, 3, 3) == doctest::Approx(1 / std::sqrt(3)).epsilon(4 * eps));
  CHECK(std::isinf(carlson_rf(0, 0, 1)));
}

TEST_CASE("complete_elliptic_k: at both ends and between") {
  CHECK(elliptic::complete_elliptic_k(1) == doctest::Approx(std::numbers::pi / 2).epsilon(eps));
  CHECK(elliptic::complete_elliptic_k(std::sqrt(0.5)) ==
        doctest::Approx(1.8540746773013719184).epsilon(4 * eps));
  CHECK(elliptic::complete_elliptic_k(1e-12) == doctest::Approx(std::log(4e12)).epsilon(4 * eps));
  CHECK(elliptic::complete_elliptic_k(0.3) ==
        doctest::Approx(carlson_rf(0, 0.09, 1)).epsilon(8 * eps));
  CHECK(std::isinf(elliptic::complete_elliptic_k(0)));
}
