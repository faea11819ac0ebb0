#include "tumble/ode/euler.hpp"

#include <doctest/doctest.h>

#include "project/harness/inputs.hpp"

using namespace tumble;

static_assert(OdeState<Vec3> && OdeState<Eigen::VectorXf> && !OdeState<Mat3> && !OdeState<double>);

TEST_CASE("euler_step: a worked number") {
  // y' = t + y at t = 1, y = 2 has the slope 3.
  const auto f = [](double t, const Eigen::Vector2d& y) -> Eigen::Vector2d {
    return y.array() + t;
  };
  const Eigen::Vector2d y(2, 4);
  CHECK(runge_kutta::euler_step(f, 1, y, 0.5) == Eigen::Vector2d(3.5, 6.5));
  CHECK(runge_kutta::Euler::step(f, 1, y, 0.5) == runge_kutta::euler_step(f, 1, y, 0.5));
}

TEST_CASE("euler_step: exact where the slope is constant, forwards and backwards") {
  test::Random rng(21);
  for (int i = 0; i < 200; ++i) {
    const Vec3 slope = rng.vector(), y = rng.vector();
    const double h = rng.uniform(-2, 2);
    CAPTURE(h);
    const Vec3 y1 = runge_kutta::euler_step([&](double, const Vec3&) { return slope; }, 0, y, h);
    // One product and one sum, each rounded once.
    CHECK((y1 - (y + h * slope)).norm() <= 4 * test::eps * (y.norm() + std::abs(h) * slope.norm()));
    CHECK(runge_kutta::euler_step([&](double, const Vec3&) { return slope; }, 0, y, 0.0) == y);
  }
}

TEST_CASE("euler_step: asks f once, and takes float and dynamic states") {
  int calls = 0;
  const auto f = [&](float, const Eigen::VectorXf& y) -> Eigen::VectorXf {
    ++calls;
    return -y;
  };
  const Eigen::VectorXf y = Eigen::VectorXf::Constant(5, 2.0f);
  CHECK(runge_kutta::euler_step(f, 0.0f, y, 0.25f) == Eigen::VectorXf::Constant(5, 1.5f));
  CHECK(calls == 1);
}
