/// @file
/// 2.2 adaptive_step_size: its laws, and what goes wrong.
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "02_solvers/contract.hpp"
#include "judge/spec/spec.hpp"
#include "tumble/ode/step_size.hpp"

using namespace tumble::judge;

namespace student {
const Function<decltype(solvers::adaptive_step_size)> adaptive_step_size{TUMBLE_UNIT};
}

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity(),
                 not_a_number = std::numeric_limits<double>::quiet_NaN();

double reference(double h, double error, int order) {
  return tumble::runge_kutta::adaptive_step_size(h, error, order);
}

/// A power of a number takes 2 roundings and those of its exponent and its logarithm, which within
/// the limits of the factor count 3 times at most; the products and 0.9 take 3. On both sides.
double rounding(double h, double error, int order) {
  return 16 * eps * std::abs(reference(h, error, order));
}

double any_step() { return any_number(0.01, 2); }

/// An error norm for which the factor is between its limits.
double moderate_error(int order, double low = 0.3, double high = 5) {
  return std::pow(0.9 / any_number(low, high), order + 1);
}

// ── Wrong laws ──

double factor_of(double error, int order) { return 0.9 * std::pow(error, -1. / (order + 1)); }

/// h times a wrong factor, which is kept within the limits; NaN is treated rightly.
auto with_factor(const std::function<double(double error, int order)>& factor) {
  return [factor](double h, double error, int order) {
    return std::isnan(error) ? 0.2 * h : h * std::clamp(factor(error, order), 0.2, 10.);
  };
}

}  // namespace

TEST_SUITE(TUMBLE_UNIT) {
  TEST_CASE("the step for which the error norm would be 1, times 0.9, for any error and order") {
    // All is asked before the first answer is looked at: steps that grow and steps that shrink may
    // go wrong in different ways.
    struct Step {
      double h, error;
      int order;
    };
    std::vector<Step> steps;
    std::vector<Answer<double>> answers;
    for (int n = 0; n < 24; ++n) {
      const int order = 1 + (n + 3) % 8;
      const double h = any_step();
      const double error = n % 3 ? moderate_error(order, 1, 5) : moderate_error(order, 0.3, 0.8);
      steps.push_back({h, error, order});
      answers.push_back(student::adaptive_step_size(h, error, order));
    }
    for (std::size_t n = 0; n < steps.size(); ++n) {
      const auto& [h, error, order] = steps[n];
      REQUIRE(answers[n] == close_to(reference(h, error, order), rounding(h, error, order)));
    }
  }

  TEST_CASE("an error of just 1 leaves 0.9 of the step, whatever the order") {
    for (const int order : {1, 2, 4, 5, 8}) {
      const double h = any_step();
      REQUIRE(student::adaptive_step_size(h, 1, order) == close_to(0.9 * h, 16 * eps * h));
    }
  }

  TEST_CASE("order 1: an error of 1/4 makes 1.8 of the step, an error of 4 makes 0.45 of it") {
    const double h = any_step();
    REQUIRE(student::adaptive_step_size(h, 0.25, 1) == close_to(1.8 * h, 32 * eps * h));
    REQUIRE(student::adaptive_step_size(h, 4, 1) == close_to(0.45 * h, 16 * eps * h));
  }

  TEST_CASE("tried again with the step it gives, the error norm is 0.9 to the power q + 1") {
    for (int n = 0; n < 16; ++n) {
      const int order = 1 + n % 8;
      const double h = any_step(), error = moderate_error(order);
      const auto next = student::adaptive_step_size(h, error, order);
      const double expected = std::pow(0.9, order + 1);
      const double again = error * std::pow(next / h, order + 1);
      // The power multiplies relative errors by q + 1.
      REQUIRE(next == obeys("the error norm of that step is 0.9^(q+1)", std::abs(again - expected),
                            32 * eps * (order + 2) * expected));
    }
  }

  TEST_CASE("never shorter than 0.2 h, never longer than 10 h, and just within is as it is") {
    for (const int order : {1, 3, 7}) {
      const double h = any_step();
      for (const double far : {1e30, 1e300}) {
        // Asked first, both of them, so that it can be told which of the limits is missing.
        const auto longest = student::adaptive_step_size(h, 1 / far, order);
        const auto shortest = student::adaptive_step_size(h, far, order);
        REQUIRE(longest == close_to(10 * h, rounding(h, 1 / far, order)));
        REQUIRE(shortest == close_to(0.2 * h, rounding(h, far, order)));
      }
      for (const auto& [low, high] : {std::pair(0.15, 0.19), std::pair(0.21, 0.25),
                                      std::pair(8., 9.8), std::pair(10.2, 12.)}) {
        const double error = moderate_error(order, low, high);
        REQUIRE(student::adaptive_step_size(h, error, order) ==
                close_to(reference(h, error, order), rounding(h, error, order)));
      }
    }
  }

  TEST_CASE("of high order: for a tiny error, too, the rule decides, not the limit of 10 h") {
    for (const int order : {12, 20})
      for (const double error : {1e-10, 1e-12}) {
        const double h = any_step();
        REQUIRE(student::adaptive_step_size(h, error, order) ==
                close_to(reference(h, error, order), rounding(h, error, order)));
      }
  }

  TEST_CASE("backwards in time the steps are those of the rule, with a minus") {
    for (int n = 0; n < 8; ++n) {
      const int order = 1 + n;
      const double h = -any_step();
      for (const double error : {moderate_error(order), 1e-100, 1e100})
        REQUIRE(student::adaptive_step_size(h, error, order) ==
                close_to(reference(h, error, order), rounding(h, error, order)));
    }
  }

  TEST_CASE("tiny and huge steps follow the rule: its limits are of the factor, not of the step") {
    for (const double size : {1e-200, 1e-9, 1e9, 1e200}) {
      const int order = 4;
      const double h = size * any_step(), error = moderate_error(order);
      REQUIRE(student::adaptive_step_size(h, error, order) ==
              close_to(reference(h, error, order), rounding(h, error, order)));
    }
  }

  TEST_CASE("no error at all: the longest step; an infinite one, or NaN: the shortest") {
    for (const double h : {any_step(), -any_step()}) {
      const double size = std::abs(h);
      REQUIRE(student::adaptive_step_size(h, 0, 5) == close_to(10 * h, 16 * eps * 10 * size));
      REQUIRE(student::adaptive_step_size(h, infinity, 5) == close_to(0.2 * h, 4 * eps * size));
      REQUIRE(student::adaptive_step_size(h, not_a_number, 5) == close_to(0.2 * h, 4 * eps * size));
    }
  }
}

const Misconceptions<decltype(solvers::adaptive_step_size)> misconceptions{
    TUMBLE_UNIT,
    {{"root of the order",
      "You have taken the q-th root of the error. The error after many steps falls as h to the "
      "power q, that of a single one by one power more.",
      "Adaptive steps",
      with_factor([](double error, int order) { return 0.9 * std::pow(error, -1. / order); })},
     {"root of one order too high",
      "You have taken the (q + 2)-th root. The error norm goes as |h| to the power q + 1: "
      "take the root that undoes this power.",
      "Adaptive steps", with_factor([](double error, int order) {
        return 0.9 * std::pow(error, -1. / (order + 2));
      })},
     {"always the square root",
      "You have taken the square root, whatever the order. That is right for order 1: the order is "
      "one of the arguments.",
      "Adaptive steps", with_factor([](double error, int) { return 0.9 / std::sqrt(error); })},
     {"power for root",
      "You have raised the error to the power q + 1. The error norm goes as that power of the "
      "step, so from the error to the step it is the root.",
      "Adaptive steps",
      with_factor([](double error, int order) { return 0.9 * std::pow(error, -(order + 1)); })},
     {"brackets of the exponent forgotten",
      "Your exponent is one over q, plus one. A division comes before a sum: the sum needs "
      "brackets.",
      "Adaptive steps",
      with_factor([](double error, int order) { return 0.9 * std::pow(error, -1. / order + 1); })},
     {"no root",
      "You have divided the step by the error itself. With a step twice as long the error is not "
      "twice as large, but larger by a power of two that depends on the order.",
      "Adaptive steps", with_factor([](double error, int) { return 0.9 / error; })},
     {"upside down",
      "The step grows where the error is large, and shrinks where it is small. It should be the "
      "other way round.",
      "Adaptive steps",
      with_factor([](double error, int order) { return 0.9 * std::pow(error, 1. / (order + 1)); })},
     {"whole numbers divided",
      "The step is 0.9 of what it was, whatever the error. In C++ the quotient of two whole "
      "numbers is a whole number: your exponent is 0.",
      "Adaptive steps", with_factor([](double, int) { return 0.9; })},
     {"safety forgotten",
      "The next step would have an error of exactly 1, and half of all steps would narrowly fail. "
      "The factor of 0.9 is missing.",
      "Adaptive steps",
      with_factor([](double error, int order) { return factor_of(error, order) / 0.9; })},
     {"divided by the safety",
      "You have divided by 0.9, so each step is longer than the error allows. It multiplies the "
      "step.",
      "Adaptive steps",
      with_factor([](double error, int order) { return factor_of(error, order) / 0.81; })},
     {"safety times the error",
      "You have multiplied the error by 0.9 before the root, which makes the step longer. The 0.9 "
      "multiplies the step.",
      "Adaptive steps", with_factor([](double error, int order) {
        return std::pow(0.9 * error, -1. / (order + 1));
      })},
     {"safety under the root",
      "You have put the 0.9 under the root, where little is left of it. It multiplies the step.",
      "Adaptive steps", with_factor([](double error, int order) {
        return std::pow(error / 0.9, -1. / (order + 1));
      })},
     {"safety after the limits",
      "You have limited the factor first and then multiplied by 0.9, so it ends at 0.18 and 9.",
      "Adaptive steps",
      [](double h, double error, int order) {
        if (std::isnan(error)) return 0.2 * h;
        return 0.9 * h * std::clamp(factor_of(error, order) / 0.9, 0.2, 10.);
      }},
     {"no longest step",
      "After a step with hardly any error the next one is longer than 10 times, without a limit.",
      "Adaptive steps",
      [](double h, double error, int order) {
        return std::isnan(error) ? 0.2 * h : h * std::fmax(factor_of(error, order), 0.2);
      }},
     {"no shortest step",
      "After a step with a huge error the next one is shorter than 0.2 times, without a limit.",
      "Adaptive steps",
      [](double h, double error, int order) {
        return std::isnan(error) ? 0.2 * h : h * std::fmin(factor_of(error, order), 10.);
      }},
     {"no limits", "You have not limited the factor, neither upwards nor downwards.",
      "Adaptive steps",
      [](double h, double error, int order) {
        return std::isnan(error) ? 0.2 * h : h * factor_of(error, order);
      }},
     {"limits of the step itself",
      "You have kept the step between 0.2 and 10, in seconds. The limits are for the factor "
      "between "
      "it and the step before.",
      "Adaptive steps",
      [](double h, double error, int order) {
        return std::isnan(error) ? 0.2 * h : std::clamp(h * factor_of(error, order), 0.2, 10.);
      }},
     {"limits exchanged backwards in time",
      "Where h is negative, 0.2 h is more than 10 h: of two numbers the smaller one is not the "
      "shorter step. Limit the factor, not the step.",
      "Adaptive steps",
      [](double h, double error, int order) {
        if (std::isnan(error)) return 0.2 * h;
        return std::fmin(10 * h, std::fmax(0.2 * h, h * factor_of(error, order)));
      }},
     {"always forwards", "The sign of h is lost: a step back in time is followed by one forwards.",
      "Adaptive steps",
      [](double h, double error, int order) { return std::abs(reference(h, error, order)); }},
     {"factor only", "This is the factor. Multiply the step that was tried by it.",
      "Adaptive steps", [](double, double error, int order) { return reference(1, error, order); }},
     {"longer or as it is",
      "After a step that may be kept the next one is never shorter, even if the error was only "
      "just small enough: then it will probably fail.",
      "Adaptive steps",
      [](double h, double error, int order) {
        return error <= 1 ? h * std::fmax(1, reference(1, error, order))
                          : reference(h, error, order);
      }},
     {"as it is after a good step",
      "After a step that may be kept you have left its length as it is. A small error is a reason "
      "for a longer step, and an error of just 1 for a slightly shorter one.",
      "Adaptive steps",
      [](double h, double error, int order) {
        return error <= 1 ? h : reference(h, error, order);
      }},
     {"halved or doubled",
      "You have halved the step where the error is too large, and doubled it otherwise. How much "
      "too large the error is says more than that.",
      "Adaptive steps", [](double h, double error, int) { return error <= 1 ? 2 * h : h / 2; }},
     {"NaN passed on",
      "For an error of NaN your step is NaN, and from there on all is lost. Something went wrong "
      "in that step: try a shorter one.",
      "Adaptive steps",
      [](double h, double error, int order) {
        return std::isnan(error) ? error : reference(h, error, order);
      }},
     {"NaN leads forwards",
      "After an error of NaN the sign of h is lost: a step back in time is followed by one "
      "forwards.",
      "Adaptive steps",
      [](double h, double error, int order) {
        return std::isnan(error) ? 0.2 * std::abs(h) : reference(h, error, order);
      }},
     {"NaN changes nothing",
      "After an error of NaN the same step comes again. Something went wrong in that step, and "
      "will again: the next one is the shortest possible.",
      "Adaptive steps",
      [](double h, double error, int order) {
        return std::isnan(error) ? h : reference(h, error, order);
      }},
     {"NaN taken for no error",
      "After an error of NaN the next step is the longest. A comparison with NaN is always false: "
      "see which branch, or which limit, that leads to.",
      "Adaptive steps", [](double h, double error, int order) {
        return reference(h, std::isnan(error) ? 0 : error, order);
      }}}};
