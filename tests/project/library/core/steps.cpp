// Which step a moment is in, and how many steps there will be.
#include <doctest/doctest.h>

#include <cmath>

#include "project/harness/refusal.hpp"
#include "tumble/core/step_at.hpp"
#include "tumble/core/step_budget.hpp"

using namespace tumble;

namespace {

std::size_t found(const std::vector<double>& steps, double t) {
  return detail::step_at(steps, t, [](double step) { return step; });
}

/// Steps of one length until they are hopeless, or `until`.
detail::StepBudget paced(double h, double most, int until) {
  detail::StepBudget budget(0, 1, most);
  for (int i = 1; i <= until && !budget.hopeless(); ++i) budget.count(i * h);
  return budget;
}

}  // namespace

TEST_CASE("step_at: even steps, very uneven ones, and the ends") {
  const std::vector<double> even = {2, 3, 4, 5, 6}, one = {0, 1};
  for (const double t : {2.0, 2.5, 3.0, 4.999, 5.0, 5.999})
    CHECK(found(even, t) == static_cast<std::size_t>(t) - 2);
  CHECK(found(one, 0) == 0);
  CHECK(found(one, 0.999) == 0);
  std::vector<double> uneven;
  for (int i = 0; i <= 300; ++i) uneven.push_back(std::pow(1.2, i) - 1);
  for (std::size_t i = 0; i < 300; ++i) {
    CHECK(found(uneven, uneven[i]) == i);
    CHECK(found(uneven, (uneven[i] + uneven[i + 1]) / 2) == i);
  }
}

TEST_CASE("StepBudget: what takes far too long is known early, what may just do is let go on") {
  CHECK(paced(1e-12, 1e6, 1'000'000).steps() == 256);
  CHECK(paced(1e-12, 1e6, 1'000'000).predicted() == doctest::Approx(1e12));
  CHECK_FALSE(paced(1e-5, 1e6, 100'000).hopeless());
  // Twice too long: not before it is sure.
  CHECK(paced(0.5e-6, 1e6, 10'000'000).steps() >= 8192);
  CHECK(paced(0.5e-6, 1e6, 10'000'000).hopeless());
  // Short steps at the start only.
  detail::StepBudget slow_start(0, 1, 1e4);
  double t = 0;
  for (int i = 0; i < 1000; ++i) slow_start.count(t += i < 300 ? 1e-9 : 1e-3);
  CHECK(slow_start.predicted() < 1e5);
  CHECK_FALSE(slow_start.hopeless());
}

TEST_CASE("StepBudget: the refusal says how many steps, how many are taken, and where it was") {
  const auto budget = paced(1e-12, 1e6, 1000);
  const std::string text = test::message_of<detail::TooManySteps>(
      [&] { detail::refuse_hopeless("someone", budget, 1e6, 0.1 + 0.2, "stop it"); });
  CHECK(test::mentions(text, "someone: too many steps", "about 1e+12", "at most 1e+06",
                       "t = 0.3:", "stop it"));
}
