// expect: wrong | may be named never set | may be named not a number
// The sum below was never set to 0.
#include "contract.hpp"

namespace solvers {

double observed_order(const std::vector<double>& h, const std::vector<double>& errors) {
  const double count = static_cast<double>(h.size());
  double x_mean = 0, y_mean = 0;
  for (std::size_t i = 0; i < h.size(); ++i) {
    x_mean += std::log(h[i]) / count;
    y_mean += std::log(errors[i]) / count;
  }
  // p = Σ (xᵢ − x̄)(yᵢ − ȳ) / Σ (xᵢ − x̄)²
  double xy = 0, xx;
  for (std::size_t i = 0; i < h.size(); ++i) {
    const double x = std::log(h[i]) - x_mean, y = std::log(errors[i]) - y_mean;
    xy += x * y;
    xx += x * x;
  }
  return xy / xx;
}

}  // namespace solvers
