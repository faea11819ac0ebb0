#include "tumble/ode/radau5.hpp"

#include <doctest/doctest.h>

#include "problems.hpp"

using namespace tumble;
using namespace tumble::detail;
using test::contains;
using test::message_of;

namespace {

using State2 = test::Vector2<double>;

/// Van der Pol's oscillator with time in units of μ (Hairer & Wanner II, eq. IV.1.5'):
/// y'' = μ² ((1 − y²) y' − y), from (2, 0).
struct VanDerPol {
  double mu;
  State2 operator()(double, const State2& y) const {
    return {y[1], mu * mu * ((1 - y[0] * y[0]) * y[1] - y[0])};
  }
  Eigen::Matrix2d jacobian(double, const State2& y) const {
    Eigen::Matrix2d J;
    J << 0, 1, mu * mu * (-2 * y[0] * y[1] - 1), mu * mu * (1 - y[0] * y[0]);
    return J;
  }
};

Vec3 robertson(double, const Vec3& y) {
  const double slow = 0.04 * y[0] - 1e4 * y[1] * y[2], fast = 3e7 * y[1] * y[1];
  return {-slow, slow - fast, fast};
}

}  // namespace

TEST_CASE("Radau5: van der Pol, from mildly to extremely stiff") {
  struct Reference {
    double mu, y, dydt;
  };
  // y(1): SciPy 1.10 Radau with rtol 1e-13 (1e-11 for μ = 10⁶) and the exact Jacobian. For μ = 10³
  // it agrees with the Bari test set for IVP solvers (Mazzia & Magherini 2008) to 13 digits.
  const Reference references[] = {{1e3, -1.86364625480812, 0.753543086543563},
                                  {1e4, -1.86339614105148, 0.753726269446194},
                                  {1e5, -1.86338446571575, 0.753734814792986},
                                  {1e6, -1.8633839229379, 0.75373521198263}};
  for (const Reference& reference : references) {
    CAPTURE(reference.mu);
    const VanDerPol f{reference.mu};
    const auto differences = [&](double t, const State2& y) { return f(t, y); };
    for (const double tolerance : {1e-5, 1e-7}) {
      CAPTURE(tolerance);
      const Tolerances tolerances{tolerance, tolerance / 10};
      const auto given = integrate_adaptive<Radau5>(f, State2(2, 0), 0, 1, tolerances);
      const auto found = integrate_adaptive<Radau5>(differences, State2(2, 0), 0, 1, tolerances);
      // The solution passes two sharp corners, where errors grow by less than ten.
      CHECK(std::abs(given.y[0] - reference.y) <= 10 * tolerance);
      CHECK(std::abs(given.y[1] - reference.dydt) <= 10 * tolerance);
      CHECK(std::abs(found.y[0] - reference.y) <= 10 * tolerance);
      // The steps are as many for an exact Jacobian as for differences, which cost two
      // evaluations each time.
      CHECK(std::abs(given.steps - found.steps) <= 0.02 * given.steps);
      CHECK(found.rejected <= 0.1 * found.steps);
      CHECK(given.evaluations < found.evaluations);
      CHECK(given.evaluations <= 12 * given.steps);
    }
  }
}

TEST_CASE("Radau5: Robertson's reactions, over eleven powers of ten in time") {
  // t = 40 and 10¹¹: SciPy 1.10 Radau with rtol 1e-13, atol 1e-20; both agree with Mazzia &
  // Magherini (2008) to 12 digits.
  const auto relative_error = [](double end, const Vec3& reference, double tolerance) {
    const auto solution = integrate_adaptive<Radau5>(robertson, Vec3(1, 0, 0), 0, end,
                                                     Tolerances{tolerance, tolerance * 1e-8});
    CHECK(solution.rejected <= 0.1 * solution.steps);
    return (solution.y - reference).cwiseQuotient(reference).cwiseAbs().maxCoeff();
  };
  const Vec3 at_40(0.715827068719405, 9.18553476455777e-6, 0.28416374574583);
  const Vec3 at_1e11(2.083340149699e-8, 8.33336077032e-14, 0.9999999791665);
  for (const double tolerance : {1e-4, 1e-6, 1e-8}) {
    CAPTURE(tolerance);
    CHECK(relative_error(40, at_40, tolerance) <= 10 * tolerance);
    CHECK(relative_error(1e11, at_1e11, tolerance) <= 10 * tolerance);
  }
}

TEST_CASE("Radau5: Prothero and Robinson's problem, and what it costs an explicit method") {
  // y' = −λ (y − cos t) − sin t, y(0) = 1: y = cos t whatever λ.
  const auto evaluations = [](auto method, double lambda) {
    const auto f = [=](double t, const test::Vector1<double>& y) -> test::Vector1<double> {
      return test::Vector1<double>(-lambda * (y[0] - std::cos(t)) - std::sin(t));
    };
    const auto solution =
        integrate_adaptive<decltype(method)>(f, test::Vector1<double>(1.0), 0, 10);
    CHECK(std::abs(solution.y[0] - std::cos(10)) <= 10 * 1e-6);
    return solution.evaluations;
  };
  const int mild = evaluations(Radau5(), 10), stiff = evaluations(Radau5(), 1e5);
  CHECK(stiff <= 3 * mild);
  // The stability of the explicit one ends at λ h of about 3.3: at least 10⁶/3.3 steps of six.
  CHECK(evaluations(DormandPrince54(), 1e5) >= 1000 * stiff);
}

TEST_CASE("Radau5: keeps the Jacobian while it is good, for a linear problem to the end") {
  int calls = 0, jacobians = 0;
  const auto f = [&](double t, const State2& y) -> State2 {
    ++calls;
    return {y[1], -100 * y[0] - 101 * y[1] + std::sin(t)};
  };
  const auto J = [&](double, const State2&) -> Eigen::Matrix2d {
    ++jacobians;
    return (Eigen::Matrix2d() << 0, 1, -100, -101).finished();
  };
  const auto solution = integrate_adaptive<Radau5>(with_jacobian(f, J), State2(1, 0), 0, 10);
  CHECK(jacobians == 1);
  CHECK(solution.evaluations == calls);
  CHECK(solution.steps > 10);
}

TEST_CASE("Radau5: a step that has no solution is not accepted, and half of it is tried next") {
  const auto f = [](double, const Vec3& y) -> Vec3 { return y.cwiseProduct(y).array() + 1; };
  const Vec3 y(1, 1, 1);
  Radau5::Stepper<Vec3> stepper({}, f(0, y));
  const runge_kutta::Attempt<Vec3> attempt = stepper.attempt(f, 0, y, 10);
  CHECK(!attempt.accepted());
  CHECK(attempt.error == INFINITY);
  CHECK(attempt.next_h == 5);
}

TEST_CASE("Radau5::step: stiff decay is exact in the limit, and what does not converge is said") {
  const auto f = [](double, const Vec3& y) -> Vec3 { return -1e12 * y; };
  // The stability function falls as −3/z (Hairer & Wanner II, IV.3); rounding is that of 1.
  for (int i = 0; i < 3; ++i)
    CHECK(std::abs(Radau5::step(f, 0, Vec3(1, 1, 1), 1)[i] - 3e-12) <= 100 * test::eps);
  const auto no_solution = [](double, const Vec3& y) -> Vec3 {
    return y.cwiseProduct(y).array() + 1;
  };
  CHECK(contains(
      message_of<std::runtime_error>([&] { Radau5::step(no_solution, 2.5, Vec3(1, 1, 1), 10); }),
      "does not converge from t = 2.5 with h = 10"));
}
