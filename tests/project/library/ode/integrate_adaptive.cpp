#include "tumble/ode/integrate_adaptive.hpp"

#include <doctest/doctest.h>

#include "problems.hpp"

using namespace tumble;

namespace {

using State1 = test::Vector1<double>;
using State4 = test::Vector4<double>;

}  // namespace

TEST_CASE_TEMPLATE("integrate_adaptive: the error follows the tolerance", Method, DormandPrince54,
                   Dop853, Radau5) {
  const test::Kepler<double> kepler;
  const double t1 = 2.5;  // not half a revolution, where some errors cancel
  const State4 exact = integrate_adaptive<Dop853>(kepler, kepler.start(), 0, t1, {1e-13, 1e-13}).y;
  std::vector<double> tolerances, errors;
  for (const double tolerance : {1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9}) {
    const auto solution =
        integrate_adaptive<Method>(kepler, kepler.start(), 0, t1, {tolerance, tolerance});
    CAPTURE(tolerance);
    // The error of a step is within the tolerance; on the way they grow and add up, here to less
    // than a hundredfold.
    const double error = (solution.y - exact).norm();
    CHECK(error <= 100 * tolerance);
    tolerances.push_back(tolerance);
    errors.push_back(error);
  }
  // The step goes as tolerance^(1/(q+1)) and the error as its p-th power.
  const double power = Method::order / (Method::error_order + 1.0);
  // As the number of steps is whole and small, the line through the errors is not straight.
  CHECK(std::abs(runge_kutta::observed_order(tolerances, errors) - power) <= 0.35);
}

TEST_CASE_TEMPLATE("integrate_adaptive: backwards in time it comes back", Method, DormandPrince54,
                   Dop853, Radau5) {
  const test::Kepler<double> kepler;
  const auto back =
      integrate_adaptive<Method>(kepler, kepler.exact(), kepler.end, 0, Tolerances{1e-8, 1e-8});
  CHECK((back.y - kepler.start()).norm() <= 100 * 1e-8);
  CHECK(back.steps > 0);
}

TEST_CASE_TEMPLATE("integrate_adaptive: a late start costs no digits", Method, DormandPrince54,
                   Dop853, Radau5) {
  const test::Kepler<double> kepler;
  const auto end = [&](double t0) {
    return integrate_adaptive<Method>(kepler, kepler.start(), t0, t0 + 2.5, {1e-12, 1e-12}).y;
  };
  CHECK((end(0x1p27) - end(0)).norm() <= 1e-11);  // times lie 3e-8 s apart there
}

TEST_CASE_TEMPLATE("integrate_adaptive: no time, no step, not even an evaluation", Method,
                   DormandPrince54, Dop853, Radau5) {
  const test::Kepler<double> kepler;
  const auto solution = integrate_adaptive<Method>(kepler, kepler.start(), 3, 3);
  CHECK(solution.y == kepler.start());
  CHECK(solution.steps == 0);
  CHECK(solution.evaluations == 0);
}

TEST_CASE_TEMPLATE("integrate_adaptive: the observer sees each accepted step, the last at t1",
                   Method, DormandPrince54, Dop853, Radau5) {
  const test::Kepler<double> kepler;
  std::vector<double> times;
  State4 last;
  const auto solution = integrate_adaptive<Method>(kepler, kepler.start(), 0.5, -2, {},
                                                   [&](double t, const State4& y) {
                                                     times.push_back(t);
                                                     last = y;
                                                   });
  CHECK(static_cast<int>(times.size()) == solution.steps);
  CHECK(times.front() < 0.5);
  CHECK(std::is_sorted(times.rbegin(), times.rend()));
  CHECK(times.back() == -2);
  CHECK(last == solution.y);
}

TEST_CASE("integrate_adaptive: counts what it asks, and asks no more than it needs") {
  int calls = 0;
  const test::Kepler<double> kepler;
  const auto f = [&](double t, const State4& y) {
    ++calls;
    return kepler(t, y);
  };
  const auto dp = integrate_adaptive<DormandPrince54>(f, kepler.start(), 0, 20);
  CHECK(dp.evaluations == calls);
  // Two to start, six a step: the seventh stage is the first of the next step.
  CHECK(dp.evaluations == 2 + 6 * (dp.steps + dp.rejected));
  CHECK(dp.rejected > 0);

  calls = 0;
  const auto dop = integrate_adaptive<Dop853>(f, kepler.start(), 0, 20, {1e-8, 1e-8});
  CHECK(dop.evaluations == calls);
  // A rejected step of Dop853 does without f at its end.
  CHECK(dop.evaluations == 2 + 12 * dop.steps + 11 * dop.rejected);
  CHECK(dop.rejected > 0);

  calls = 0;
  CHECK(integrate_adaptive<Radau5>(f, kepler.start(), 0, 1).evaluations == calls);
}

TEST_CASE("integrate_adaptive: float and long double, fixed and dynamic states") {
  const test::Rational<float> f;
  const auto in_float = integrate_adaptive<DormandPrince54>(f, f.start(), 0, 1, {1e-5, 1e-6});
  CHECK(std::abs(in_float.y[0] - 0.5f) <= 10 * 1e-5f);
  const test::Rational<long double> l;
  const auto in_long = integrate_adaptive<Dop853>(l, l.start(), 0, 1, {1e-15, 1e-15});
  CHECK(std::abs(static_cast<double>(in_long.y[0] - 0.5L)) <= 10 * 1e-15);

  const test::Kepler<double> kepler;
  const auto dynamic = [&](double t, const Eigen::VectorXd& y) -> Eigen::VectorXd {
    return kepler(t, y);
  };
  const Eigen::VectorXd y0 = kepler.start();
  const auto a = integrate_adaptive<Dop853>(dynamic, y0, 0, 2);
  const auto b = integrate_adaptive<Dop853>(kepler, kepler.start(), 0, 2);
  CHECK(a.y == b.y);
  CHECK(a.evaluations == b.evaluations);
}

TEST_CASE("integrate_adaptive: a planet keeps its energy to the tolerance") {
  const test::Kepler<double> kepler;
  double worst = 0;
  integrate_adaptive<Dop853>(kepler, kepler.start(), 0, 20 * std::numbers::pi, {1e-10, 1e-10},
                             [&](double, const State4& y) {
                               const double energy =
                                   y.tail<2>().squaredNorm() / 2 - 1 / y.head<2>().norm();
                               worst = std::max(worst, std::abs(energy + 0.5));
                             });
  // Some 300 steps, each with an error of at most 1e-10 that moves the energy by about twice that
  // where the planet is fast.
  CHECK(worst <= 300 * 2 * 1e-10);
}
