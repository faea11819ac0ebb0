#include "contract.hpp"

namespace solvers {

// 2.4 observed_order: the order that a method is seen to have.
// What is demanded stands in contract.hpp. Ask: ./tumble hint 2.4 · Be judged: ./tumble check 2.4
double observed_order(const std::vector<double>& h, const std::vector<double>& errors) {
  throw NotImplemented{};
}

}  // namespace solvers
