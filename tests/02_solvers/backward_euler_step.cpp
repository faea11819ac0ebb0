/// @file
/// 2.3 backward_euler_step: its laws, and what goes wrong.
#include "tumble/ode/backward_euler.hpp"
#include "tumble/ode/euler.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "02_solvers/contract.hpp"
#include "judge/spec/shared/right_hand_sides.hpp"
#include "judge/spec/spec.hpp"

using namespace tumble::judge;
using namespace right_hand_sides;
using Eigen::MatrixXd;
using solvers::Jacobian;

namespace student {

/// Ten times the evaluations that the contract allows of both functions.
const Function<decltype(solvers::backward_euler_step)> backward_euler_step{TUMBLE_UNIT, 1000};

}  // namespace student

namespace {

/// A right-hand side and its Jacobian.
struct Problem {
  Rhs f;
  Jacobian dfdy;
};

MatrixXd identity(const VectorXd& y) { return MatrixXd::Identity(y.size(), y.size()); }

// ── Problems ──

MatrixXd jacobian_of(const Coupling& coupling, double t, const VectorXd& y) {
  const auto& [a, b, c] = coupling;
  MatrixXd J = MatrixXd::Zero(y.size(), y.size());
  for (Eigen::Index i = 0; i < y.size(); ++i) {
    const auto place = static_cast<double>(i);
    const Eigen::Index next = (i + 1) % y.size();
    J(i, i) += -b * std::cos(2 * t + place) * std::sin(y[i]) - c;
    J(i, next) += a * std::cos(y[next] + place);
  }
  return J;
}

/// Not linear, of any size; a step of 0.2 s is short for it.
Problem any_problem() {
  const Coupling coupling = any_coupling();
  return {coupled(coupling),
          [coupling](double t, const VectorXd& y) { return jacobian_of(coupling, t, y); }};
}

/// y' = A y.
Problem linear(const MatrixXd& A) {
  return {of_size(A.rows(), [A](double, const VectorXd& y) -> VectorXd { return A * y; }),
          [A](double, const VectorXd&) { return A; }};
}

/// y' = λ (y − cos t) − sin t: falls towards cos t, and stays there.
/// Source: Prothero & Robinson, Mathematics of Computation 28 (1974).
Problem falls_to_cosine(double lambda) {
  return {[lambda](double t, const VectorXd& y) -> VectorXd {
            return lambda * (y.array() - std::cos(t)) - std::sin(t);
          },
          [lambda](double, const VectorXd& y) -> MatrixXd {
            return lambda * MatrixXd::Identity(y.size(), y.size());
          }};
}

/// y' = −y², component by component.
Problem falls_by_its_square() {
  return {[](double, const VectorXd& y) -> VectorXd { return -y.cwiseAbs2(); },
          [](double, const VectorXd& y) -> MatrixXd { return (-2 * y).asDiagonal(); }};
}

/// A number that stays, and others that fall by their square.
Problem first_stays() {
  return {[](double, const VectorXd& y) -> VectorXd {
            VectorXd slope = -y.cwiseAbs2();
            slope[0] = 0;
            return slope;
          },
          [](double, const VectorXd& y) -> MatrixXd {
            VectorXd diagonal = -2 * y;
            diagonal[0] = 0;
            return diagonal.asDiagonal();
          }};
}

/// y' = −2 t y²
Problem hill_problem() {
  return {hill_slope(),
          [](double t, const VectorXd& y) -> MatrixXd { return (-4 * t * y).asDiagonal(); }};
}

/// Three substances that turn into one another, one of them in no time. Nothing gets lost.
/// Source: Robertson (1966), as in Hairer & Wanner, "Solving Ordinary Differential Equations II",
/// 2nd ed. (1996), eq. IV.1.4.
Problem reaction() {
  return {of_size(3,
                  [](double, const VectorXd& y) -> VectorXd {
                    const double slow = 0.04 * y[0], back = 1e4 * y[1] * y[2],
                                 quick = 3e7 * y[1] * y[1];
                    return Eigen::Vector3d(back - slow, slow - back - quick, quick);
                  }),
          of_size(3, [](double, const VectorXd& y) -> MatrixXd {
            Eigen::Matrix3d J;
            J.row(0) << -0.04, 1e4 * y[2], 1e4 * y[1];
            J.row(2) << 0, 6e7 * y[1], 0;
            J.row(1) = -J.row(0) - J.row(2);
            return J;
          })};
}

/// y' = −a sin(x) − b sin(2x + p) with x = y − c t: a bead that is dragged along a wavy wire. A
/// step that is long for it has several solutions.
struct Waves {
  double a, b, p, c;

  Problem problem() const {
    return {[w = *this](double t, const VectorXd& y) -> VectorXd {
              const Eigen::ArrayXd x = y.array() - w.c * t;
              return -w.a * x.sin() - w.b * (2 * x + w.p).sin();
            },
            [w = *this](double t, const VectorXd& y) -> MatrixXd {
              const Eigen::ArrayXd x = y.array() - w.c * t;
              return (-w.a * x.cos() - 2 * w.b * (2 * x + w.p).cos()).matrix().asDiagonal();
            }};
  }
};

/// y' = −κ t y: a brake that closes.
Problem closing_brake(double kappa) {
  return {[kappa](double t, const VectorXd& y) -> VectorXd { return -kappa * t * y; },
          [kappa](double t, const VectorXd& y) -> MatrixXd { return -kappa * t * identity(y); }};
}

/// The same problem for a state whose unit is 1/s as long.
Problem scaled(const Problem& problem, double s) {
  return {[problem, s](double t, const VectorXd& y) -> VectorXd { return s * problem.f(t, y / s); },
          [problem, s](double t, const VectorXd& y) { return problem.dfdy(t, y / s); }};
}

// ── The right answer ──

MatrixXd matrix_of(const Problem& problem, double t, const VectorXd& y1, double h) {
  return MatrixXd::Identity(y1.size(), y1.size()) - h * problem.dfdy(t + h, y1);
}

/// One more round of Newton's method from z.
VectorXd improved(const Problem& problem, double t, const VectorXd& y, double h,
                  const VectorXd& z) {
  VectorXd left = h * problem.f(t + h, z);
  left += y - z;
  return z + matrix_of(problem, t, z, h).partialPivLu().solve(left);
}

VectorXd reference(const Problem& problem, double t, const VectorXd& y, double h) {
  if (y.size() == 0) return y;
  const auto rhs = tumble::with_jacobian(problem.f, problem.dfdy);
  // The library's rounds stop a little above rounding.
  return improved(problem, t, y, h, tumble::runge_kutta::backward_euler_step(rhs, t, y, h));
}

/// What is left of y₁ by who stops at a correction of 1e-8 of y: its square, by and large.
double left_by_newton(const Problem& problem, double t, const VectorXd& y, double h,
                      const VectorXd& y1) {
  const double correction = 1e-8 * std::fmax(size_of(y), size_of(y1));
  double left = 0;
  for (Eigen::Index i = 0; i < y.size(); ++i) {
    const VectorXd before = y1 + correction * VectorXd::Unit(y.size(), i);
    left += size_of(improved(problem, t, y, h, before) - y1);
  }
  return left;
}

/// What rounding may do to a number of y₁: the terms of the equation are rounded, those of f some
/// 20 times, and the inverse of the matrix passes that on.
/// @param terms the largest term in f that is not part of its Jacobian times y₁
double rounding(const Problem& problem, double t, const VectorXd& y, double h, const VectorXd& y1,
                double terms = 4) {
  if (y.size() == 0) return 0;
  const MatrixXd inverse = matrix_of(problem, t, y1, h).inverse();
  const VectorXd of_f = problem.dfdy(t + h, y1).cwiseAbs() * y1.cwiseAbs();
  const double sizes = size_of(y) + size_of(y1) + std::abs(h) * (size_of(of_f) + terms);
  const double passed_on = inverse.cwiseAbs().rowwise().sum().maxCoeff();
  return static_cast<double>(64 + 2 * y.size()) * eps * (passed_on * sizes + size_of(y));
}

/// By how much a number of y₁ may be off.
double allowed(const Problem& problem, double t, const VectorXd& y, double h, const VectorXd& y1,
               double terms = 4) {
  return rounding(problem, t, y, h, y1, terms) + left_by_newton(problem, t, y, h, y1);
}

// ── Wrong methods ──

using Step = std::function<VectorXd(const Rhs&, const Jacobian&, double, const VectorXd&, double)>;

constexpr int many = 25;

/// From y on for a time, with any slope.
VectorXd onward(const VectorXd& y, double time, const VectorXd& slope) { return y + time * slope; }

/// When to stop: at a correction of `enough` …
struct Stop {
  double enough = 1e-10;
  bool of_the_state = true;  ///< … times the state's size
  int rounds = many;
};

/// The z where `residual(z)` is zero, by steps with `matrix(z)`.
VectorXd newton(VectorXd z, const std::function<VectorXd(const VectorXd&)>& residual,
                const std::function<MatrixXd(const VectorXd&)>& matrix, const Stop& stop = {}) {
  const double start = z.norm();
  double moved = std::numeric_limits<double>::infinity();
  const auto is_enough = [&] {
    return moved <= stop.enough * (stop.of_the_state ? std::fmax(start, z.norm()) : 1);
  };
  for (int left = stop.rounds; left > 0 && !is_enough(); --left) {
    const VectorXd way = solvers::solve(matrix(z), residual(z));
    z += way;
    moved = way.norm();
  }
  return z;
}

/// Newton's method for the right equation, with a wrong matrix made of h ∂f/∂y.
Step with_matrix(const std::function<MatrixXd(const MatrixXd& hJ, double h)>& law,
                 const Stop& stop = {}) {
  return [law, stop](const Rhs& f, const Jacobian& dfdy, double t, const VectorXd& y, double h) {
    return newton(
        y, [&](const VectorXd& z) -> VectorXd { return onward(y, h, f(t + h, z)) - z; },
        [&](const VectorXd& z) -> MatrixXd { return law(h * dfdy(t + h, z), h); }, stop);
  };
}

/// Newton's method for the trapezoidal rule.
/// @param share of h ∂f/∂y in the matrix; right is 1/2
Step trapezoidal(double share) {
  return [share](const Rhs& f, const Jacobian& dfdy, double t, const VectorXd& y, double h) {
    const VectorXd k0 = f(t, y);
    return newton(
        y, [&](const VectorXd& z) -> VectorXd { return y + h / 2 * (k0 + f(t + h, z)) - z; },
        [&](const VectorXd& z) -> MatrixXd { return identity(y) - share * h * dfdy(t + h, z); });
  };
}

MatrixXd right_matrix(const MatrixXd& hJ, double) {
  return MatrixXd::Identity(hJ.rows(), hJ.cols()) - hJ;
}

/// Newton's method for the right equation, with the Jacobian of another place. That comes nearer
/// by a factor only, so it goes on to the end.
Step with_jacobian_at(const std::function<MatrixXd(const Jacobian& dfdy, double t, double h,
                                                   const VectorXd& y, const VectorXd& z)>& at) {
  return [at](const Rhs& f, const Jacobian& dfdy, double t, const VectorXd& y, double h) {
    return newton(
        y, [&](const VectorXd& z) -> VectorXd { return onward(y, h, f(t + h, z)) - z; },
        [&](const VectorXd& z) -> MatrixXd { return identity(y) - h * at(dfdy, t, h, y, z); },
        {.enough = 1e-15, .rounds = 2 * many});
  };
}

/// How many evaluations there were of function number `function`.
template <class Answer>
double evaluations_of(const Answer& answer, std::int64_t function) {
  const auto& all = answer.evaluations();
  return static_cast<double>(std::count_if(all.begin(), all.end(), [&](const Evaluation& each) {
    return each.function.number == function;
  }));
}

}  // namespace

TEST_SUITE(TUMBLE_UNIT) {
  TEST_CASE("the slope at the end leads from y to the end, for any right-hand side") {
    // All is asked before the first answer is looked at: two wrong ways may agree on one problem.
    std::vector<std::pair<Answer<VectorXd>, CloseTo>> answers;
    for (int n = 0; n < 16; ++n) {
      const Problem problem = any_problem();
      const VectorXd y = any_state(1 + n % 5, 1.5);
      const double t = any_number(-2, 2), h = any_number(0.05, 0.2);
      const VectorXd y1 = reference(problem, t, y, h);
      answers.emplace_back(student::backward_euler_step(problem.f, problem.dfdy, t, y, h),
                           close_to(y1, allowed(problem, t, y, h, y1)));
    }
    for (const auto& [answer, right] : answers) REQUIRE(answer == right);
  }

  TEST_CASE("a long step along waves has several solutions: the one that Newton finds from y") {
    // All these numbers may change by 0.3 %, and Newton's method still comes to this solution in 7
    // rounds, with its steps halved or not. It comes to another one with the Jacobian of the start
    // in the first problem, with that of the time t in the second.
    struct Case {
      Waves waves;  // times h
      double x;     // y − c (t + h)
    };
    for (const auto& [times_h, x] :
         {Case{{-2.7311, -0.2882, 1.5014, 0}, 1.4874}, Case{{3.8165, 0, 0, -0.913}, 2.4786}}) {
      const double h = any_number(0.5, 2), t = any_number(-2, 2);
      const Waves waves{times_h.a / h, times_h.b / h, times_h.p, times_h.c / h};
      const Problem problem = waves.problem();
      const VectorXd y = VectorXd::Constant(1, x + any_number(-0.005, 0.005) + waves.c * (t + h));
      const VectorXd y1 = with_matrix(right_matrix)(problem.f, problem.dfdy, t, y, h);
      // The next solution is 1 away or farther; how exact this one is shows in the other cases.
      REQUIRE(student::backward_euler_step(problem.f, problem.dfdy, t, y, h) == close_to(y1, 1e-3));
    }
  }

  TEST_CASE("in any unit: numbers of 1e-30 or 1e30 take the right step") {
    for (const int exponent : {-100, -30, 30, 100}) {
      const Problem problem = any_problem();
      const double s = std::ldexp(1, exponent);  // so that nothing is rounded
      const VectorXd y = any_state(3, 1.5);
      const double t = any_number(-2, 2), h = any_number(0.1, 0.2);
      const VectorXd y1 = reference(problem, t, y, h), in_units = s * y1;
      const Problem same = scaled(problem, s);
      REQUIRE(student::backward_euler_step(same.f, same.dfdy, t, s * y, h) ==
              close_to(in_units, s * allowed(problem, t, y, h, y1)));
    }
  }

  TEST_CASE("a brake that closes within the step counts as it is at the end") {
    // With the Jacobian of the start each round would make what is left 4 times as large, or more.
    for (const double closed : {10., 1e3, 1e6}) {
      const double h = any_number(0.1, 1), t = any_number(0, 0.1) * h;
      const Problem problem = closing_brake(closed / (h * h));
      const VectorXd y = any_state(2), y1 = y / (1 + closed * (t + h) / h);
      REQUIRE(student::backward_euler_step(problem.f, problem.dfdy, t, y, h) ==
              close_to(y1, allowed(problem, t, y, h, y1, 0)));
    }
  }

  TEST_CASE("y' = λy: growth by 1/(1 − hλ) per step, down to hλ = −10¹², and no explosion") {
    for (const double z : {0.5, -0.5, -1., -3., -1e3, -1e6, -1e12}) {
      const double h = any_number(0.1, 1) * (z == -1 ? 1e-20 : 1);  // a tiny step is one as well
      const Problem problem = linear(z / h * MatrixXd::Identity(2, 2));
      const VectorXd y = any_state(2), y1 = y / (1 - z);
      const double t = any_number(-2, 2);
      REQUIRE(student::backward_euler_step(problem.f, problem.dfdy, t, y, h) ==
              close_to(y1, allowed(problem, t, y, h, y1, 0)));
    }
  }

  TEST_CASE(
      "y falls to cos t, by λ = −1 to −10⁹: one long step from anywhere ends where it should") {
    for (const double lambda : {-1., -1e3, -1e6, -1e9}) {
      const Problem problem = falls_to_cosine(lambda);
      const double t = any_number(-2, 2), h = any_number(0.1, 2), end = t + h;
      const VectorXd y = any_state(1, 3);
      const VectorXd y1 =
          (y.array() - h * (lambda * std::cos(end) + std::sin(end))) / (1 - h * lambda);
      REQUIRE(student::backward_euler_step(problem.f, problem.dfdy, t, y, h) ==
              close_to(y1, allowed(problem, t, y, h, y1, std::abs(lambda))));
    }
  }

  TEST_CASE("a wheel that turns fast or slowly turns on, and is braked: |y₁| = |y|/√(1 + (hω)²)") {
    for (const double z : {0.1, 1., 10., 1e6}) {
      const double h = any_number(0.1, 1);
      const Problem problem = linear(z / h * (Eigen::Matrix2d() << 0, -1, 1, 0).finished());
      const double t = any_number(-2, 2);
      const VectorXd y = any_state(2);
      const VectorXd y1 = Eigen::Vector2d(y[0] - z * y[1], y[1] + z * y[0]) / (1 + z * z);
      const auto answer = student::backward_euler_step(problem.f, problem.dfdy, t, y, h);
      const double bound = allowed(problem, t, y, h, y1, 0);
      REQUIRE(answer == close_to(y1, bound));
      REQUIRE(answer == obeys("|y₁| = |y|/√(1 + (hω)²)",
                              std::abs(answer->norm() - y.norm() / std::hypot(1, z)), 2 * bound));
    }
  }

  TEST_CASE(
      "y' = −y²: the root of a quadratic, for h from 1e-3 to 1e7, in at most 50 evaluations") {
    // All is asked before the first answer is looked at, and counted at the end: a wrong way that
    // is right for short steps does not explain too many evaluations.
    std::vector<std::pair<Answer<VectorXd>, CloseTo>> answers;
    for (const double h : {1e-3, 0.1, 1., 10., 1e3, 1e7}) {
      const Problem problem = falls_by_its_square();
      const double t = any_number(-2, 2);
      VectorXd y(2);
      for (double& number : y) number = any_number(0.1, 2);
      // The root in the form that loses nothing where h is small.
      const VectorXd y1 = 2 * y.array() / (1 + (1 + 4 * h * y.array()).sqrt());
      answers.emplace_back(student::backward_euler_step(problem.f, problem.dfdy, t, y, h),
                           close_to(y1, allowed(problem, t, y, h, y1, 0)));
    }
    for (const auto& [answer, right] : answers) REQUIRE(answer == right);
    for (const auto& [answer, right] : answers) {
      REQUIRE(answer == at_most("f is evaluated at most 50 times", evaluations_of(answer, 0), 50));
      REQUIRE(answer ==
              at_most("dfdy is evaluated at most 50 times", evaluations_of(answer, 1), 50));
    }
  }

  TEST_CASE("a component that is there at once does not stop the others: all come out right") {
    for (const double h : {1., 1e3}) {
      const Problem problem = first_stays();
      VectorXd y(3);
      for (double& number : y) number = any_number(0.1, 2);
      VectorXd y1 = 2 * y.array() / (1 + (1 + 4 * h * y.array()).sqrt());
      y1[0] = y[0];
      REQUIRE(student::backward_euler_step(problem.f, problem.dfdy, 0, y, h) ==
              close_to(y1, allowed(problem, 0, y, h, y1, 0)));
    }
  }

  TEST_CASE("a chemical reaction, stiff and not linear: the right step, and no matter gets lost") {
    for (const double h : {1e-4, 1e-2, 1., 10.}) {
      const Problem problem = reaction();
      const VectorXd y = Eigen::Vector3d{any_number(0.5, 1), 0, any_number(0.1, 0.5)};
      const VectorXd y1 = reference(problem, 0, y, h);
      const auto answer = student::backward_euler_step(problem.f, problem.dfdy, 0, y, h);
      REQUIRE(answer == close_to(y1, allowed(problem, 0, y, h, y1, 0)));
      // Each round keeps the sum.
      REQUIRE(answer == obeys("Σ y₁ = Σ y", std::abs(answer->sum() - y.sum()),
                              3 * rounding(problem, 0, y, h, y1, 0)));
    }
  }

  TEST_CASE("half the step, half the error: the error of many steps falls as h") {
    const double start = any_number(1, 1.5);  // where the error does not change its sign
    const auto step = [](const Rhs& f, double t, const VectorXd& y, double h) {
      return student::backward_euler_step(f, hill_problem().dfdy, t, y, h);
    };
    const auto error = [&](const auto& end) { return size_of(end.value() - hill(start + 1)); };
    const auto coarse = climb(step, start, 16);
    const auto fine = climb(step, start, 32);
    // Nearer to 1 than to any other whole number.
    REQUIRE(fine == obeys("the error falls as h",
                          std::abs(order_from(error(coarse), error(fine)) - 1), 0.5));
  }

  TEST_CASE("back in time, no step at all, a state of zero, an empty one, and one of 30 numbers") {
    const Problem problem = any_problem();
    const double t = any_number(-2, 2);
    const auto holds = [&](const Problem& each, const VectorXd& y, double h) {
      const VectorXd y1 = reference(each, t, y, h);
      return student::backward_euler_step(each.f, each.dfdy, t, y, h) ==
             close_to(y1, allowed(each, t, y, h, y1));
    };
    REQUIRE(holds(problem, any_state(4, 1.5), -0.1));
    REQUIRE(holds(problem, any_state(4, 1.5), 0));
    REQUIRE(holds(problem, VectorXd::Zero(3), 0.1));
    REQUIRE(holds(linear(-1e6 * MatrixXd::Identity(3, 3)), VectorXd::Zero(3), 0.1));
    REQUIRE(holds(problem, VectorXd(0), 0.1));
    REQUIRE(holds(problem, any_state(30, 1.5), 0.1));
  }
}

const Misconceptions<decltype(solvers::backward_euler_step)> misconceptions{
    TUMBLE_UNIT,
    {{"Euler's method",
      "This is the ordinary step of Euler's method, with the slope at the start. For the backward "
      "one the slope at the end counts.",
      "Implicit steps",
      [](const Rhs& f, const Jacobian&, double t, const VectorXd& y, double h) -> VectorXd {
        return tumble::runge_kutta::euler_step(f, t, y, h);
      }},
     {"a step back in time",
      "Your step leads back to t − h. It is only the slope that you look at from behind, from the "
      "end of the step; the time runs forwards.",
      "Implicit steps",
      [](const Rhs& f, const Jacobian& dfdy, double t, const VectorXd& y, double h) {
        return with_matrix(right_matrix)(f, dfdy, t, y, -h);
      }},
     {"one look ahead",
      "You have taken the slope where a step of Euler's method ends. That is not yet the place "
      "where the backward step ends, and in a stiff problem it is far away from it.",
      "Implicit steps",
      [](const Rhs& f, const Jacobian&, double t, const VectorXd& y, double h) -> VectorXd {
        return onward(y, h, f(t + h, tumble::runge_kutta::euler_step(f, t, y, h)));
      }},
     {"put back in again and again",
      "You have put y₁ into the right side again and again, without the Jacobian: fixed-point "
      "iteration. Where a problem is stiff this runs away from the solution.",
      "Implicit steps",
      [](const Rhs& f, const Jacobian&, double t, const VectorXd& y, double h) {
        VectorXd y1 = y;
        for (int round = 0; round < 2 * many; ++round) y1 = onward(y, h, f(t + h, y1));
        return y1;
      }},
     {"one round of Newton's method",
      "This is where the first iteration leads to. For a linear right-hand side it is the "
      "solution, "
      "for others it is only nearer: go on from there.",
      "Implicit steps",
      [](const Rhs& f, const Jacobian& dfdy, double t, const VectorXd& y, double h) -> VectorXd {
        return y + solvers::solve(identity(y) - h * dfdy(t + h, y), h * f(t + h, y));
      }},
     {"stopped too early",
      "You have stopped at a correction of about a thousandth. The next one would still have "
      "changed the answer: go on until nothing but rounding is left.",
      "Implicit steps", with_matrix(right_matrix, {.enough = 1e-3})},
     {"a fixed number to stop at",
      "You stop at a correction below a fixed number. A state whose numbers are all smaller has "
      "not even begun then: compare the correction with the size of the state.",
      "Implicit steps", with_matrix(right_matrix, {.enough = 1e-8, .of_the_state = false})},
     {"a residual below a fixed number",
      "You stop where what is left of the equation is below a fixed number. A state whose numbers "
      "are all smaller has not even begun then, and where the problem is stiff a small residual "
      "says little: look at the correction, and compare it with the size of the state.",
      "Implicit steps",
      [](const Rhs& f, const Jacobian& dfdy, double t, const VectorXd& y, double h) {
        VectorXd z = y;
        for (int round = 0; round < many; ++round) {
          const VectorXd left = onward(y, h, f(t + h, z)) - z;
          if (left.norm() < 1e-8) break;
          z += solvers::solve(identity(y) - h * dfdy(t + h, z), left);
        }
        return z;
      }},
     {"ten rounds of Newton's method",
      "You have stopped after ten iterations, and were not there yet. How large was the last "
      "correction?",
      "Implicit steps", with_matrix(right_matrix, {.enough = 0, .rounds = 10})},
     {"Jacobian of the start",
      "You have evaluated the Jacobian once, at the start. The tangent leads on only where you "
      "are: evaluate the Jacobian anew in each iteration.",
      "Implicit steps",
      with_jacobian_at([](const Jacobian& dfdy, double t, double h, const VectorXd& y,
                          const VectorXd&) { return dfdy(t + h, y); })},
     {"Jacobian at the time of the start",
      "You have evaluated the Jacobian at the time t. It is the derivative of the slope in your "
      "equation, and that belongs to the end of the step.",
      "Implicit steps",
      with_jacobian_at([](const Jacobian& dfdy, double t, double, const VectorXd&,
                          const VectorXd& z) { return dfdy(t, z); })},
     {"first guess by Euler's method",
      "You have begun where a step of Euler's method ends. If the step is long, that is far away, "
      "and from there Newton's method may lead to another solution of the equation, or to none. "
      "Begin with y.",
      "Implicit steps",
      [](const Rhs& f, const Jacobian& dfdy, double t, const VectorXd& y, double h) {
        return newton(
            onward(y, h, f(t, y)),
            [&](const VectorXd& z) -> VectorXd { return onward(y, h, f(t + h, z)) - z; },
            [&](const VectorXd& z) -> MatrixXd { return identity(y) - h * dfdy(t + h, z); },
            {.enough = 1e-14, .rounds = 2 * many});
      }},
     {"first guess of zero",
      "You have begun at zero. If the equation has several solutions, Newton's method may lead to "
      "another one from there. Begin with y.",
      "Implicit steps",
      [](const Rhs& f, const Jacobian& dfdy, double t, const VectorXd& y, double h) {
        return newton(
            VectorXd::Zero(y.size()),
            [&](const VectorXd& z) -> VectorXd { return onward(y, h, f(t + h, z)) - z; },
            [&](const VectorXd& z) -> MatrixXd { return identity(y) - h * dfdy(t + h, z); });
      }},
     {"the first component alone",
      "You have looked at the correction of the first component alone. It may be there at once, "
      "while the others are still on their way: look at all of them.",
      "Implicit steps",
      [](const Rhs& f, const Jacobian& dfdy, double t, const VectorXd& y, double h) {
        VectorXd z = y;
        for (int round = 0; round < many; ++round) {
          const VectorXd way =
              solvers::solve(identity(y) - h * dfdy(t + h, z), onward(y, h, f(t + h, z)) - z);
          z += way;
          if (z.size() == 0 || std::abs(way[0]) <= 1e-10 * std::abs(z[0])) break;
        }
        return z;
      }},
     {"evaluated too often",
      "The result is right, but you go on after nothing changes any more. In a large scene each "
      "evaluation costs time: stop when a correction is small, as compared with the state.",
      "Implicit steps",
      [](const Rhs& f, const Jacobian& dfdy, double t, const VectorXd& y, double h) {
        return with_matrix(right_matrix, {.enough = -1, .rounds = 4 * many})(f, dfdy, t, y, h);
      }},
     {"time of the start",
      "You have taken the slope with the state at the end, but at the time of the start. Both "
      "belong to the end of the step.",
      "Implicit steps",
      [](const Rhs& f, const Jacobian& dfdy, double t, const VectorXd& y, double h) {
        const auto at_start = [&](double, const VectorXd& z) { return f(t, z); };
        const auto dfdy_at_start = [&](double, const VectorXd& z) { return dfdy(t, z); };
        return with_matrix(right_matrix)(at_start, dfdy_at_start, t, y, h);
      }},
     {"trapezoidal rule",
      "You have averaged the slopes at the start and at the end. That is the trapezoidal rule: "
      "more exact, but in a stiff problem it swings about the solution for long. Here the slope at "
      "the end counts alone.",
      "Implicit steps", trapezoidal(0.5)},
     {"trapezoidal rule, with another matrix",
      "In your equation the slopes at the start and at the end are averaged. That is the "
      "trapezoidal rule, and your matrix belongs to the backward step. Here the slope at the end "
      "counts alone.",
      "Implicit steps", trapezoidal(1)},
     {"implicit midpoint", "You have taken the slope halfway between y and y₁. Take it at the end.",
      "Implicit steps",
      [](const Rhs& f, const Jacobian& dfdy, double t, const VectorXd& y, double h) {
        return newton(
            y,
            [&](const VectorXd& z) -> VectorXd {
              return onward(y, h, f(t + h / 2, (y + z) / 2)) - z;
            },
            [&](const VectorXd& z) -> MatrixXd {
              return identity(y) - h / 2 * dfdy(t + h / 2, (y + z) / 2);
            });
      }},
     {"h forgotten in the matrix",
      "In the matrix of Newton's method the Jacobian is not multiplied by the step. So you come to "
      "the "
      "solution slowly or not at all. What is the derivative of the equation with respect to y₁?",
      "Implicit steps", with_matrix([](const MatrixXd& hJ, double h) -> MatrixXd {
        return MatrixXd::Identity(hJ.rows(), hJ.cols()) - (h == 0 ? hJ : MatrixXd(hJ / h));
      })},
     {"sign of the Jacobian",
      "In the matrix of Newton's method the Jacobian has the wrong sign. So you come to the "
      "solution slowly or not at all. What is the derivative of the equation with respect to y₁?",
      "Implicit steps", with_matrix([](const MatrixXd& hJ, double) -> MatrixXd {
        return MatrixXd::Identity(hJ.rows(), hJ.cols()) + hJ;
      })},
     {"identity forgotten",
      "Your matrix of Newton's method is made of the Jacobian alone. y₁ itself is also in the "
      "equation, and has a derivative.",
      "Implicit steps", with_matrix([](const MatrixXd& hJ, double) -> MatrixXd { return -hJ; })},
     {"Jacobian transposed",
      "You have swapped the rows and columns of the Jacobian. Row i holds the derivatives of "
      "component i of f.",
      "Implicit steps", with_matrix([](const MatrixXd& hJ, double) -> MatrixXd {
        return MatrixXd::Identity(hJ.rows(), hJ.cols()) - hJ.transpose();
      })},
     {"one round, at the start",
      "This is one iteration of Newton's method with slope and Jacobian at the time of the start. "
      "They belong to the end of the step, and one iteration is not enough.",
      "Implicit steps",
      [](const Rhs& f, const Jacobian& dfdy, double t, const VectorXd& y, double h) -> VectorXd {
        const VectorXd slope = f(t, y);
        return y + solvers::solve(identity(y) - h * dfdy(t, y), h * slope);
      }}}};
