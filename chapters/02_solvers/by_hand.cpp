/// @file
/// What fits on paper: the next step after an error, two eigenvalues, and an implicit step.

#include <cmath>
#include <string>

#include "parts.hpp"
#include "problems.hpp"
#include "support/svg.hpp"
#include "tumble/ode.hpp"

namespace solvers_chapter {

using support::number;

Table factors_table() {
  Table table({"error norm", "kept?", "error^(-1/5)", "next step"});
  for (const double error : {1e6, 32., 1., 1 / 32., 1e-9}) {
    const double next = runge_kutta::adaptive_step_size(1.0, error, 4);
    table.add({number(error), error <= 1 ? "yes" : "no", number(std::pow(error, -1 / 5.)),
               number(next) + " h"});
  }
  return table;
}

// ── Two eigenvalues ──

Table eigenvalues_table() {
  Table table({"eigenvalue λ", "direction (x, v)", "1/|λ|", "longest step of RK4"});
  constexpr double tau = 0.01;  // [s]
  const double root = std::sqrt(1 / (4 * tau * tau) - 1 / tau);
  for (const double lambda : {-1 / (2 * tau) + root, -1 / (2 * tau) - root})
    table.add({number(lambda, 4) + " /s", "(1, " + number(lambda, 4) + ")",
               number(-1 / lambda, 3) + " s", number(-2.785 / lambda, 3) + " s"});
  return table;
}

// ── An implicit step ──

Table newton_by_hand_table() {
  Table table({"iteration", "fixed-point", "Newton"});
  constexpr double h = 0.1;
  double fixed = 1, newton = 1;
  for (int i = 0; i <= 4; ++i) {
    table.add({std::to_string(i), support::svg_number(fixed, 8), support::svg_number(newton, 8)});
    fixed = 1 + h * fixed * fixed;
    newton += (1 + h * newton * newton - newton) / (1 - 2 * h * newton);
  }
  table.add({"exact", "", support::svg_number((1 - std::sqrt(1 - 4 * h)) / (2 * h), 8)});
  return table;
}

}  // namespace solvers_chapter
