#include "tumble/ode/backward_euler.hpp"

#include <doctest/doctest.h>

#include "problems.hpp"

using namespace tumble;
using test::contains;
using test::message_of;

TEST_CASE("backward_euler_step: a worked number") {
  // y' = −4 y with h = 1/4: y1 = y/(1 + h·4) = y/2.
  const auto f = [](double, const test::Vector1<double>& y) -> test::Vector1<double> {
    return -4 * y;
  };
  CHECK(std::abs(runge_kutta::backward_euler_step(f, 0, test::Vector1<double>(6.0), 0.25)[0] - 3) <=
        8 * 3 * test::eps);
}

TEST_CASE("backward_euler_step: solves y1 = y + h f(t + h, y1), to rounding") {
  const auto f = [](double t, const Vec3& y) -> Vec3 {
    return {y[1] * y[2] - t, std::sin(y[0]), -y[2] * y[2] * y[2]};
  };
  test::Random rng(81);
  for (int i = 0; i < 200; ++i) {
    const Vec3 y = rng.vector();
    const double t = rng.uniform(), h = rng.uniform(-0.1, 0.3);
    CAPTURE(y.transpose());
    CAPTURE(h);
    const Vec3 y1 = runge_kutta::backward_euler_step(f, t, y, h);
    // What Newton leaves is the square of a last correction of √ε, times second
    // derivatives below 6.
    CHECK((y1 - y - h * f(t + h, y1)).norm() <= 40 * test::eps * (1 + y.norm()));
  }
}

TEST_CASE("backward_euler_step: however stiff, the step decays") {
  for (const double stiffness : {1.0, 1e3, 1e6, 1e9, 1e12}) {
    CAPTURE(stiffness);
    const auto f = [&](double, const test::Vector1<double>& y) -> test::Vector1<double> {
      return -stiffness * y;
    };
    const double y1 = runge_kutta::backward_euler_step(f, 0, test::Vector1<double>(1.0), 1)[0];
    // 1 − (1 − 1/(1 + k)) is found with the rounding of 1.
    CHECK(std::abs(y1 - 1 / (1 + stiffness)) <= 8 * test::eps);
    // Where Euler's own method would multiply by 1 − k.
    CHECK(std::abs(runge_kutta::euler_step(f, 0, test::Vector1<double>(1.0), 1)[0]) >=
          stiffness - 1);
  }
}

TEST_CASE("backward_euler_step: takes the user's Jacobian and then asks f only along the way") {
  int calls = 0;
  const auto f = [&](double, const Vec3& y) -> Vec3 {
    ++calls;
    return -2 * y;
  };
  const auto J = [](double, const Vec3&) -> Mat3 { return -2 * Mat3::Identity(); };
  const Vec3 y(1, 2, 3);
  CHECK((runge_kutta::backward_euler_step(with_jacobian(f, J), 0, y, 0.5) - y / 2).norm() <=
        16 * test::eps);
  // Linear with its exact Jacobian: one correction, and one that shows it was enough.
  CHECK(calls == 2);
}

TEST_CASE("backward_euler_step: says where there is no solution") {
  // y1 = 1 + y1² has none.
  const auto f = [](double, const test::Vector1<double>& y) -> test::Vector1<double> {
    return y.cwiseProduct(y);
  };
  const std::string message = message_of<std::runtime_error>(
      [&] { runge_kutta::backward_euler_step(f, 2.5, test::Vector1<double>(1.0), 1); });
  CHECK(contains(message, "does not converge from t = 2.5 with h = 1"));
  CHECK(contains(message, "shorter step"));
  // With h = 1/2 the first matrix, 1 − 2 h y, is singular, and the correction infinite.
  const std::string singular = message_of<std::runtime_error>(
      [&] { runge_kutta::backward_euler_step(f, 0, test::Vector1<double>(1.0), 0.5); });
  CHECK(contains(singular, "does not converge"));
}

TEST_CASE("backward_euler_step: refuses where f has no value") {
  const auto f = [](double, const test::Vector1<double>& y) -> test::Vector1<double> {
    return y.array().sqrt() - 10;
  };
  CHECK_THROWS_AS(runge_kutta::backward_euler_step(f, 0, test::Vector1<double>(1.0), 0.5),
                  std::runtime_error);
}
