/// @file
/// 1.5 rk4_step: its laws, and what goes wrong.
#include "judge/spec/shared/right_hand_sides.hpp"
#include "tumble/ode/midpoint.hpp"
#include "tumble/ode/rk4.hpp"

#include <array>

#include "01_particles/contract.hpp"
#include "judge/spec/spec.hpp"

using namespace tumble::judge;
using namespace right_hand_sides;

namespace student {
const Function<decltype(particles::rk4_step)> rk4_step{TUMBLE_UNIT};
}

namespace {

VectorXd reference(const Rhs& f, double t, const VectorXd& y, double h) {
  return tumble::runge_kutta::rk4_step(f, t, y, h);
}

// ── Wrong methods ──

using Four = std::array<double, 4>;

/// Four slopes, each at t + at[n] h and seen from y along `along[n]` h times another one: that of
/// the number by[n].
struct Method {
  Four at{0, 0.5, 0.5, 1}, along{0, 0.5, 0.5, 1}, weights{1 / 6., 1 / 3., 1 / 3., 1 / 6.};
  std::array<std::size_t, 4> by{0, 0, 1, 2};
};

/// @param ahead what stands for h when the state is moved
VectorXd step(const Method& method, const Rhs& f, double t, const VectorXd& y, double h,
              double ahead) {
  VectorXd sum = VectorXd::Zero(y.size());
  std::array<VectorXd, 4> slopes;
  slopes.fill(sum);
  for (std::size_t n = 0; n < 4; ++n) {
    slopes[n] = f(t + method.at[n] * h, y + method.along[n] * ahead * slopes[method.by[n]]);
    sum += method.weights[n] * slopes[n];
  }
  return y + h * sum;
}

auto with(Method method) {
  return [method](const Rhs& f, double t, const VectorXd& y, double h) {
    return step(method, f, t, y, h, h);
  };
}

/// Each slope is seen from where the one before was.
VectorXd piled_up(const Rhs& f, double t, const VectorXd& y, double h) {
  const Method right;
  VectorXd place = y, slope = VectorXd::Zero(y.size()), sum = slope;
  for (std::size_t n = 0; n < 4; ++n) {
    place += right.along[n] * h * slope;
    slope = f(t + right.at[n] * h, place);
    sum += right.weights[n] * slope;
  }
  return y + h * sum;
}

}  // namespace

TEST_SUITE(TUMBLE_UNIT) {
  TEST_CASE("four slopes, averaged as in Simpson's rule, for any right-hand side") {
    for (int n = 0; n < 16; ++n) {
      const Rhs f = any_rhs();
      const VectorXd y = any_state(1 + n % 5);
      const double t = any_number(-2, 2), h = any_number(0.1, 0.5);
      REQUIRE(student::rk4_step(f, t, y, h) == close_to(reference(f, t, y, h), rounding(y)));
    }
  }

  TEST_CASE(
      "the right-hand side is evaluated four times: at the start, twice halfway, at the end") {
    for (int n = 0; n < 5; ++n) {
      const Rhs f = any_rhs();
      const VectorXd y = any_state(3);
      const double t = 1, half = 1.25, end = 1.5, h = 0.5;
      const VectorXd second = y + 0.25 * f(t, y), third = y + 0.25 * f(half, second),
                     last = y + 0.5 * f(half, third);
      const auto answer = student::rk4_step(f, t, y, h);
      REQUIRE(answer == evaluated(answer, 4, "four times"));
      REQUIRE(answer == obeys("f is first evaluated at t and y", missed_by(answer, 0, {t, y}), 0));
      REQUIRE(answer == obeys("f is then evaluated at t + h/2, where k₁ leads to",
                              missed_by(answer, 1, {half, second}), rounding(y)));
      REQUIRE(answer == obeys("f is evaluated at t + h/2 again, where k₂ leads to",
                              missed_by(answer, 2, {half, third}), rounding(y)));
      REQUIRE(answer == obeys("f is evaluated at t + h at last, where k₃ leads to",
                              missed_by(answer, 3, {end, last}), rounding(y)));
    }
  }

  TEST_CASE("where only the time counts it is Simpson's rule, exact for a cubic") {
    for (int n = 0; n < 5; ++n) {
      const double a = any_number(-2, 2), b = any_number(-2, 2);
      const double t = any_number(-2, 2), h = any_number(0.1, 1), end = t + h;
      const Rhs f = [a, b](double time, const VectorXd&) -> VectorXd {
        return VectorXd::Constant(1, a * time * time * time + b * time);
      };
      const VectorXd y = any_state(1);
      const double integral =
          a * (std::pow(end, 4) - std::pow(t, 4)) / 4 + b * (end * end - t * t) / 2;
      // All terms are at most 2 · 3⁴ / 4 + 2 · 3² / 2 and the state; some 20 roundings of that.
      REQUIRE(
          student::rk4_step(f, t, y, h) ==
          close_to(VectorXd(y + VectorXd::Constant(1, integral)), 20 * eps * (50 + size_of(y))));
    }
  }

  TEST_CASE("growth by the first five terms of exp(hλ) per step, also where the step is too long") {
    for (const double z : {0.5, -0.5, -1., -2., -3., -1e6}) {
      const double h = any_number(0.1, 0.5), size = std::abs(z);
      const VectorXd y = any_state(2);
      const auto five_terms = [](double x) {
        return 1 + x * (1 + x / 2 * (1 + x / 3 * (1 + x / 4)));
      };
      REQUIRE(student::rk4_step(growth(z / h), any_number(-2, 2), y, h) ==
              close_to(VectorXd(five_terms(z) * y), 32 * eps * five_terms(size) * size_of(y)));
    }
  }

  TEST_CASE("half the step, a sixteenth of the error: the error of many steps falls as h⁴") {
    const double start = any_number(1, 1.5);  // where the error does not change its sign
    const auto error = [&](const auto& end) { return size_of(end.value() - hill(start + 1)); };
    const auto coarse = climb(student::rk4_step, start, 8);
    const auto fine = climb(student::rk4_step, start, 16);
    // Nearer to 4 than to any other whole number.
    REQUIRE(fine == obeys("the error falls as h⁴",
                          std::abs(order_from(error(coarse), error(fine)) - 4), 0.5));
  }

  TEST_CASE("a negative step goes back in time, and no step goes nowhere") {
    for (const double size : {-0.5, -0.1, 0.}) {
      const Rhs f = any_rhs();
      const VectorXd y = any_state(4);
      const double t = any_number(-2, 2);
      REQUIRE(student::rk4_step(f, t, y, size) == close_to(reference(f, t, y, size), rounding(y)));
    }
  }

  TEST_CASE("states of any size, an empty one too; tiny and huge ones, and tiny steps") {
    for (const int count : {0, 1, 60}) {
      const Rhs f = any_rhs();
      const VectorXd y = any_state(count);
      const double t = any_number(-2, 2), h = any_number(0.1, 0.5);
      REQUIRE(student::rk4_step(f, t, y, h) == close_to(reference(f, t, y, h), rounding(y)));
    }
    for (const double size : {1e-200, 1e200}) {
      const VectorXd y = any_state(3, size), slope = any_state(3, size);
      REQUIRE(student::rk4_step(constant_slope(slope), 1, y, 0.5) ==
              close_to(VectorXd(y + slope / 2), 8 * eps * size * 3));
    }
    for (const double h : {1e-20, -1e-20}) {
      const VectorXd y = any_state(3), slope = any_state(3);
      REQUIRE(student::rk4_step(constant_slope(slope / h), 1, y, h) ==
              close_to(VectorXd(y + slope), 16 * eps * (size_of(y) + size_of(slope))));
    }
  }
}

const Misconceptions<decltype(particles::rk4_step)> misconceptions{
    TUMBLE_UNIT,
    {{"all slopes weigh the same",
      "You have averaged the four slopes with equal weights. As in Simpson's rule, the middle "
      "weighs "
      "more than the ends.",
      "Runge–Kutta", with({.weights = {1 / 4., 1 / 4., 1 / 4., 1 / 4.}})},
     {"not divided by six",
      "You have added the slopes with their weights, which sum to 6. An average also divides by "
      "that.",
      "Runge–Kutta", with({.weights = {1, 2, 2, 1}})},
     {"weights of another method",
      "The weights are 1, 3, 3, 1. They belong to the 3/8 rule, whose inner slopes are a third and "
      "two thirds of the way; here both are in the middle.",
      "Runge–Kutta", with({.weights = {1 / 8., 3 / 8., 3 / 8., 1 / 8.}})},
     {"middle weighs once",
      "The two slopes in the middle weigh half as much as the ones at the ends: your weights are "
      "the wrong way round.",
      "Runge–Kutta", with({.weights = {1 / 3., 1 / 6., 1 / 6., 1 / 3.}})},
     {"third slope not used",
      "Your average counts the second slope twice and leaves the third out. Each of the four has "
      "its part.",
      "Runge–Kutta", with({.weights = {1 / 6., 2 / 3., 0, 1 / 6.}})},
     {"fourth slope not used",
      "The fourth slope is missing in the average. It weighs as much as the first one.",
      "Runge–Kutta", with({.weights = {1 / 6., 1 / 3., 1 / 3., 0}})},
     {"three for two",
      "The weights are 1, 2, 3, 1, which sum to 7: a slip of the pen? Both slopes in the middle "
      "weigh the same.",
      "Runge–Kutta", with({.weights = {1 / 6., 1 / 3., 1 / 2., 1 / 6.}})},
     {"third slope weighs once",
      "Your weights are 1, 2, 1, 1, which sum to 5 instead of 6. Both slopes in the middle weigh "
      "the "
      "same.",
      "Runge–Kutta", with({.weights = {1 / 6., 1 / 3., 1 / 6., 1 / 6.}})},
     {"second slope weighs once",
      "Your weights are 1, 1, 2, 1, which sum to 5 instead of 6. Both slopes in the middle weigh "
      "the "
      "same.",
      "Runge–Kutta", with({.weights = {1 / 6., 1 / 6., 1 / 3., 1 / 6.}})},
     {"fourth slope subtracted",
      "You have subtracted the fourth slope. In RK4 all four slopes have a positive weight.",
      "Runge–Kutta", with({.weights = {1 / 6., 1 / 3., 1 / 3., -1 / 6.}})},
     {"brackets of the average forgotten",
      "You have multiplied the first slope by h/6, and added the others without it. Put brackets "
      "around the weighted sum.",
      "Runge–Kutta",
      [](const Rhs& f, double t, const VectorXd& y, double h) -> VectorXd {
        const Method right;
        VectorXd slope = f(t, y), end = y + h / 6 * slope;
        for (std::size_t n = 1; n < 4; ++n) {
          slope = f(t + right.at[n] * h, y + right.along[n] * h * slope);
          end += 6 * right.weights[n] * slope;
        }
        return end;
      }},
     {"divided by four",
      "You have divided the weighted sum by the number of slopes. Divide it by the sum of the "
      "weights.",
      "Runge–Kutta", with({.weights = {1 / 4., 1 / 2., 1 / 2., 1 / 4.}})},
     {"third slope from the first",
      "You have taken the third slope where the first one leads to, so it is the second one again. "
      "Each slope shows the way to the next.",
      "Runge–Kutta", with({.by = {0, 0, 0, 2}})},
     {"fourth slope from the second",
      "You have taken the fourth slope where the second one leads to. Each slope shows the way to "
      "the next: the third comes in between.",
      "Runge–Kutta", with({.by = {0, 0, 1, 1}})},
     {"fourth slope halfway",
      "You have looked at the fourth slope halfway, in time and state. It belongs to the end of "
      "the step.",
      "Runge–Kutta", with({.at = {0, 0.5, 0.5, 0.5}, .along = {0, 0.5, 0.5, 0.5}})},
     {"only half of the way to the end",
      "You have taken the fourth slope at the time of the end, but moved the state only half of "
      "the step. Time and state belong together.",
      "Runge–Kutta", with({.along = {0, 0.5, 0.5, 0.5}})},
     {"whole steps to look ahead",
      "For the second and the third slope you have moved the state a whole step. They are halfway.",
      "Runge–Kutta", with({.along = {0, 1, 1, 1}})},
     {"time stands still",
      "You have taken all slopes at the time t. When the state moves on, the time does too.",
      "Runge–Kutta", with({.at = {0, 0, 0, 0}})},
     {"time of the middle too late",
      "You have taken the second and the third slope at the time t + h. They are halfway.",
      "Runge–Kutta", with({.at = {0, 1, 1, 1}})},
     {"third slope too far ahead",
      "To look at the third slope you have moved the state a whole step, to the time halfway. Time "
      "and state belong together.",
      "Runge–Kutta", with({.along = {0, 0.5, 1, 1}})},
     {"third slope too late",
      "You have taken the third slope at the time of the end, but moved the state only half of the "
      "step. Time and state belong together.",
      "Runge–Kutta", with({.at = {0, 0.5, 1, 1}})},
     {"fourth slope too early",
      "You have taken the fourth slope at the time halfway, with the state moved a whole step. "
      "Time and state belong together.",
      "Runge–Kutta", with({.at = {0, 0.5, 0.5, 0.5}})},
     {"fourth slope at the time of the start",
      "You have taken the fourth slope at the time t, with the state moved a whole step. Time and "
      "state belong together.",
      "Runge–Kutta", with({.at = {0, 0.5, 0.5, 0}})},
     {"half of the time itself",
      "You have taken the two slopes in the middle at (t + h)/2. Halfway through the step is half "
      "of h after t: look at the brackets.",
      "Runge–Kutta",
      [](const Rhs& f, double t, const VectorXd& y, double h) -> VectorXd {
        const auto late = [&](double time, const VectorXd& place) {
          return f(time == t + h / 2 ? (t + h) / 2 : time, place);
        };
        return reference(late, t, y, h);
      }},
     {"3/8 rule",
      "This is the 3/8 rule, with slopes a third and two thirds of the way. Its error falls as h⁴ "
      "too, but RK4 is another method.",
      "Runge–Kutta",
      [](const Rhs& f, double t, const VectorXd& y, double h) -> VectorXd {
        const auto seen = [&](double part, const VectorXd& way) -> VectorXd {
          return f(t + part * h, y + h * way);
        };
        const VectorXd start = f(t, y), third = seen(1. / 3, start / 3),
                       two_thirds = seen(2. / 3, third - start / 3),
                       end = seen(1, start - third + two_thirds);
        return y + h / 8 * (start + end) + 3 * h / 8 * (third + two_thirds);
      }},
     {"stages piled up",
      "You have started for each slope from where the one before was. Start for all of them from "
      "the same y.",
      "Runge–Kutta", piled_up},
     {"h twice",
      "You have multiplied the slopes by h when you took them, and their average once more.",
      "Runge–Kutta",
      [](const Rhs& f, double t, const VectorXd& y, double h) -> VectorXd {
        return y + h * (reference(f, t, y, h) - y);
      }},
     {"h forgotten on the way",
      "To look ahead you have added the slopes without the step: h is missing in the states "
      "between.",
      "Runge–Kutta",
      [](const Rhs& f, double t, const VectorXd& y, double h) -> VectorXd {
        return step({}, f, t, y, h, 1);
      }},
     {"h forgotten at the end",
      "You have added the average of the slopes to y without the step: h is missing in the last "
      "line.",
      "Runge–Kutta",
      [](const Rhs& f, double t, const VectorXd& y, double h) -> VectorXd {
        return y + (reference(f, t, y, h) - y) / h;
      }},
     {"only the change", "This is only the change in y. Add y to it, and return the new state.",
      "Runge–Kutta",
      [](const Rhs& f, double t, const VectorXd& y, double h) -> VectorXd {
        return reference(f, t, y, h) - y;
      }},
     {"one sixth is zero",
      "The state has not moved at all. In C++ the quotient of two whole numbers is a whole number: "
      "one divided by six is 0 unless one of them has a point.",
      "Runge–Kutta",
      [](const Rhs& f, double t, const VectorXd& y, double h) -> VectorXd {
        return y + 0 * reference(f, t, y, h);
      }},
     {"midpoint method",
      "This is the midpoint method of the exercise before: one slope halfway. Here average four "
      "slopes.",
      "Runge–Kutta",
      [](const Rhs& f, double t, const VectorXd& y, double h) -> VectorXd {
        return tumble::runge_kutta::midpoint_step(f, t, y, h);
      }},
     {"evaluated too often",
      "The result is right, but you have evaluated the right-hand side more than four times. In a "
      "large scene this is what costs time: keep what it returns.",
      "Runge–Kutta", [](const Rhs& f, double t, const VectorXd& y, double h) -> VectorXd {
        f(t, y);
        return reference(f, t, y, h);
      }}}};
