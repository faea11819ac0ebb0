#include "tumble/ode/jacobian.hpp"

#include <doctest/doctest.h>

#include "problems.hpp"

using namespace tumble;
using namespace tumble::detail;
using test::contains;
using test::message_of;

namespace {

const auto f = [](double t, const Vec3& y) -> Vec3 {
  return {y[0] * y[1], std::sin(y[2]) + t, y[0] * y[0] * y[2]};
};
const auto exact = [](double, const Vec3& y) -> Mat3 {
  Mat3 J;
  J << y[1], y[0], 0, 0, 0, std::cos(y[2]), 2 * y[0] * y[2], 0, y[0] * y[0];
  return J;
};

}  // namespace

static_assert(!KnowsJacobian<decltype(f), Vec3>);
static_assert(KnowsJacobian<decltype(with_jacobian(f, exact)), Vec3>);

TEST_CASE("finite_difference_jacobian: a worked number, and one evaluation a component") {
  int calls = 0;
  const auto linear = [&](double, const Eigen::Vector2d& y) -> Eigen::Vector2d {
    ++calls;
    return {2 * y[0] + 3 * y[1], -y[0]};
  };
  const Eigen::Vector2d y(4, 5), dydt(23, -4);
  const Eigen::Matrix2d J = finite_difference_jacobian(linear, 0, y, dydt, 0.1);
  CHECK(calls == 2);
  const Eigen::Matrix2d expected = (Eigen::Matrix2d() << 2, 3, -1, 0).finished();
  // Rounding of f, about 23·2 eps, over a shift of 4 √(2 eps).
  CHECK((J - expected).cwiseAbs().maxCoeff() <= 46 * test::eps / (4 * std::sqrt(2 * test::eps)));
}

TEST_CASE("finite_difference_jacobian: close to the exact one at all scales") {
  test::Random rng(71);
  for (const double scale : {1e-12, 1e-6, 1.0, 1e3}) {
    for (int i = 0; i < 50; ++i) {
      const Vec3 y = scale * rng.vector();
      CAPTURE(y.transpose());
      const Mat3 J = finite_difference_jacobian(f, 0, y, f(0, y), 0);
      // √ε times the second derivatives times y, and rounding of f over the shift √ε y.
      const double root = std::sqrt(2 * test::eps);
      const double second = 2 * std::max(1.0, scale * scale) * scale;
      const double smallest = std::max(y.cwiseAbs().minCoeff(), root * y.cwiseAbs().maxCoeff());
      const double rounding = 4 * test::eps * f(0, y).norm() / (root * smallest);
      CHECK((J - exact(0, y)).norm() <= 3 * root * second + rounding);
    }
  }
}

TEST_CASE("finite_difference_jacobian: at rest at zero, it still shifts") {
  const auto linear = [](double, const Vec3& y) -> Vec3 { return 7 * y; };
  const Vec3 zero = Vec3::Zero();
  CHECK((finite_difference_jacobian(linear, 0, zero, zero, 1) - 7 * Mat3::Identity()).norm() <=
        16 * test::eps);
}

TEST_CASE("jacobian: is the user's where there is one") {
  const Vec3 y(1, 2, 3);
  int calls = 0;
  const auto counted = [&](double t, const Vec3& x) {
    ++calls;
    return f(t, x);
  };
  CHECK(jacobian(with_jacobian(counted, exact), 0, y, f(0, y), 1) == exact(0, y));
  CHECK(calls == 0);
  CHECK(with_jacobian(f, exact)(0.5, y) == f(0.5, y));
}

TEST_CASE("jacobian: refuses one of another size") {
  const auto g = [](double, const Eigen::VectorXd& y) -> Eigen::VectorXd { return y; };
  const auto J = [](double, const Eigen::VectorXd&) -> Eigen::MatrixXd {
    return Eigen::MatrixXd::Zero(2, 3);
  };
  const Eigen::VectorXd y = Eigen::VectorXd::Ones(3);
  CHECK(contains(
      message_of<std::invalid_argument>([&] { jacobian(with_jacobian(g, J), 0, y, y, 1); }),
      "2 x 3, but the state has 3"));
}
