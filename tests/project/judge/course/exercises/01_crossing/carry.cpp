#include "contract.hpp"

namespace crossing {

// 1.1 carry: luggage comes back as it went.
// What is demanded stands in contract.hpp. Ask: ./tumble hint 1.1 · Be judged: ./tumble check 1.1
Luggage carry(const Luggage& luggage) { throw NotImplemented{}; }

}  // namespace crossing
