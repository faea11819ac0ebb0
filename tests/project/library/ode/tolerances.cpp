#include "tumble/ode/tolerances.hpp"

#include <doctest/doctest.h>

#include <limits>

#include "problems.hpp"

using namespace tumble;
using test::contains;
using test::message_of;

TEST_CASE("error_norm: a worked number") {
  // Allowed: 0.1 + 0.5·2 = 1.1 and 0.1 + 0.5·4 = 2.1; ratios 2 and 1; √((4 + 1)/2).
  const Eigen::Vector2d error(2.2, -2.1), y0(2, -4), y1(-1, 3);
  const double norm = runge_kutta::error_norm(error, y0, y1, {0.5, 0.1});
  CHECK(std::abs(norm - std::sqrt(2.5)) <= 8 * test::eps);
}

TEST_CASE("error_norm: in proportion to the error, whichever way the step goes") {
  test::Random rng(41);
  for (int i = 0; i < 200; ++i) {
    const Vec3 error = rng.vector(), y0 = rng.vector(), y1 = rng.vector();
    const double factor = rng.uniform(0, 9);
    CAPTURE(factor);
    const double norm = runge_kutta::error_norm(error, y0, y1, {});
    CHECK(std::abs(runge_kutta::error_norm(Vec3(factor * error), y0, y1, {}) - factor * norm) <=
          8 * test::eps * factor * norm);
    CHECK(runge_kutta::error_norm(error, y1, y0, {}) == norm);
  }
}

TEST_CASE("error_norm: exactly what is allowed has the norm 1, however many components") {
  for (const int n : {1, 2, 13, 600}) {
    CAPTURE(n);
    const Eigen::VectorXd y = Eigen::VectorXd::Constant(n, 3), zero = Eigen::VectorXd::Zero(n);
    const Tolerances tolerances{1e-3, 1e-4};
    CHECK(std::abs(runge_kutta::error_norm(Eigen::VectorXd::Constant(n, 1e-4 + 3e-3).eval(), zero,
                                           y, tolerances) -
                   1) <= (n + 4) * test::eps);
    CHECK(runge_kutta::error_norm(zero, zero, zero, tolerances) == 0);
  }
  CHECK(runge_kutta::error_norm(Eigen::VectorXd(), Eigen::VectorXd(), Eigen::VectorXd(), {}) == 0);
}

TEST_CASE("error_norm: NaN stays NaN") {
  const Vec3 y(1, 2, 3);
  CHECK(std::isnan(runge_kutta::error_norm(Vec3(0, std::nan(""), 0), y, y, {})));
}

TEST_CASE("require_valid: tolerances are positive and finite, also in the state's scalar") {
  const auto run = [](double relative, double absolute) {
    return message_of<std::invalid_argument>([&] {
      require_valid(Tolerances{relative, absolute});
    });
  };
  CHECK(run(1e-6, 1e-9) == "");
  CHECK(contains(run(0, 1e-9), "relative = 0 is"));
  CHECK(contains(run(-1e-3, 1e-9), "relative = -0.001"));
  CHECK(contains(run(std::nan(""), 1e-9), "relative = nan"));
  CHECK(contains(run(1e-6, 0), "absolute = 0 is"));
  CHECK(contains(run(1e-6, std::numeric_limits<double>::infinity()), "absolute = inf"));
  CHECK(contains(message_of<std::invalid_argument>([] {
                   require_valid<float>({1e-6, 1e-60});
                 }),
                 "absolute = 1e-60"));
}
