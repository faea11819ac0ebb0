/// @file
/// 1.2 twice: functions are called back across the pipe, and the judge sees every call.
#include "01_crossing/contract.hpp"
#include "judge/spec/spec.hpp"

using namespace tumble::judge;
using Eigen::VectorXd;

namespace student {
const Function<decltype(crossing::twice)> twice{TUMBLE_UNIT};
}

namespace {

VectorXd slope(double t, const VectorXd& y) { return t * y + VectorXd::Ones(y.size()); }

VectorXd any_state(int size) {
  VectorXd y(size);
  for (double& entry : y) entry = any_number(-1, 1);
  return y;
}

}  // namespace

TEST_SUITE(TUMBLE_UNIT) {
  TEST_CASE("the second call takes what the first one gave, a step later") {
    const VectorXd y = any_state(4);
    const double t = any_number(0, 1), h = any_number(0.1, 1);
    REQUIRE(student::twice(slope, t, y, h) == close_to(slope(t + h, slope(t, y)), 8 * eps));
  }

  TEST_CASE("the function is called exactly twice, at t and at t + h") {
    const auto answer = student::twice(slope, 1, any_state(2), 0.5);
    const auto& calls = answer.evaluations();
    REQUIRE(answer == obeys("f is called twice", calls.size() == 2 ? 0 : 1, 0));
    REQUIRE(answer == obeys("at t, then at t + h",
                            from_value<double>(calls[0].arguments[0]) == 1 &&
                                    from_value<double>(calls[1].arguments[0]) == 1.5
                                ? 0
                                : 1,
                            0));
  }

  TEST_CASE("a state of any size, an empty one too") {
    for (const int size : {0, 1, 13}) {
      const VectorXd y = any_state(size);
      REQUIRE(student::twice(slope, 0, y, 1) == close_to(slope(1, slope(0, y)), 8 * eps));
    }
  }
}

const Misconceptions<decltype(crossing::twice)> misconceptions{
    TUMBLE_UNIT,
    {{"only once", "f was applied once.", "",
      [](const crossing::Rhs& f, double t, const VectorXd& y, double) { return f(t, y); }},
     {"time stands still", "Both calls were made at t.", "",
      [](const crossing::Rhs& f, double t, const VectorXd& y, double) { return f(t, f(t, y)); }},
     {"twice the same", "The second call took y again.", "",
      [](const crossing::Rhs& f, double t, const VectorXd& y, double h) { return f(t + h, y); }},
     {"called once too often", "f was called a third time, and the result thrown away.", "",
      [](const crossing::Rhs& f, double t, const VectorXd& y, double h) {
        f(t, y);
        return f(t + h, f(t, y));
      }}}};
