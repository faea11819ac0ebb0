#include "tumble/ode/c_interface.hpp"

#include <doctest/doctest.h>

#include <array>

#include "problems.hpp"

using namespace tumble;
using test::contains;
using test::message_of;

namespace {

/// A ball thrown up: y = (position, velocity).
void dydt(double, const double y[], double ydot[]) {
  for (int i = 0; i < 3; ++i) {
    ydot[i] = y[i + 3];
    ydot[i + 3] = 0;
  }
  ydot[5] = -10;
}

/// An oscillator whose author did not write const, and scribbles on Y.
void DYDT(double, double Y[], double dY[]) {
  dY[0] = Y[1];
  dY[1] = -Y[0];
  Y[0] = Y[1] = 99;
}

typedef void (*DYDTFun)(double t, double Y[], double dY[]);

}  // namespace

TEST_CASE("ode(y0, t0, tf, dydt): a worked number, from whatever holds numbers") {
  // After 2 s: x = 3·2, z = 20·2 − 5·4.
  const std::vector<double> expected{6, 0, 20, 3, 0, 0};
  double array[6] = {0, 0, 0, 3, 0, 20};
  const double constant[6] = {0, 0, 0, 3, 0, 20};
  const std::vector<double> vector(array, array + 6);
  const std::array<double, 6> fixed{0, 0, 0, 3, 0, 20};
  const auto check = [&](const std::vector<double>& y) {
    REQUIRE(y.size() == 6);
    // A polynomial of degree 2 has no error but rounding, of numbers below 40 in a few steps.
    for (std::size_t i = 0; i < 6; ++i) CHECK(std::abs(y[i] - expected[i]) <= 400 * test::eps);
  };
  check(ode(array, 0.0, 2.0, dydt));
  check(ode(array, 0.0, 2, dydt, Tolerances{1e-3, 1e-3}));
  check(ode(constant, 0, 2, dydt));
  check(ode(vector, 0, 2, dydt));
  check(ode(fixed, 0, 2, dydt));
  check(ode(std::span<const double>(array), 0, 2, &dydt));
  CHECK(array[2] == 0);
}

TEST_CASE("ode: is DormandPrince54 with the tolerances that are given") {
  const std::vector<double> y0{1, 0};
  const auto typed = [](double, const Eigen::Vector2d& y) -> Eigen::Vector2d {
    return {y[1], -y[0]};
  };
  for (const double tolerance : {1e-3, 1e-6, 1e-12}) {
    CAPTURE(tolerance);
    const Tolerances tolerances{tolerance, tolerance};
    const std::vector<double> y = ode(y0, 0, 7, DYDT, tolerances);
    CHECK(Eigen::Vector2d(y[0], y[1]) ==
          integrate_adaptive<DormandPrince54>(typed, Eigen::Vector2d(1, 0), 0, 7, tolerances).y);
  }
  CHECK(ode(y0, 0, 7, DYDT) == ode(y0, 0, 7, DYDT, Tolerances{1e-6, 1e-9}));
}

TEST_CASE("ode(Y, len, h, dydt): one step of RK4 in place") {
  double Y[2] = {1, 0};
  const DYDTFun function = DYDT;
  ode(Y, 2, 0.1, function);
  const Eigen::Vector2d expected =
      runge_kutta::rk4_step(rhs_from_c(DYDT), 0, Eigen::Vector2d(1, 0), 0.1);
  CHECK(Y[0] == expected[0]);
  CHECK(Y[1] == expected[1]);
  // The local error of cos is h⁵/120·(something below 1).
  CHECK(std::abs(Y[0] - std::cos(0.1)) <= std::pow(0.1, 5) / 120);

  double ball[6] = {0, 0, 0, 3, 0, 20};
  for (int i = 0; i < 20; ++i) ode(ball, 6, 0.1, dydt);
  CHECK(std::abs(ball[2] - 20) <= 20 * 20 * 4 * test::eps);
}

TEST_CASE("ode(x0, xEnd, len, t0, t1, dxdt): the end in another array, or in the same") {
  double x[2] = {1, 0}, end[2] = {7, 7};
  ode(x, end, 2, 0.0, 3.0, DYDT);
  const std::vector<double> expected = ode(x, 0.0, 3.0, DYDT);
  CHECK(end[0] == expected[0]);
  CHECK(end[1] == expected[1]);
  CHECK(x[0] == 1);
  ode(x, x, 2, 0, 3, DYDT);
  CHECK(x[0] == expected[0]);
}

TEST_CASE("rhs_from_c: a C function for every method, and back") {
  const auto rhs = rhs_from_c(dydt);
  using State = Eigen::Matrix<double, 6, 1>;
  State y;
  y << 0, 0, 0, 3, 0, 20;
  CHECK(std::abs(integrate_adaptive<Radau5>(rhs, y, 0, 2).y[2] - 20) <= 40 * 1e-6);
  CHECK(rhs(0, Eigen::VectorXd(y)) == Eigen::VectorXd(rhs(0, y)));
  const auto back = [&](double t, const double from[], double to[]) {
    Eigen::Map<State>{to} = rhs(t, State(Eigen::Map<const State>(from)));
  };
  CHECK(ode(std::vector<double>(y.data(), y.data() + 6), 0, 2, back) ==
        ode(std::vector<double>(y.data(), y.data() + 6), 0, 2, dydt));
}

TEST_CASE("ode: refuses what is wrong, and finds what dydt forgot to write") {
  double Y[2] = {1, 0}, bad[2] = {1, std::nan("")};
  const auto invalid = [](auto&& f) { return message_of<std::invalid_argument>(f); };
  CHECK(contains(invalid([&] { ode(Y, 0, 0.1, DYDT); }), "len = 0"));
  CHECK(contains(invalid([&] { ode(Y, 2, INFINITY, DYDT); }), "h = inf"));
  CHECK(contains(invalid([&] { ode(bad, 2, 0.1, DYDT); }), "Y = (  1 nan)"));
  CHECK(contains(invalid([&] { ode(bad, 0.0, 1.0, DYDT); }), "y0 = (  1 nan)"));
  CHECK(contains(invalid([&] { ode(Y, Y, -1, 0, 1, DYDT); }), "len = -1"));
  CHECK(contains(invalid([&] { ode(Y, 0.0, 1.0, DYDT, Tolerances{0, 1}); }), "relative = 0"));
  const auto forgetful = [](double, const double y[], double ydot[]) { ydot[0] = y[1]; };
  CHECK(contains(message_of<std::runtime_error>([&] { ode(Y, 0.0, 1.0, forgetful); }),
                 "dydt is not finite at t = 0"));
}
