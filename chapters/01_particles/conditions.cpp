/// @file
/// The methods as tableaux, the conditions that make their order, and what a small mistake does.

#include <array>
#include <numbers>
#include <string>
#include <vector>

#include "methods.hpp"
#include "parts.hpp"
#include "tumble/ode/explicit_runge_kutta.hpp"

namespace particles_chapter {

using support::number;

namespace {

/// One slope, at the start.
struct EulerTableau {
  static constexpr std::size_t stages = 1;
  static constexpr int order = 1;
  static constexpr runge_kutta::Weights<1> c{0}, b{1};
  static constexpr std::array<runge_kutta::Weights<1>, 1> a{};
};

/// Two slopes; the second, halfway, is the one that counts.
struct MidpointTableau {
  static constexpr std::size_t stages = 2;
  static constexpr int order = 2;
  static constexpr runge_kutta::Weights<2> c{0, 1 / 2.L}, b{0, 1};
  static constexpr std::array<runge_kutta::Weights<2>, 2> a{{{0}, {1 / 2.L}}};
};

/// The classical method of order four.
struct Rk4Tableau {
  static constexpr std::size_t stages = 4;
  static constexpr int order = 4;
  static constexpr runge_kutta::Weights<4> c{0, 1 / 2.L, 1 / 2.L, 1};
  static constexpr runge_kutta::Weights<4> b{1 / 6.L, 1 / 3.L, 1 / 3.L, 1 / 6.L};
  static constexpr std::array<runge_kutta::Weights<4>, 4> a{
      {{0}, {1 / 2.L}, {0, 1 / 2.L}, {0, 0, 1}}};
};

/// Kutta's other method of order four, with slopes at thirds of the step.
struct ThreeEighthsTableau {
  static constexpr std::size_t stages = 4;
  static constexpr int order = 4;
  static constexpr runge_kutta::Weights<4> c{0, 1 / 3.L, 2 / 3.L, 1};
  static constexpr runge_kutta::Weights<4> b{1 / 8.L, 3 / 8.L, 3 / 8.L, 1 / 8.L};
  static constexpr std::array<runge_kutta::Weights<4>, 4> a{
      {{0}, {1 / 3.L}, {-1 / 3.L, 1}, {1, -1, 1}}};
};

/// The sums of the eight conditions up to order four, in the order of the page.
template <runge_kutta::ButcherTableau T>
std::array<double, 8> condition_sums() {
  constexpr int s = T::stages;
  Eigen::Matrix<double, s, s> A;
  Eigen::Matrix<double, s, 1> b, c;
  for (int i = 0; i < s; ++i) {
    b[i] = static_cast<double>(T::b[static_cast<std::size_t>(i)]);
    c[i] = static_cast<double>(T::c[static_cast<std::size_t>(i)]);
    for (int j = 0; j < s; ++j)
      A(i, j) = static_cast<double>(T::a[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]);
  }
  const Eigen::Matrix<double, s, 1> cc = c.cwiseProduct(c), ccc = cc.cwiseProduct(c), Ac = A * c;
  return {b.sum(),       b.dot(c),     b.dot(cc), b.dot(Ac), b.dot(ccc), b.dot(c.cwiseProduct(Ac)),
          b.dot(A * cc), b.dot(A * Ac)};
}

}  // namespace

Table conditions_table() {
  const std::array<std::string, 8> sums{"Σ bᵢ",         "Σ bᵢ cᵢ",        "Σ bᵢ cᵢ²",
                                        "Σ bᵢ aᵢⱼ cⱼ",  "Σ bᵢ cᵢ³",       "Σ bᵢ cᵢ aᵢⱼ cⱼ",
                                        "Σ bᵢ aᵢⱼ cⱼ²", "Σ bᵢ aᵢⱼ aⱼₖ cₖ"};
  const std::array<int, 8> order{1, 2, 3, 3, 4, 4, 4, 4}, one_over{1, 2, 3, 6, 4, 8, 12, 24};
  const std::array all{condition_sums<EulerTableau>(), condition_sums<MidpointTableau>(),
                       condition_sums<Rk4Tableau>(), condition_sums<ThreeEighthsTableau>()};
  Table table({"for order", "sum", "must be", "Euler", "midpoint", "RK4", "3/8 rule"});
  for (std::size_t i = 0; i < sums.size(); ++i) {
    std::vector<std::string> row{number(order[i]), sums[i],
                                 one_over[i] == 1 ? "1" : "1/" + number(one_over[i])};
    for (const std::array<double, 8>& method : all)
      row.push_back(std::abs(method[i] * one_over[i] - 1) < 1e-14 ? "holds" : number(method[i], 3));
    table.add(row);
  }
  return table;
}

// ── RK4 with a mistake ──

namespace {

/// RK4 whose third slope is looked at where the first one leads to.
struct ThirdFromFirst : Rk4Tableau {
  static constexpr int order = 2;
  static constexpr std::array<runge_kutta::Weights<4>, 4> a{
      {{0}, {1 / 2.L}, {1 / 2.L, 0}, {0, 0, 1}}};
};

/// RK4 whose four slopes weigh the same.
struct EqualWeights : Rk4Tableau {
  static constexpr int order = 2;
  static constexpr runge_kutta::Weights<4> b{1 / 4.L, 1 / 4.L, 1 / 4.L, 1 / 4.L};
};

/// How far the state is off after one turn, by a method that a tableau describes.
template <runge_kutta::ButcherTableau T>
std::vector<std::string> turn_errors(const std::string& name) {
  using Turn = Eigen::Vector2d;
  const auto f = [](double, const Turn& y) -> Turn { return {y[1], -y[0]}; };
  std::vector<std::string> row{name};
  double coarse = 0, fine = 0;
  for (const int steps : {64, 128, 256}) {
    coarse = fine;
    const Turn end = integrate_fixed<runge_kutta::ExplicitRungeKutta<T>>(
        f, Turn(1, 0), 0, 2 * std::numbers::pi, steps);
    fine = (end - Turn(1, 0)).norm();
    row.push_back(support::error_number(fine));
  }
  row.push_back(support::order_text(coarse, fine));
  return row;
}

}  // namespace

Table mistakes_table() {
  Table table({"method", "64 steps", "128 steps", "256 steps", "order"});
  table.add(turn_errors<Rk4Tableau>("RK4"));
  table.add(turn_errors<ThirdFromFirst>("third slope where k₁ leads to"));
  table.add(turn_errors<EqualWeights>("four equal weights"));
  return table;
}

}  // namespace particles_chapter
