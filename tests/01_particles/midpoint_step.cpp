/// @file
/// 1.4 midpoint_step: its laws, and what goes wrong.
#include "judge/spec/shared/right_hand_sides.hpp"
#include "tumble/ode/euler.hpp"
#include "tumble/ode/midpoint.hpp"

#include "01_particles/contract.hpp"
#include "judge/spec/spec.hpp"

using namespace tumble::judge;
using namespace right_hand_sides;

namespace student {
const Function<decltype(particles::midpoint_step)> midpoint_step{TUMBLE_UNIT};
}

namespace {

VectorXd reference(const Rhs& f, double t, const VectorXd& y, double h) {
  return tumble::runge_kutta::midpoint_step(f, t, y, h);
}

VectorXd euler(const Rhs& f, double t, const VectorXd& y, double h) {
  return tumble::runge_kutta::euler_step(f, t, y, h);
}

/// Euler's step from y, with the slope of another time and place.
VectorXd step_with_slope_at(const VectorXd& y, double h, const Rhs& f, double t,
                            const VectorXd& place) {
  return euler([&](double, const VectorXd&) { return f(t, place); }, t, y, h);
}

}  // namespace

TEST_SUITE(TUMBLE_UNIT) {
  TEST_CASE("the slope halfway, followed for the whole step, for any right-hand side") {
    for (int n = 0; n < 16; ++n) {
      const Rhs f = any_rhs();
      const VectorXd y = any_state(1 + n % 5);
      const double t = any_number(-2, 2), h = any_number(0.1, 0.5);
      REQUIRE(student::midpoint_step(f, t, y, h) == close_to(reference(f, t, y, h), rounding(y)));
    }
  }

  TEST_CASE("the right-hand side is evaluated twice: at the start, and half of Euler's step on") {
    for (int n = 0; n < 5; ++n) {
      const Rhs f = any_rhs();
      const VectorXd y = any_state(3), halfway = y + 0.25 * f(1, y);
      const auto answer = student::midpoint_step(f, 1, y, 0.5);
      REQUIRE(answer == evaluated(answer, 2, "twice"));
      REQUIRE(answer == obeys("f is first evaluated at t and y", missed_by(answer, 0, {1, y}), 0));
      REQUIRE(answer == obeys("f is evaluated again at t + h/2, where half a step leads to",
                              missed_by(answer, 1, {1.25, halfway}), rounding(y)));
    }
  }

  TEST_CASE("a stone in free fall comes to exactly where it should") {
    for (int n = 0; n < 5; ++n) {
      const double g = -9.81, x = any_number(0, 10), v = any_number(-5, 5);
      const double t = any_number(-2, 2), h = any_number(0.1, 2);
      // A parabola's slope halfway is its average slope. Some 4 roundings on either side.
      const double size = std::abs(x) + h * (std::abs(v) + h * std::abs(g)) + std::abs(v + h * g);
      const Eigen::Vector2d y(x, v), expected(x + h * v + h * h / 2 * g, v + h * g);
      REQUIRE(student::midpoint_step(free_fall(g), t, y, h) == close_to(expected, 12 * eps * size));
    }
  }

  TEST_CASE("growth by 1 + hλ + (hλ)²/2 per step, also where the step is far too long") {
    for (const double z : {0.5, -0.5, -1., -2., -3., -1e6}) {
      const double h = any_number(0.1, 0.5);
      const VectorXd y = any_state(2);
      const double size = (1 + std::abs(z) + z * z / 2) * size_of(y);
      REQUIRE(student::midpoint_step(growth(z / h), any_number(-2, 2), y, h) ==
              close_to(VectorXd((1 + z + z * z / 2) * y), 16 * eps * size));
    }
  }

  TEST_CASE("half the step, a quarter of the error: the error of many steps falls as h²") {
    const double start = any_number(1, 1.5);  // where the error does not change its sign
    const auto error = [&](const auto& end) { return size_of(end.value() - hill(start + 1)); };
    const auto coarse = climb(student::midpoint_step, start, 16);
    const auto fine = climb(student::midpoint_step, start, 32);
    // Nearer to 2 than to any other whole number.
    REQUIRE(fine == obeys("the error falls as h²",
                          std::abs(order_from(error(coarse), error(fine)) - 2), 0.5));
  }

  TEST_CASE("a negative step goes back in time, and no step goes nowhere") {
    for (const double size : {-0.5, -0.1, 0.}) {
      const Rhs f = any_rhs();
      const VectorXd y = any_state(4);
      const double t = any_number(-2, 2);
      REQUIRE(student::midpoint_step(f, t, y, size) ==
              close_to(reference(f, t, y, size), rounding(y)));
    }
  }

  TEST_CASE("states of any size, an empty one too; tiny and huge ones, and tiny steps") {
    for (const int count : {0, 1, 60}) {
      const Rhs f = any_rhs();
      const VectorXd y = any_state(count);
      const double t = any_number(-2, 2), h = any_number(0.1, 0.5);
      REQUIRE(student::midpoint_step(f, t, y, h) == close_to(reference(f, t, y, h), rounding(y)));
    }
    for (const double size : {1e-200, 1e200}) {
      const VectorXd y = any_state(3, size), slope = any_state(3, size);
      REQUIRE(student::midpoint_step(constant_slope(slope), 1, y, 0.5) ==
              close_to(VectorXd(y + slope / 2), 4 * eps * size * 3));
    }
    for (const double h : {1e-20, -1e-20}) {
      const VectorXd y = any_state(3), slope = any_state(3);
      REQUIRE(student::midpoint_step(constant_slope(slope / h), 1, y, h) ==
              close_to(VectorXd(y + slope), 16 * eps * (size_of(y) + size_of(slope))));
    }
  }
}

const Misconceptions<decltype(particles::midpoint_step)> misconceptions{
    TUMBLE_UNIT,
    {{"Euler's method",
      "This is Euler's step: you have followed the slope at the start all the way. Follow the "
      "slope halfway.",
      "The midpoint method", euler},
     {"half of the time itself",
      "You have taken the second slope at (t + h)/2. Halfway through the step is half of h after "
      "t: look at the brackets.",
      "The midpoint method",
      [](const Rhs& f, double t, const VectorXd& y, double h) -> VectorXd {
        return step_with_slope_at(y, h, f, (t + h) / 2, euler(f, t, y, h / 2));
      }},
     {"half of the state itself",
      "To look ahead you have halved the state as well. Only the step is halved: look at the "
      "brackets.",
      "The midpoint method",
      [](const Rhs& f, double t, const VectorXd& y, double h) -> VectorXd {
        return step_with_slope_at(y, h, f, t + h / 2, euler(f, t, y, h) / 2);
      }},
     {"looked back",
      "You have looked at the slope half a step before the start. The step leads on from y, and so "
      "does the look.",
      "The midpoint method",
      [](const Rhs& f, double t, const VectorXd& y, double h) -> VectorXd {
        return step_with_slope_at(y, h, f, t + h / 2, euler(f, t, y, -h / 2));
      }},
     {"a quarter of a step",
      "You have looked at the slope a quarter of a step ahead. Halfway is half a step.",
      "The midpoint method",
      [](const Rhs& f, double t, const VectorXd& y, double h) -> VectorXd {
        return step_with_slope_at(y, h, f, t + h / 4, euler(f, t, y, h / 4));
      }},
     {"time stands still",
      "You have taken both slopes at the time t. When the state goes half a step on, the time does "
      "too.",
      "The midpoint method",
      [](const Rhs& f, double t, const VectorXd& y, double h) -> VectorXd {
        return step_with_slope_at(y, h, f, t, euler(f, t, y, h / 2));
      }},
     {"time of the end",
      "You have taken the second slope at the time t + h, with the state halfway. Both belong to "
      "the same moment.",
      "The midpoint method",
      [](const Rhs& f, double t, const VectorXd& y, double h) -> VectorXd {
        return step_with_slope_at(y, h, f, t + h, euler(f, t, y, h / 2));
      }},
     {"state stands still",
      "You have taken the second slope at the time halfway, but with the state at the start. When "
      "the time goes half a step on, the state does too.",
      "The midpoint method",
      [](const Rhs& f, double t, const VectorXd& y, double h) -> VectorXd {
        return step_with_slope_at(y, h, f, t + h / 2, y);
      }},
     {"a whole step to look ahead",
      "To see the second slope you went a whole step with Euler's method. Halfway is far enough.",
      "The midpoint method",
      [](const Rhs& f, double t, const VectorXd& y, double h) -> VectorXd {
        return step_with_slope_at(y, h, f, t + h / 2, euler(f, t, y, h));
      }},
     {"slope at the end",
      "You have looked at the slope where a whole step of Euler's method ends, in time and state. "
      "The one halfway is nearer to the average.",
      "The midpoint method",
      [](const Rhs& f, double t, const VectorXd& y, double h) -> VectorXd {
        return step_with_slope_at(y, h, f, t + h, euler(f, t, y, h));
      }},
     {"h forgotten on the way",
      "To look ahead you have added half of the slope, without the step: h is missing in the state "
      "halfway.",
      "The midpoint method",
      [](const Rhs& f, double t, const VectorXd& y, double h) -> VectorXd {
        return step_with_slope_at(y, h, f, t + h / 2, euler(f, t, y, 0.5));
      }},
     {"on from the middle",
      "You have made the whole step from the place halfway, so it leads half a step too far. That "
      "place is only for looking: the step starts from y.",
      "The midpoint method",
      [](const Rhs& f, double t, const VectorXd& y, double h) -> VectorXd {
        return euler(f, t + h / 2, euler(f, t, y, h / 2), h);
      }},
     {"two half steps of Euler's",
      "You have averaged the slopes at the start and halfway, as two steps of Euler's method do, "
      "each half as long. The error falls no faster than Euler's: use the slope halfway alone, for "
      "the whole step.",
      "The midpoint method",
      [](const Rhs& f, double t, const VectorXd& y, double h) -> VectorXd {
        return euler(f, t + h / 2, euler(f, t, y, h / 2), h / 2);
      }},
     {"both slopes added",
      "You have added both slopes, so the step leads about twice as far. Follow the second one "
      "alone.",
      "The midpoint method",
      [](const Rhs& f, double t, const VectorXd& y, double h) -> VectorXd {
        const VectorXd first = euler(f, t, y, h);
        return step_with_slope_at(first, h, f, t + h / 2, (y + first) / 2);
      }},
     {"h twice on the way", "To look ahead you have multiplied the first slope by h twice.",
      "The midpoint method",
      [](const Rhs& f, double t, const VectorXd& y, double h) -> VectorXd {
        return step_with_slope_at(y, h, f, t + h / 2, euler(f, t, y, h * h / 2));
      }},
     {"h forgotten at the end",
      "You have added the slope halfway to y without the step: h is missing in the last line.",
      "The midpoint method",
      [](const Rhs& f, double t, const VectorXd& y, double h) -> VectorXd {
        return step_with_slope_at(y, 1, f, t + h / 2, euler(f, t, y, h / 2));
      }},
     {"only the change", "This is only the change in y. Add y to it, and return the new state.",
      "The midpoint method",
      [](const Rhs& f, double t, const VectorXd& y, double h) -> VectorXd {
        return reference(f, t, y, h) - y;
      }},
     {"half a step only",
      "The slope halfway is right, but you have followed it for half of the step only.",
      "The midpoint method",
      [](const Rhs& f, double t, const VectorXd& y, double h) -> VectorXd {
        return step_with_slope_at(y, h / 2, f, t + h / 2, euler(f, t, y, h / 2));
      }},
     {"Ralston's method",
      "This is Ralston's method, with a slope two thirds of the way. Its error falls as h² too, "
      "but the midpoint method is another one.",
      "The midpoint method",
      [](const Rhs& f, double t, const VectorXd& y, double h) -> VectorXd {
        const VectorXd first = euler(f, t, y, h / 4);
        return step_with_slope_at(first, 0.75 * h, f, t + 2 * h / 3, euler(f, t, y, 2 * h / 3));
      }},
     {"slopes at both ends averaged",
      "This averages the slopes at the start and at the end of Euler's step: Heun's method. Its "
      "error falls as h² too, but the midpoint method is another one.",
      "The midpoint method",
      [](const Rhs& f, double t, const VectorXd& y, double h) -> VectorXd {
        const VectorXd one = euler(f, t, y, h), two = step_with_slope_at(y, h, f, t + h, one);
        return (one + two) / 2;
      }},
     {"evaluated too often",
      "The result is right, but you have evaluated the right-hand side more often than twice. In a "
      "large scene this is what costs time: keep what it returns.",
      "The midpoint method", [](const Rhs& f, double t, const VectorXd& y, double h) -> VectorXd {
        f(t, y);
        return reference(f, t, y, h);
      }}}};
