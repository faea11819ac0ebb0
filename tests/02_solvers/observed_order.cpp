/// @file
/// 2.4 observed_order: its laws, and what goes wrong.
#include "tumble/ode/observed_order.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "02_solvers/contract.hpp"
#include "judge/spec/spec.hpp"

using namespace tumble::judge;

namespace student {
const Function<decltype(solvers::observed_order)> observed_order{TUMBLE_UNIT};
}

namespace {

using Numbers = std::vector<double>;

double reference(const Numbers& h, const Numbers& errors) {
  return tumble::runge_kutta::observed_order(h, errors);
}

Numbers logarithms(const Numbers& numbers) {
  Numbers list;
  for (const double number : numbers) list.push_back(std::log(number));
  return list;
}

double mean(const Numbers& list) {
  return std::accumulate(list.begin(), list.end(), 0.) / static_cast<double>(list.size());
}

double largest(const Numbers& list) {
  double size = 0;
  for (const double number : list) size = std::fmax(size, std::abs(number));
  return size;
}

/// Σ (a − a₀)(b − b₀).
double products(const Numbers& a, double a0, const Numbers& b, double b0) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - a0) * (b[i] - b0);
  return sum;
}

/// The slope in its textbook form, (n Σxy − Σx Σy)/(n Σx² − (Σx)²), loses most: the sums are at
/// most n X Y and n X², of n terms with 4 roundings each, and what is left of them is n Σ(x − x̄)².
double rounding(const Numbers& h, const Numbers& errors) {
  const Numbers x = logarithms(h), y = logarithms(errors);
  const double n = static_cast<double>(h.size()), X = largest(x), Y = largest(y);
  const double p = std::abs(reference(h, errors));
  return 4 * (n + 4) * eps * n * X * (Y + p * X) / products(x, mean(x), x, mean(x));
}

/// A table such as a program prints it, the steps getting shorter, by unequal factors.
struct Table {
  Numbers h, errors;
};
Table any_table(int count, double order, double noise) {
  Table table;
  double h = any_number(0.2, 0.8);
  const double constant = std::exp(any_number(-3, 3));
  for (int n = 0; n < count; ++n) {
    table.h.push_back(h);
    table.errors.push_back(constant * std::pow(h, order) * std::exp(any_number(-noise, noise)));
    h *= any_number(0.3, 0.7);
  }
  return table;
}

Numbers scaled(Numbers numbers, double factor) {
  for (double& number : numbers) number *= factor;
  return numbers;
}

// ── Wrong slopes ──

double slope(const Numbers& x, const Numbers& y) {
  return products(x, mean(x), y, mean(y)) / products(x, mean(x), x, mean(x));
}

double slope_between(const Numbers& h, const Numbers& errors, std::size_t a, std::size_t b) {
  return std::log(errors[a] / errors[b]) / std::log(h[a] / h[b]);
}

}  // namespace

TEST_SUITE(TUMBLE_UNIT) {
  TEST_CASE("the slope of the line that fits best, for any table of steps and errors") {
    for (int n = 0; n < 20; ++n) {
      // Not three rows first: of three slopes the one from end to end is always the middle one.
      const auto [h, errors] = any_table(3 + (n + 2) % 6, any_number(0.5, 6), 0.5);
      REQUIRE(student::observed_order(h, errors) ==
              close_to(reference(h, errors), rounding(h, errors)));
    }
  }

  TEST_CASE("where the error is exactly C times h to the power p, the order is p") {
    for (const double order : {1., 2., 4., 5., 8.}) {
      const auto [h, errors] = any_table(6, order, 0);
      // The errors of the table are rounded too.
      REQUIRE(student::observed_order(h, errors) == close_to(order, 2 * rounding(h, errors)));
    }
  }

  TEST_CASE("two points make the line: half the step, 1/16 of the error is order 4") {
    const Numbers h{0.2, 0.1}, errors{0.016, 0.001};
    REQUIRE(student::observed_order(h, errors) == close_to(4., 2 * rounding(h, errors)));
    for (int n = 0; n < 8; ++n) {
      const Table table = any_table(2, any_number(0.5, 6), 0.5);
      REQUIRE(student::observed_order(table.h, table.errors) ==
              close_to(reference(table.h, table.errors), rounding(table.h, table.errors)));
    }
  }

  TEST_CASE("units do not matter: steps in hours, errors in millimetres, the right order") {
    const auto [h, errors] = any_table(6, 3, 0.5);
    const Numbers hours = scaled(h, 1 / 3600.), millimetres = scaled(errors, 1000);
    const double order = reference(h, errors);
    // What a scaled number is rounded by counts like the logarithm's own rounding.
    REQUIRE(student::observed_order(hours, errors) == close_to(order, 2 * rounding(hours, errors)));
    REQUIRE(student::observed_order(h, millimetres) ==
            close_to(order, 2 * rounding(h, millimetres)));
  }

  TEST_CASE("the rows may come in any order, some steps more than once: p comes out right") {
    for (int n = 0; n < 5; ++n) {
      auto [h, errors] = any_table(7, 2, 0.5);
      for (std::size_t i = h.size() - 1; i > 0; --i) {
        const auto other = static_cast<std::size_t>(any_number(0, static_cast<double>(i + 1)));
        std::swap(h[i], h[other]);
        std::swap(errors[i], errors[other]);
      }
      REQUIRE(student::observed_order(h, errors) ==
              close_to(reference(h, errors), rounding(h, errors)));
      h[2] = h[3] = h[4];
      REQUIRE(student::observed_order(h, errors) ==
              close_to(reference(h, errors), rounding(h, errors)));
    }
  }

  TEST_CASE("errors that stay are of order 0, errors that grow about as 1/h of one about −1") {
    const auto [h, errors] = any_table(5, -1, 0.2);  // as where rounding rules
    REQUIRE(student::observed_order(h, errors) ==
            close_to(reference(h, errors), rounding(h, errors)));
    const Numbers same(h.size(), any_number(0.01, 1));
    REQUIRE(student::observed_order(h, same) == close_to(0., rounding(h, same)));
  }

  TEST_CASE("tiny and huge steps and errors, of which nothing but the logarithms matter") {
    for (const double size : {1e-200, 1e-12, 1e12, 1e200}) {
      const Table table = any_table(5, 2, 0.5);
      const Numbers h = scaled(table.h, size), errors = scaled(table.errors, size);
      REQUIRE(student::observed_order(h, errors) ==
              close_to(reference(h, errors), rounding(h, errors)));
    }
  }
}

const Misconceptions<decltype(solvers::observed_order)> misconceptions{
    TUMBLE_UNIT,
    {{"wrong sign",
      "The order has the wrong sign. The error falls as h falls: both logarithms go down together.",
      "Observed order",
      [](const Numbers& h, const Numbers& errors) { return -reference(h, errors); }},
     {"no logarithms",
      "This is the slope of the errors themselves against the steps. A power is a straight line "
      "only where both axes are logarithmic.",
      "Observed order", [](const Numbers& h, const Numbers& errors) { return slope(h, errors); }},
     {"logarithm of the errors only",
      "You have taken the logarithm of the errors only. A power is a straight line only where both "
      "axes are logarithmic.",
      "Observed order",
      [](const Numbers& h, const Numbers& errors) { return slope(h, logarithms(errors)); }},
     {"two kinds of logarithms",
      "The logarithms of the steps are natural, those of the errors to the base 10 (std::log and "
      "std::log10). Which one does not matter, but it has to be the same.",
      "Observed order",
      [](const Numbers& h, const Numbers& errors) { return reference(h, errors) / std::log(10); }},
     {"last two points only",
      "You have used only the last two rows of the table. All of them count.", "Observed order",
      [](const Numbers& h, const Numbers& errors) {
        return slope_between(h, errors, h.size() - 2, h.size() - 1);
      }},
     {"first and last point only",
      "You have used only the first and the last row of the table. All of them count.",
      "Observed order",
      [](const Numbers& h, const Numbers& errors) {
        return slope_between(h, errors, 0, h.size() - 1);
      }},
     {"first two points only",
      "You have used only the first two rows of the table. All of them count.", "Observed order",
      [](const Numbers& h, const Numbers& errors) { return slope_between(h, errors, 0, 1); }},
     {"mean of the slopes between neighbours",
      "You have averaged the slopes from each row to the next. In this way rows that are close "
      "together get too much weight.",
      "Observed order",
      [](const Numbers& h, const Numbers& errors) {
        Numbers slopes;
        for (std::size_t i = 1; i < h.size(); ++i)
          slopes.push_back(slope_between(h, errors, i - 1, i));
        return mean(slopes);
      }},
     {"mean of the slopes between all pairs",
      "You have averaged the slopes of all pairs of rows. In this way rows that are close together "
      "get too much weight.",
      "Observed order",
      [](const Numbers& h, const Numbers& errors) {
        Numbers slopes;
        for (std::size_t i = 0; i < h.size(); ++i)
          for (std::size_t j = 0; j < i; ++j)
            if (h[i] != h[j]) slopes.push_back(slope_between(h, errors, i, j));
        return mean(slopes);
      }},
     {"every step taken for half of the one before",
      "You have taken the logarithms of the errors' ratios to the base 2. That is right where each "
      "step is half of the one before; here the steps say by how much they differ.",
      "Observed order",
      [](const Numbers&, const Numbers& errors) {
        Numbers orders;
        for (std::size_t i = 1; i < errors.size(); ++i)
          orders.push_back(std::log2(errors[i - 1] / errors[i]));
        return mean(orders);
      }},
     {"line through the origin",
      "You have made the line go through the origin, where h and the error are 1. It goes through "
      "the point of the two means: the constant C need not be 1.",
      "Observed order",
      [](const Numbers& h, const Numbers& errors) {
        const Numbers x = logarithms(h), y = logarithms(errors);
        return products(x, 0, y, 0) / products(x, 0, x, 0);
      }},
     {"number of rows forgotten",
      "In the formula with plain sums the number of rows is missing, so a sum over the rows is "
      "next "
      "to the product of two such sums, which has n times as many terms.",
      "Observed order",
      [](const Numbers& h, const Numbers& errors) {
        const Numbers x = logarithms(h), y = logarithms(errors);
        const double n = static_cast<double>(h.size()), X = n * mean(x), Y = n * mean(y);
        return (products(x, 0, y, 0) - X * Y) / (products(x, 0, x, 0) - X * X);
      }},
     {"correlation coefficient",
      "This is the coefficient of correlation, which says how well a line fits. The slope of the "
      "line is divided by the spread of the steps alone.",
      "Observed order",
      [](const Numbers& h, const Numbers& errors) {
        return std::copysign(std::sqrt(reference(h, errors) * reference(errors, h)),
                             reference(h, errors));
      }},
     {"ratio of the spreads",
      "You have divided the spread of the errors by the spread of the steps. That is the slope "
      "only where the points lie on a line: the products of the deviations are missing.",
      "Observed order",
      [](const Numbers& h, const Numbers& errors) {
        return std::sqrt(reference(h, errors) / reference(errors, h));
      }},
     {"never negative",
      "Your order is never negative. Where the errors grow as h falls, the line falls, and the "
      "order has a minus.",
      "Observed order",
      [](const Numbers& h, const Numbers& errors) { return std::abs(reference(h, errors)); }},
     {"axes swapped",
      "This is the slope of log h against log error, one over the order. The error goes upwards, "
      "the step to the right.",
      "Observed order",
      [](const Numbers& h, const Numbers& errors) { return reference(errors, h); }},
     {"horizontal distances",
      "This line has the smallest horizontal distances from the points. Take the vertical ones, "
      "between errors: look at what you divide by.",
      "Observed order",
      [](const Numbers& h, const Numbers& errors) { return 1 / reference(errors, h); }},
     {"logarithms of the means",
      "You have averaged the steps and the errors, and then taken the logarithms. Do it the other "
      "way round: the means are those of the logarithms.",
      "Observed order", [](const Numbers& h, const Numbers& errors) {
        const Numbers x = logarithms(h), y = logarithms(errors);
        const double x0 = std::log(mean(h)), y0 = std::log(mean(errors));
        return products(x, x0, y, y0) / products(x, x0, x, x0);
      }}}};
