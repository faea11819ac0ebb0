/// @file
/// Every method has the order that it claims, measured.

#include <doctest/doctest.h>

#include "problems.hpp"

using namespace tumble;

namespace {

/// The error in long double at `steps`, 4/3 · `steps`, … and the slope through them.
template <class Method, class Problem>
double measured_order(int steps) {
  using State = typename Problem::State;
  std::vector<double> h, errors;
  for (int i = 0; i < 4; ++i, steps += steps / 3) {
    const State y = integrate_fixed<Method>(Problem(), Problem::start(), 0, Problem::end, steps);
    h.push_back(1.0 / steps);
    errors.push_back(static_cast<double>((y - Problem::exact()).norm()));
  }
  return runge_kutta::observed_order(h, errors);
}

struct Row {
  std::string method;
  int claimed;
  double on_rational, on_kepler;
};

/// @param rational number of steps at which h^p is seen and rounding is not yet
template <class Method>
Row measure(const char* method, int rational, int kepler) {
  return {method, Method::order, measured_order<Method, test::Rational<long double>>(rational),
          measured_order<Method, test::Kepler<long double>>(kepler)};
}

}  // namespace

TEST_CASE("methods: the error falls with the claimed power of the step") {
  const Row table[] = {measure<runge_kutta::Euler>("Euler", 200, 10000),
                       measure<runge_kutta::BackwardEuler>("BackwardEuler", 200, 10000),
                       measure<runge_kutta::Midpoint>("Midpoint", 50, 2000),
                       measure<Rk4>("Rk4", 50, 400),
                       measure<DormandPrince54>("DormandPrince54", 50, 400),
                       measure<Radau5>("Radau5", 20, 100),
                       measure<Dop853>("Dop853", 10, 60)};
  for (const Row& row : table) {
    MESSAGE(row.method << ": order " << row.claimed << " claimed, " << row.on_rational << " and "
                       << row.on_kepler << " seen");
    // The term of the next order bends the line a little at these steps.
    CHECK(std::abs(row.on_rational - row.claimed) <= 0.2);
    CHECK(std::abs(row.on_kepler - row.claimed) <= 0.2);
  }
}

TEST_CASE("methods: in float they get as far as float goes") {
  using Problem = test::Rational<float>;
  const auto error = [](const Problem::State& y) { return std::abs(y[0] - 0.5f); };
  const Problem f;
  // 30 steps, some roundings of a number below 1 in each.
  const float rounding = 100 * 0x1p-24f;
  CHECK(error(integrate_fixed<Rk4>(f, f.start(), 0, 1, 30)) <= rounding);
  CHECK(error(integrate_fixed<DormandPrince54>(f, f.start(), 0, 1, 30)) <= rounding);
  CHECK(error(integrate_fixed<Dop853>(f, f.start(), 0, 1, 10)) <= rounding);
  CHECK(error(integrate_fixed<Radau5>(f, f.start(), 0, 1, 10)) <= rounding);
}
