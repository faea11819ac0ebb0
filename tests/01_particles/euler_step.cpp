/// @file
/// 1.3 euler_step: its laws, and what goes wrong.
#include "judge/spec/shared/right_hand_sides.hpp"
#include "tumble/ode/euler.hpp"
#include "tumble/ode/midpoint.hpp"

#include "01_particles/contract.hpp"
#include "judge/spec/spec.hpp"

using namespace tumble::judge;
using namespace right_hand_sides;

namespace student {
const Function<decltype(particles::euler_step)> euler_step{TUMBLE_UNIT};
}

namespace {

VectorXd reference(const Rhs& f, double t, const VectorXd& y, double h) {
  return tumble::runge_kutta::euler_step(f, t, y, h);
}

}  // namespace

TEST_SUITE(TUMBLE_UNIT) {
  TEST_CASE("the slope at the start, followed for the whole step, for any right-hand side") {
    for (int n = 0; n < 16; ++n) {
      const Rhs f = any_rhs();
      const VectorXd y = any_state(1 + n % 5);
      const double t = any_number(-2, 2), h = any_number(0.1, 0.5);
      REQUIRE(student::euler_step(f, t, y, h) == close_to(reference(f, t, y, h), rounding(y)));
    }
  }

  TEST_CASE("the right-hand side is evaluated once, at the start of the step") {
    for (int n = 0; n < 5; ++n) {
      const VectorXd y = any_state(3);
      const double t = any_number(0.5, 2), h = any_number(0.1, 0.5);
      const auto answer = student::euler_step(any_rhs(), t, y, h);
      REQUIRE(answer == evaluated(answer, 1, "once"));
      REQUIRE(answer == obeys("f is evaluated at t and y", missed_by(answer, 0, {t, y}), 0));
    }
  }

  TEST_CASE("a stone in free fall: its position moves at the speed that it had at the start") {
    for (int n = 0; n < 5; ++n) {
      const double g = -9.81, x = any_number(0, 10), v = any_number(-5, 5);
      const double t = any_number(-2, 2), h = any_number(0.1, 2);
      const double size = std::abs(x) + h * (std::abs(v) + std::abs(g));
      const Eigen::Vector2d y(x, v), expected(x + h * v, v + h * g);
      REQUIRE(student::euler_step(free_fall(g), t, y, h) == close_to(expected, 4 * eps * size));
    }
  }

  TEST_CASE("growth by 1 + hλ per step, also where the step is far too long and y explodes") {
    for (const double z : {0.5, -0.5, -1., -2., -3., -1e6}) {
      const double h = any_number(0.1, 0.5);
      const VectorXd y = any_state(2);
      REQUIRE(student::euler_step(growth(z / h), any_number(-2, 2), y, h) ==
              close_to(VectorXd((1 + z) * y), 8 * eps * (1 + std::abs(z)) * size_of(y)));
    }
  }

  TEST_CASE("half the step, half the error: the error of many steps falls as h") {
    const double start = any_number(1, 1.5);  // where the error does not change its sign
    const auto error = [&](const auto& end) { return size_of(end.value() - hill(start + 1)); };
    const auto coarse = climb(student::euler_step, start, 16);
    const auto fine = climb(student::euler_step, start, 32);
    // Nearer to 1 than to any other whole number.
    REQUIRE(fine == obeys("the error falls as h",
                          std::abs(order_from(error(coarse), error(fine)) - 1), 0.5));
  }

  TEST_CASE("a negative step goes back in time, and no step goes nowhere") {
    for (const double size : {-0.5, -0.1, 0.}) {
      const Rhs f = any_rhs();
      const VectorXd y = any_state(4);
      const double t = any_number(-2, 2);
      REQUIRE(student::euler_step(f, t, y, size) ==
              close_to(reference(f, t, y, size), rounding(y)));
    }
  }

  TEST_CASE("states of any size, an empty one too; tiny and huge ones, and tiny steps") {
    for (const int count : {0, 1, 60}) {
      const Rhs f = any_rhs();
      const VectorXd y = any_state(count);
      const double t = any_number(-2, 2), h = any_number(0.1, 0.5);
      REQUIRE(student::euler_step(f, t, y, h) == close_to(reference(f, t, y, h), rounding(y)));
    }
    for (const double size : {1e-200, 1e200}) {
      const VectorXd y = any_state(3, size), slope = any_state(3, size);
      REQUIRE(student::euler_step(constant_slope(slope), 1, y, 0.5) ==
              close_to(VectorXd(y + slope / 2), 4 * eps * size * 3));
    }
    for (const double h : {1e-20, -1e-20}) {
      const VectorXd y = any_state(3), slope = any_state(3);
      REQUIRE(student::euler_step(constant_slope(slope / h), 1, y, h) ==
              close_to(VectorXd(y + slope), 16 * eps * (size_of(y) + size_of(slope))));
    }
  }
}

const Misconceptions<decltype(particles::euler_step)> misconceptions{
    TUMBLE_UNIT,
    {{"h forgotten",
      "You have added the slope as it is. It says what would change in one second; the step is h "
      "seconds long.",
      "Euler's method",
      [](const Rhs& f, double t, const VectorXd& y, double) { return reference(f, t, y, 1); }},
     {"only the change", "This is only the change in y. Add y to it, and return the new state.",
      "Euler's method",
      [](const Rhs& f, double t, const VectorXd& y, double h) -> VectorXd {
        const VectorXd slope = f(t, y);
        return h * slope;
      }},
     {"only the slope",
      "This is f(t, y), the slope. It says where to go, and you have not gone there yet.",
      "Euler's method",
      [](const Rhs& f, double t, const VectorXd& y, double) -> VectorXd { return f(t, y); }},
     {"backwards", "The step goes the wrong way: it leads to the state at t − h.", "Euler's method",
      [](const Rhs& f, double t, const VectorXd& y, double h) -> VectorXd {
        return reference(f, t, y, -h);
      }},
     {"time of the end",
      "You have taken the slope at the time t + h, but with the state at t. Euler's method looks "
      "at the start of the step.",
      "Euler's method",
      [](const Rhs& f, double t, const VectorXd& y, double h) -> VectorXd {
        return reference(f, t + h, y, h);
      }},
     {"time halfway",
      "You have taken the slope halfway through the step in time, with the state at the start. "
      "Both belong to the start.",
      "Euler's method",
      [](const Rhs& f, double t, const VectorXd& y, double h) -> VectorXd {
        return reference(f, t + h / 2, y, h);
      }},
     {"h twice", "You have multiplied the slope by h twice: once is how far it leads.",
      "Euler's method",
      [](const Rhs& f, double t, const VectorXd& y, double h) -> VectorXd {
        return reference(f, t, y, h * h);
      }},
     {"time always zero",
      "You have not told the right-hand side the time of the step: you evaluate it at 0.",
      "Euler's method",
      [](const Rhs& f, double, const VectorXd& y, double h) -> VectorXd {
        return reference(f, 0, y, h);
      }},
     {"h for t",
      "You have evaluated the right-hand side at the time h. The step says how long, the time says "
      "when.",
      "Euler's method",
      [](const Rhs& f, double, const VectorXd& y, double h) -> VectorXd {
        return reference(f, h, y, h);
      }},
     {"t for h",
      "You have multiplied the slope by the time t. What counts is how long the step is, not when "
      "it starts.",
      "Euler's method",
      [](const Rhs& f, double t, const VectorXd& y, double) -> VectorXd {
        return reference(f, t, y, t);
      }},
     {"new numbers used at once",
      "You have replaced the components one after the other, and the later ones already saw the "
      "new values of the earlier ones. All slopes belong to the same, old state.",
      "Euler's method",
      [](const Rhs& f, double t, const VectorXd& y, double h) {
        VectorXd z = y;
        for (Eigen::Index i = 0; i < z.size(); ++i) z[i] = reference(f, t, z, h)[i];
        return z;
      }},
     {"half a step", "The step is half as long as it should be.", "Euler's method",
      [](const Rhs& f, double t, const VectorXd& y, double h) -> VectorXd {
        return reference(f, t, y, h / 2);
      }},
     {"midpoint method",
      "This is the midpoint method, which looks at the slope halfway. It is better, and the next "
      "exercise. Here take the slope at the start.",
      "Euler's method",
      [](const Rhs& f, double t, const VectorXd& y, double h) -> VectorXd {
        return tumble::runge_kutta::midpoint_step(f, t, y, h);
      }},
     {"evaluated too often",
      "The result is right, but you have evaluated the right-hand side more often than once. In a "
      "large scene this is what costs time: keep what it returns, and use it for all components.",
      "Euler's method", [](const Rhs& f, double t, const VectorXd& y, double h) -> VectorXd {
        f(t, y);
        return reference(f, t, y, h);
      }}}};
