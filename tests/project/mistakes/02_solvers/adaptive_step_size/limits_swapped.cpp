// expect: wrong | crashed
// The limits are given in the wrong order.
#include <algorithm>

#include "contract.hpp"

namespace solvers {

double adaptive_step_size(double h, double error, int order) {
  constexpr double safety = 0.9, shortest = 0.2, longest = 10;
  if (std::isnan(error)) return shortest * h;
  // ‖e‖ s^(q+1) = 1, so s = ‖e‖^(−1/(q+1))
  const double factor = safety * std::pow(error, -1.0 / (order + 1));
  return h * std::clamp(factor, longest, shortest);
}

}  // namespace solvers
