#include "contract.hpp"

namespace crossing {

// 1.2 twice: a function applied twice.
// What is demanded stands in contract.hpp. Ask: ./tumble hint 1.2 · Be judged: ./tumble check 1.2
Eigen::VectorXd twice(const Rhs& f, double t, const Eigen::VectorXd& y, double h) {
  throw NotImplemented{};
}

}  // namespace crossing
