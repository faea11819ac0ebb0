#include "contract.hpp"

namespace crossing {

Luggage carry(const Luggage& luggage) { return luggage; }

}  // namespace crossing
