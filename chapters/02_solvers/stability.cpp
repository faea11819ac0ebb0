/// @file
/// Where each method is stable, seen by asking the method itself.

#include <cmath>

#include "parts.hpp"
#include "problems.hpp"
#include "stability_function.hpp"
#include "tumble/ode.hpp"

namespace solvers_chapter {

using support::error_number;
using support::number;

namespace {

/// How far along a direction |R| ≤ 1, starting at 0.
template <class Method>
std::string stable_length(Complex direction) {
  const auto is_stable = [&](double s) {
    return std::abs(stability_function<Method>(s * direction)) <= 1 + 1e-10;
  };
  double stable = 0;
  for (double s = 0.05; s <= 1000; s *= 1.01) {
    if (!is_stable(s)) break;
    stable = s;
  }
  if (stable == 0) return "0";
  double unstable = 1.01 * stable;
  if (unstable > 1000) return "no limit";
  for (int i = 0; i < 50; ++i) {
    const double middle = (stable + unstable) / 2;
    (is_stable(middle) ? stable : unstable) = middle;
  }
  return number(stable, 4);
}

}  // namespace

Table stability_table() {
  Table table({"method", "evaluations per step", "stable from 0 to −…", "to ±… i", "|R(−1000)|"});
  const auto add = [&]<class Method>(const std::string& name, const std::string& cost, Method) {
    table.add({name, cost, stable_length<Method>(-1), stable_length<Method>(Complex(0, 1)),
               error_number(std::abs(stability_function<Method>(-1000)))});
  };
  add("Euler", "1", runge_kutta::Euler{});
  add("midpoint", "2", runge_kutta::Midpoint{});
  add("RK4", "4", Rk4{});
  add("DP 5(4)", "6", DormandPrince54{});
  add("DOP853", "12", Dop853{});
  add("backward Euler", "a few, and ∂f/∂y", runge_kutta::BackwardEuler{});
  add("Radau5", "some ten, and ∂f/∂y", Radau5{});
  return table;
}

Table damped_table() {
  Table table({"method", "|R| for h = 0.01 s", "h = 0.05 s", "h = 0.2 s", "h = 0.3 s"});
  const Complex lambda(-1, std::sqrt(99.0));  // of a kilogram on 100 N/m with 2 N s/m
  const auto add = [&]<class Method>(const std::string& name, Method) {
    std::vector<std::string> row{name};
    for (const double h : {0.01, 0.05, 0.2, 0.3})
      row.push_back(number(std::abs(stability_function<Method>(h * lambda)), 3));
    table.add(row);
  };
  add("Euler", runge_kutta::Euler{});
  add("midpoint", runge_kutta::Midpoint{});
  add("RK4", Rk4{});
  add("backward Euler", runge_kutta::BackwardEuler{});
  return table;
}

}  // namespace solvers_chapter
