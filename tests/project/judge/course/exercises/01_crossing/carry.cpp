#include "contract.hpp"

namespace crossing {

// 1.1 carry: luggage comes back as it went.
// contract.hpp says what to write. Stuck? ./tumble hint 1.1 · Done? ./tumble check 1.1
Luggage carry(const Luggage& luggage) { throw NotImplemented{}; }

}  // namespace crossing
