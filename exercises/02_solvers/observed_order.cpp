#include "contract.hpp"

namespace solvers {

// 2.4 observed_order: the order that a method is seen to have.
// contract.hpp says what to write. Stuck? ./tumble hint 2.4 · Done? ./tumble check 2.4
double observed_order(const std::vector<double>& h, const std::vector<double>& errors) {
  throw NotImplemented{};
}

}  // namespace solvers
