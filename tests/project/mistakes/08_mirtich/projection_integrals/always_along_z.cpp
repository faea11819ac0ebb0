// expect: wrong | named always along z
// The axes are always x and y.
#include <cstddef>

#include "contract.hpp"

namespace mirtich {

namespace {

/// The sum of xᵏ yⁿ⁻ᵏ over k = 0 … n. Divided by n + 1 it is the mean of the n-th power along an
/// edge from x to y.
double power_sum(double x, double y, int n) {
  double sum = 1, power = 1;
  for (int k = 1; k <= n; ++k) {
    power *= y;
    sum = sum * x + power;
  }
  return sum;
}

/// 20 times the mean of x³ y along an edge from (x0, y0) to (x1, y1).
double cube_sum(double x0, double y0, double x1, double y1) {
  return y0 * (4 * x0 * x0 * x0 + 3 * x0 * x0 * x1 + 2 * x0 * x1 * x1 + x1 * x1 * x1) +
         y1 * (4 * x1 * x1 * x1 + 3 * x1 * x1 * x0 + 2 * x1 * x0 * x0 + x0 * x0 * x0);
}

/// 12 times the mean of x² y along that edge.
double square_sum(double x0, double y0, double x1, double y1) {
  return y0 * (3 * x0 * x0 + 2 * x0 * x1 + x1 * x1) + y1 * (3 * x1 * x1 + 2 * x1 * x0 + x0 * x0);
}

}  // namespace

ProjectionIntegrals projection_integrals(const std::vector<Eigen::Vector3d>& corners, int gamma) {
  const int alpha = 0, beta = 1;
  ProjectionIntegrals p{};
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Eigen::Vector3d &from = corners[k], &to = corners[(k + 1) % corners.size()];
    const double a0 = from[alpha], b0 = from[beta], a1 = to[alpha], b1 = to[beta];
    const double da = a1 - a0, db = b1 - b0;
    // ∬ αⁱ βʲ = 1/(i + 1) ∮ αⁱ⁺¹ βʲ dβ
    p.one += db * power_sum(a0, a1, 1) / 2;
    p.a += db * power_sum(a0, a1, 2) / 6;
    p.aa += db * power_sum(a0, a1, 3) / 12;
    p.aaa += db * power_sum(a0, a1, 4) / 20;
    p.ab += db * square_sum(a0, b0, a1, b1) / 24;
    p.aab += db * cube_sum(a0, b0, a1, b1) / 60;
    // ∬ αⁱ βʲ = −1/(j + 1) ∮ αⁱ βʲ⁺¹ dα
    p.b -= da * power_sum(b0, b1, 2) / 6;
    p.bb -= da * power_sum(b0, b1, 3) / 12;
    p.bbb -= da * power_sum(b0, b1, 4) / 20;
    p.abb -= da * cube_sum(b0, a0, b1, a1) / 60;
  }
  return p;
}

}  // namespace mirtich
