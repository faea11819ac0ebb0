#include "tumble/ode/dop853_dense.hpp"

#include <doctest/doctest.h>

#include "problems.hpp"

using namespace tumble;

namespace {

using Two = Eigen::Vector2d;

Two oscillator(double, const Two& y) { return {y[1], -y[0]}; }

/// A step of length h from (1, 0), and what is between its ends.
detail::Dop853Dense<Two> dense(double h) {
  const Two y0(1, 0);
  Dop853::Stepper<Two> stepper({1, 1}, oscillator(0, y0));
  const auto attempt = stepper.attempt(oscillator, 0, y0, h);
  return {oscillator, 0, y0, attempt.y, h, stepper.stages_of_step()};
}

/// The largest error inside the step, and of the slope.
std::pair<double, double> errors(double h) {
  const auto step = dense(h);
  double most = 0, most_slope = 0;
  for (int i = 0; i <= 50; ++i) {
    const double theta = i / 50.0, t = theta * h;
    const Two truth(std::cos(t), -std::sin(t));
    most = std::max(most, (step.at(theta) - truth).norm());
    most_slope = std::max(most_slope, (step.slope(theta) / h - oscillator(t, truth)).norm());
  }
  return {most, most_slope};
}

}  // namespace

TEST_CASE("Dop853Dense: begins and ends where the step does, with its slopes") {
  const double h = 0.7;
  const auto step = dense(h);
  const Two end = Dop853::step(oscillator, 0.0, Two(1, 0), h);
  CHECK(step.at(0) == Two(1, 0));
  CHECK((step.at(1) - end).norm() <= 2 * test::eps);
  CHECK((step.slope(0) / h - oscillator(0, Two(1, 0))).norm() <= 4 * test::eps);
  CHECK((step.slope(1) / h - oscillator(h, end)).norm() <= 40 * test::eps);
}

TEST_CASE("Dop853Dense: between them its error falls as h⁸, that of its slope as h⁷") {
  const auto [coarse, coarse_slope] = errors(1.6);
  const auto [fine, fine_slope] = errors(0.8);
  CHECK(std::log2(coarse / fine) == doctest::Approx(8).epsilon(0.07));
  CHECK(std::log2(coarse_slope / fine_slope) == doctest::Approx(7).epsilon(0.07));
}

TEST_CASE("Stepper: the stiffness of a step is that of the equation") {
  const auto decay = [](double, const Two& y) -> Two { return {-100 * y[0], -y[1]}; };
  const Two y0(1, 1);
  Dop853::Stepper<Two> stepper({1e3, 1e3}, decay(0, y0));
  const double h = 0.05;
  const auto attempt = stepper.attempt(decay, 0, y0, h);
  REQUIRE(attempt.accepted());
  CHECK(stepper.stiffness(y0, attempt.y, h) == doctest::Approx(100 * h).epsilon(0.01));
}
