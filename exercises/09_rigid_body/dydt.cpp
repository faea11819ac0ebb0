#include "contract.hpp"

namespace rigid_body {

// 9.4 dydt: what moves a rigid body.
// contract.hpp says what to write. Stuck? ./tumble hint 9.4 · Done? ./tumble check 9.4
PackedState dydt(const Body& body, const WrenchAt& wrench, double t, const PackedState& y) {
  throw NotImplemented{};
}

}  // namespace rigid_body
