// expect: wrong | named float
// The root is taken of a float.
#include <algorithm>

#include "contract.hpp"

namespace solvers {

double adaptive_step_size(double h, double error, int order) {
  constexpr double safety = 0.9, shortest = 0.2, longest = 10;
  if (std::isnan(error)) return shortest * h;
  // ‖e‖ s^(q+1) = 1, so s = ‖e‖^(−1/(q+1))
  const double factor = safety * std::pow(static_cast<float>(error), -1.0f / static_cast<float>(order + 1));
  return h * std::clamp(factor, shortest, longest);
}

}  // namespace solvers
