/// @file
/// 2.1 error_norm: its laws, and what goes wrong.
#include "02_solvers/contract.hpp"
#include "judge/spec/spec.hpp"
#include "tumble/ode/tolerances.hpp"

using namespace tumble::judge;
using Eigen::VectorXd;
using solvers::Tolerances;

namespace student {
const Function<decltype(solvers::error_norm)> error_norm{TUMBLE_UNIT};
}

namespace {

double reference(const VectorXd& error, const VectorXd& y0, const VectorXd& y1,
                 const Tolerances& tolerances) {
  return tumble::runge_kutta::error_norm(error, y0, y1, {tolerances.relative, tolerances.absolute});
}

/// A ratio takes 4 roundings, its square twice as many and one; the sum one a component; the mean
/// and the root two. On both sides.
double rounding(const VectorXd& error, double norm) {
  return 2 * static_cast<double>(12 + error.size()) * eps * norm;
}

VectorXd any_numbers(int count, double size) {
  VectorXd numbers(count);
  for (double& number : numbers) number = any_number(-size, size);
  return numbers;
}

/// Neither of the two outweighs the other for numbers about 1.
Tolerances any_tolerances() { return {any_number(1e-4, 3e-4), any_number(1e-4, 3e-4)}; }

VectorXd allowed(const VectorXd& y0, const VectorXd& y1, const Tolerances& tolerances) {
  const Eigen::ArrayXd size = y0.array().abs().max(y1.array().abs());
  return tolerances.absolute + tolerances.relative * size;
}

// ── Wrong norms ──

double root_mean_square(const Eigen::ArrayXd& ratios) {
  return ratios.size() == 0 ? 0 : std::sqrt(ratios.square().mean());
}

Eigen::ArrayXd ratios(const VectorXd& error, const VectorXd& y0, const VectorXd& y1,
                      const Tolerances& tolerances) {
  return error.array() / allowed(y0, y1, tolerances).array();
}

/// Norms that combine the right ratios in a wrong way.
auto with_mean(const std::function<double(const Eigen::ArrayXd&)>& mean) {
  return [mean](const VectorXd& error, const VectorXd& y0, const VectorXd& y1,
                const Tolerances& tolerances) {
    return error.size() == 0 ? 0 : mean(ratios(error, y0, y1, tolerances));
  };
}

/// Norms that take something wrong for what is allowed, component by component.
auto with_allowed(
    const std::function<double(double y0, double y1, const Tolerances& tolerances)>& law) {
  return [law](const VectorXd& error, const VectorXd& y0, const VectorXd& y1,
               const Tolerances& tolerances) {
    Eigen::ArrayXd list(error.size());
    for (Eigen::Index i = 0; i < error.size(); ++i)
      list[i] = error[i] / law(y0[i], y1[i], tolerances);
    return root_mean_square(list);
  };
}

}  // namespace

TEST_SUITE(TUMBLE_UNIT) {
  TEST_CASE("the root mean square of errors over what is allowed, for any step") {
    for (int n = 0; n < 20; ++n) {
      const int count = 6 - n % 5;
      const VectorXd error = any_numbers(count, 1e-3);
      VectorXd y0 = any_numbers(count, 2), y1 = any_numbers(count, 2);
      // Small and negative: here the absolute tolerance counts most, and a sign that is kept shows.
      y0[0] = -std::abs(y0[0]) / 10;
      y1[0] = -std::abs(y1[0]) / 10;
      y0[1] += 6;  // large: here the relative one does
      const Tolerances tolerances = any_tolerances();
      const double norm = reference(error, y0, y1, tolerances);
      REQUIRE(student::error_norm(error, y0, y1, tolerances) ==
              close_to(norm, rounding(error, norm)));
    }
  }

  TEST_CASE("where each of any number of components errs by just what is allowed, the norm is 1") {
    for (const int count : {1, 2, 7, 40}) {
      const VectorXd y0 = any_numbers(count, 2), y1 = any_numbers(count, 2);
      const Tolerances tolerances = any_tolerances();
      VectorXd error = allowed(y0, y1, tolerances);
      for (double& number : error)
        if (any_number(-1, 1) < 0) number = -number;
      REQUIRE(student::error_norm(error, y0, y1, tolerances) ==
              close_to(1., 2 * rounding(error, 1)));
    }
  }

  TEST_CASE("10 times the error is 10 times the right norm, and without an error it is 0") {
    const VectorXd error = any_numbers(4, 1e-3), y0 = any_numbers(4, 2), y1 = any_numbers(4, 2);
    const Tolerances tolerances = any_tolerances();
    const double norm = reference(error, y0, y1, tolerances);
    for (const double factor : {0., -1., 10., 1e-100, 1e100})
      REQUIRE(student::error_norm(factor * error, y0, y1, tolerances) ==
              close_to(std::abs(factor) * norm, rounding(error, std::abs(factor) * norm)));
  }

  TEST_CASE("with y0 and y1 exchanged, or with signs turned, the norm is the same right one") {
    for (int n = 0; n < 10; ++n) {
      const VectorXd error = any_numbers(3, 1e-3), y0 = any_numbers(3, 2), y1 = any_numbers(3, 2);
      const Tolerances tolerances = any_tolerances();
      const double norm = reference(error, y0, y1, tolerances), bound = rounding(error, norm);
      REQUIRE(student::error_norm(error, y1, y0, tolerances) == close_to(norm, bound));
      REQUIRE(student::error_norm(error, -y0, -y1, tolerances) == close_to(norm, bound));
      REQUIRE(student::error_norm(-error, y0, -y1, tolerances) == close_to(norm, bound));
    }
  }

  TEST_CASE("metres and kilometres side by side have the right norm: each has its own scale") {
    for (int n = 0; n < 10; ++n) {
      VectorXd error = any_numbers(4, 1e-3), y0 = any_numbers(4, 2), y1 = any_numbers(4, 2);
      const Tolerances tolerances = any_tolerances();
      for (int i = 0; i < 4; ++i) {
        const double unit = std::pow(10, 3 * i);
        for (VectorXd* numbers : {&error, &y0, &y1}) (*numbers)[i] *= unit;
      }
      const double norm = reference(error, y0, y1, tolerances);
      REQUIRE(student::error_norm(error, y0, y1, tolerances) ==
              close_to(norm, rounding(error, norm)));
    }
  }

  TEST_CASE("near zero the absolute tolerance counts alone, for huge numbers the relative one") {
    const VectorXd error = any_numbers(3, 1e-3), zero = VectorXd::Zero(3);
    const Tolerances tolerances = any_tolerances();
    const double norm = std::sqrt(error.squaredNorm() / 3) / tolerances.absolute;
    REQUIRE(student::error_norm(error, zero, zero, tolerances) ==
            close_to(norm, rounding(error, norm)));
    const VectorXd huge = VectorXd::Constant(3, -1e60), error_of_huge = 1e60 * error;
    const double relative = std::sqrt(error.squaredNorm() / 3) / tolerances.relative;
    for (const VectorXd& other : {huge, zero})
      REQUIRE(student::error_norm(error_of_huge, huge, other, tolerances) ==
              close_to(relative, rounding(error, relative)));
    // Of numbers that are not quite zero nothing is left beside the absolute tolerance.
    const VectorXd before = any_numbers(3, 1e-30), after = any_numbers(3, 1e-30);
    REQUIRE(student::error_norm(error, before, after, tolerances) ==
            close_to(norm, rounding(error, norm)));
  }

  TEST_CASE("a state of one number, of many, and an empty one, whose norm is 0") {
    const Tolerances tolerances = any_tolerances();
    for (const int count : {0, 1, 100}) {
      const VectorXd error = any_numbers(count, 1e-3);
      const VectorXd y0 = any_numbers(count, 2), y1 = any_numbers(count, 2);
      const double norm = reference(error, y0, y1, tolerances);
      REQUIRE(student::error_norm(error, y0, y1, tolerances) ==
              close_to(norm, rounding(error, norm)));
    }
  }

  TEST_CASE("a component without an error takes part in the mean, and the others count as ever") {
    const Tolerances tolerances = any_tolerances();
    const VectorXd y0 = any_numbers(4, 2), y1 = any_numbers(4, 2);
    for (int exact = 0; exact < 4; ++exact) {
      VectorXd error = any_numbers(4, 1e-3);
      error[exact] = 0;
      const double norm = reference(error, y0, y1, tolerances);
      REQUIRE(student::error_norm(error, y0, y1, tolerances) ==
              close_to(norm, rounding(error, norm)));
    }
  }
}

const Misconceptions<decltype(solvers::error_norm)> misconceptions{
    TUMBLE_UNIT,
    {{"root forgotten",
      "This is the mean of the squares, without the root: an error 10 times larger counts 100 "
      "times.",
      "The error of a step", with_mean([](const Eigen::ArrayXd& r) { return r.square().mean(); })},
     {"sum for mean",
      "You have added the squares and not divided by their number, so a larger state seems to err "
      "more.",
      "The error of a step",
      with_mean([](const Eigen::ArrayXd& r) { return std::sqrt(r.square().sum()); })},
     {"divided after the root",
      "You have divided the root of the sum by the number of components. Take the mean of the "
      "squares first, and then its root.",
      "The error of a step", with_mean([](const Eigen::ArrayXd& r) {
        return std::sqrt(r.square().sum()) / static_cast<double>(r.size());
      })},
     {"largest component",
      "This is the largest of the ratios. That is a norm too, a stricter one. Here take the root "
      "mean square.",
      "The error of a step", with_mean([](const Eigen::ArrayXd& r) { return r.abs().maxCoeff(); })},
     {"mean without squares",
      "You have averaged the ratios themselves. Average their squares, so that large ones count "
      "more.",
      "The error of a step", with_mean([](const Eigen::ArrayXd& r) { return r.abs().mean(); })},
     {"last component only",
      "Only the last component is left in your sum: each square has replaced the one before it. "
      "Add "
      "them up.",
      "The error of a step", with_mean([](const Eigen::ArrayXd& r) {
        return std::abs(r[r.size() - 1]) / std::sqrt(static_cast<double>(r.size()));
      })},
     {"first component only", "Your sum ends with the first component: a return inside the loop?",
      "The error of a step", with_mean([](const Eigen::ArrayXd& r) {
        return std::abs(r[0]) / std::sqrt(static_cast<double>(r.size()));
      })},
     {"not compared with what is allowed",
      "This is the root mean square of the errors themselves. It says nothing until you measure "
      "them in units of what is allowed.",
      "The error of a step",
      [](const VectorXd& error, const VectorXd&, const VectorXd&, const Tolerances&) {
        return root_mean_square(error.array());
      }},
     {"one scale for the whole state",
      "You have measured all components by the size of the whole state. A small one beside a large "
      "one may then be all wrong: each has its own scale.",
      "The error of a step",
      [](const VectorXd& error, const VectorXd& y0, const VectorXd& y1,
         const Tolerances& tolerances) {
        const double size = std::fmax(y0.norm(), y1.norm());
        return root_mean_square(error.array() / (tolerances.absolute + tolerances.relative * size));
      }},
     {"largest number for every component",
      "You have measured all components by the largest number of the state. A small one beside a "
      "large one may then be all wrong: each has its own scale.",
      "The error of a step",
      [](const VectorXd& error, const VectorXd& y0, const VectorXd& y1,
         const Tolerances& tolerances) {
        const double size = std::fmax(y0.lpNorm<Eigen::Infinity>(), y1.lpNorm<Eigen::Infinity>());
        return root_mean_square(error.array() / (tolerances.absolute + tolerances.relative * size));
      }},
     {"ratio of two means",
      "You have divided the mean error of the whole state by the mean of what is allowed. Divide "
      "component by component first, and then take the mean.",
      "The error of a step",
      [](const VectorXd& error, const VectorXd& y0, const VectorXd& y1,
         const Tolerances& tolerances) {
        return error.size() == 0 ? 0 : error.norm() / allowed(y0, y1, tolerances).norm();
      }},
     {"size before only",
      "You have looked only at the size before the step. Of the sizes before and after it the "
      "larger "
      "one counts.",
      "The error of a step", with_allowed([](double y0, double, const Tolerances& tolerances) {
        return tolerances.absolute + tolerances.relative * std::abs(y0);
      })},
     {"size after only",
      "You have looked only at the size after the step. Of the sizes before and after it the "
      "larger "
      "one counts.",
      "The error of a step", with_allowed([](double, double y1, const Tolerances& tolerances) {
        return tolerances.absolute + tolerances.relative * std::abs(y1);
      })},
     {"sizes averaged",
      "You have averaged the sizes before and after the step. The larger one counts.",
      "The error of a step", with_allowed([](double y0, double y1, const Tolerances& tolerances) {
        return tolerances.absolute + tolerances.relative * (std::abs(y0) + std::abs(y1)) / 2;
      })},
     {"sizes added",
      "You have added the sizes before and after the step. Only the larger one counts.",
      "The error of a step", with_allowed([](double y0, double y1, const Tolerances& tolerances) {
        return tolerances.absolute + tolerances.relative * (std::abs(y0) + std::abs(y1));
      })},
     {"smaller size",
      "You have taken the smaller one of the sizes before and after the step. The larger one "
      "counts.",
      "The error of a step", with_allowed([](double y0, double y1, const Tolerances& tolerances) {
        return tolerances.absolute + tolerances.relative * std::fmin(std::abs(y0), std::abs(y1));
      })},
     {"change for size",
      "You have taken for the size how much the component changes in the step. Its size is how far "
      "it is from zero.",
      "The error of a step", with_allowed([](double y0, double y1, const Tolerances& tolerances) {
        return tolerances.absolute + tolerances.relative * std::abs(y1 - y0);
      })},
     {"signs kept",
      "You have taken the larger of the two numbers, with its sign. A number such as −5 has the "
      "size 5: drop the signs first, then choose the larger one.",
      "The error of a step", with_allowed([](double y0, double y1, const Tolerances& tolerances) {
        return tolerances.absolute + tolerances.relative * std::fmax(y0, y1);
      })},
     {"sign dropped too late",
      "You have chosen the larger one of the two numbers with their signs, and dropped the sign of "
      "that. Of −5 and 1 the size is 5: drop the signs first, then choose.",
      "The error of a step", with_allowed([](double y0, double y1, const Tolerances& tolerances) {
        return tolerances.absolute + tolerances.relative * std::abs(std::fmax(y0, y1));
      })},
     {"tolerances swapped",
      "The relative and the absolute tolerance are swapped. Multiply the relative one by the size "
      "of the component.",
      "The error of a step", with_allowed([](double y0, double y1, const Tolerances& tolerances) {
        return tolerances.relative + tolerances.absolute * std::fmax(std::abs(y0), std::abs(y1));
      })},
     {"larger tolerance for their sum",
      "You have taken the larger one of the absolute and the relative allowance. Add them.",
      "The error of a step", with_allowed([](double y0, double y1, const Tolerances& tolerances) {
        return std::fmax(tolerances.absolute,
                         tolerances.relative * std::fmax(std::abs(y0), std::abs(y1)));
      })},
     {"both tolerances times the size",
      "You have multiplied the absolute tolerance by the component's size as well. Only "
      "the relative one is multiplied: look at the brackets.",
      "The error of a step", with_allowed([](double y0, double y1, const Tolerances& tolerances) {
        const double size = std::fmax(std::abs(y0), std::abs(y1));
        return (tolerances.absolute + tolerances.relative) * size;
      })},
     {"smaller tolerance for their sum",
      "You have taken the smaller one of the absolute and the relative allowance. Add them.",
      "The error of a step", with_allowed([](double y0, double y1, const Tolerances& tolerances) {
        return std::fmin(tolerances.absolute,
                         tolerances.relative * std::fmax(std::abs(y0), std::abs(y1)));
      })},
     {"absolute tolerance forgotten",
      "You have used the relative tolerance only. Where a component is zero it allows no error at "
      "all.",
      "The error of a step", with_allowed([](double y0, double y1, const Tolerances& tolerances) {
        return tolerances.relative * std::fmax(std::abs(y0), std::abs(y1));
      })},
     {"relative tolerance forgotten",
      "You have used the absolute tolerance only. Of a large component it wants more digits than a "
      "double has.",
      "The error of a step", with_allowed([](double, double, const Tolerances& tolerances) {
        return tolerances.absolute;
      })},
     {"zero over zero",
      "Your norm of an empty state is NaN: you have divided a sum of nothing by the number of "
      "nothings.",
      "The error of a step",
      [](const VectorXd& error, const VectorXd& y0, const VectorXd& y1,
         const Tolerances& tolerances) {
        return error.size() == 0 ? std::numeric_limits<double>::quiet_NaN()
                                 : reference(error, y0, y1, tolerances);
      }}}};
