/// @file
/// The tableaux fulfil the order conditions of all rooted trees: Hairer, Nørsett & Wanner, "Solving
/// Ordinary Differential Equations I", 2nd ed. (1993), theorem II.2.13.

#include "tumble/ode/butcher_tableau.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <vector>

#include "tumble/ode/dop853.hpp"
#include "tumble/ode/dormand_prince_54.hpp"

using namespace tumble;
using namespace tumble::detail;

namespace {

/// A rooted tree with its density γ and, for a tableau of s stages, its elementary weight at each
/// stage; `magnitude` is the same sum with |aᵢⱼ|, which rounding errors are measured against.
template <std::size_t s>
struct Tree {
  int order = 1;
  long double density = 1;
  runge_kutta::Weights<s> weight{}, magnitude{};
};

template <std::size_t s>
long double dot(const runge_kutta::Weights<s>& b, const runge_kutta::Weights<s>& x) {
  long double sum = 0;
  for (std::size_t i = 0; i < s; ++i) sum += b[i] * x[i];
  return sum;
}

template <std::size_t s>
runge_kutta::Weights<s> absolute(runge_kutta::Weights<s> w) {
  for (long double& x : w) x = x < 0 ? -x : x;
  return w;
}

/// `tree` with one more branch at its root: weightᵢ ← weightᵢ Σⱼ aᵢⱼ branchⱼ.
template <runge_kutta::ButcherTableau Tableau, std::size_t s = Tableau::stages>
Tree<s> grafted(Tree<s> tree, const Tree<s>& branch) {
  const long double others = tree.density / static_cast<long double>(tree.order);
  tree.order += branch.order;
  tree.density = others * branch.density * static_cast<long double>(tree.order);
  for (std::size_t i = 0; i < s; ++i) {
    tree.weight[i] *= dot<s>(Tableau::a[i], branch.weight);
    tree.magnitude[i] *= dot<s>(absolute<s>(Tableau::a[i]), branch.magnitude);
  }
  return tree;
}

/// All trees that are `tree` with branches of `trees[first]` and later ones, up to an order.
template <runge_kutta::ButcherTableau Tableau, class T>
void grow(const T& tree, std::size_t first, int order, const std::vector<T>& trees,
          std::vector<T>& result) {
  if (tree.order == order) result.push_back(tree);
  for (std::size_t k = first; k < trees.size(); ++k)
    if (tree.order + trees[k].order <= order)
      grow<Tableau>(grafted<Tableau>(tree, trees[k]), k, order, trees, result);
}

/// All rooted trees up to an order, shorter ones first.
template <runge_kutta::ButcherTableau Tableau>
std::vector<Tree<Tableau::stages>> rooted_trees(int order) {
  Tree<Tableau::stages> root;
  root.weight.fill(1);
  root.magnitude.fill(1);
  std::vector<Tree<Tableau::stages>> trees;
  for (int n = 1; n <= order; ++n) {
    std::vector<Tree<Tableau::stages>> next;
    grow<Tableau>(root, 0, n, trees, next);
    trees.insert(trees.end(), next.begin(), next.end());
  }
  return trees;
}

/// The highest order up to which Σ bᵢ weightᵢ = 1/γ for every tree, to rounding error.
template <runge_kutta::ButcherTableau Tableau>
int order_of(const runge_kutta::Weights<Tableau::stages>& b, int limit) {
  constexpr long double epsilon = std::numeric_limits<long double>::epsilon();
  int order = limit;
  for (const auto& tree : rooted_trees<Tableau>(limit)) {
    const long double defect = dot(b, tree.weight) - 1 / tree.density;
    // Each factor of a product is a sum of up to 12 terms, and there are at most `limit` of them.
    const long double rounding = 30 * epsilon * (dot(absolute(b), tree.magnitude) + 1);
    if (defect > rounding || defect < -rounding) order = std::min(order, tree.order - 1);
  }
  return order;
}

template <runge_kutta::ButcherTableau Tableau>
void check_row_sums() {
  runge_kutta::Weights<Tableau::stages> ones;
  ones.fill(1);
  for (std::size_t i = 0; i < Tableau::stages; ++i) {
    CAPTURE(i);
    const long double rounding =
        30 * std::numeric_limits<long double>::epsilon() * (1 + dot(absolute(Tableau::a[i]), ones));
    CHECK(std::abs(dot(Tableau::a[i], ones) - Tableau::c[i]) <= rounding);
    for (std::size_t j = i; j < Tableau::stages; ++j) CHECK(Tableau::a[i][j] == 0);
  }
}

/// b − e.
template <std::size_t s, std::size_t n>
runge_kutta::Weights<s> less(runge_kutta::Weights<s> b, const runge_kutta::Weights<n>& e) {
  for (std::size_t i = 0; i < s; ++i) b[i] -= e[i];
  return b;
}

constexpr runge_kutta::Weights<7> extended(const runge_kutta::Weights<6>& w, long double last) {
  return {w[0], w[1], w[2], w[3], w[4], w[5], last};
}

/// The seven stages of the pair as one tableau, f at the end included.
struct DormandPrince7 {
  static constexpr std::size_t stages = 7;
  static constexpr int order = 5;
  using Six = DormandPrince54Tableau;
  static constexpr runge_kutta::Weights<7> c = extended(Six::c, 1), b = extended(Six::b, 0);
  static constexpr std::array<runge_kutta::Weights<7>, 7> a = {extended(Six::a[0], 0),
                                                               extended(Six::a[1], 0),
                                                               extended(Six::a[2], 0),
                                                               extended(Six::a[3], 0),
                                                               extended(Six::a[4], 0),
                                                               extended(Six::a[5], 0),
                                                               b};
};

}  // namespace

TEST_CASE("rooted trees: as many as there are") {
  // 1, 1, 2, 4, 9, 20, 48, 115 of orders 1 to 8 (Hairer, Nørsett & Wanner I, table II.2.1).
  CHECK(rooted_trees<Dop853Tableau>(8).size() == 1 + 1 + 2 + 4 + 9 + 20 + 48 + 115);
}

TEST_CASE("tableaux: each c is the sum of its row, and the method is explicit") {
  check_row_sums<DormandPrince54Tableau>();
  check_row_sums<DormandPrince7>();
  check_row_sums<Dop853Tableau>();
}

TEST_CASE("DormandPrince54: of order 5, the embedded result of order 4") {
  CHECK(order_of<DormandPrince7>(DormandPrince7::b, 6) == 5);
  const auto error = DormandPrince54Tableau::ErrorWeights::weights;
  CHECK(order_of<DormandPrince7>(less(DormandPrince7::b, error), 6) == 4);
}

TEST_CASE("Dop853: of order 8, the embedded results of order 5 and 3") {
  using T = Dop853Tableau;
  CHECK(order_of<T>(T::b, 9) == 8);
  CHECK(order_of<T>(less(T::b, T::ErrorWeights5::weights), 8) == 5);
  CHECK(order_of<T>(less(T::b, T::ErrorWeights3::weights), 8) == 3);
}
