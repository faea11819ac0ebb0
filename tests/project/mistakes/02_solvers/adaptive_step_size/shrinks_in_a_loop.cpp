// expect: wrong
// The step is shortened by tenths until the error fits: never, if it is infinite.
#include <algorithm>

#include "contract.hpp"

namespace solvers {

double adaptive_step_size(double h, double error, int order) {
  constexpr double safety = 0.9, shortest = 0.2, longest = 10;
  if (std::isnan(error)) return shortest * h;
  // ‖e‖ s^(q+1) = 1, so s = ‖e‖^(−1/(q+1))
  double factor = safety;
  for (; error > 1; error *= std::pow(0.9, order + 1)) factor *= 0.9;
  return h * std::clamp(factor, shortest, longest);
}

}  // namespace solvers
