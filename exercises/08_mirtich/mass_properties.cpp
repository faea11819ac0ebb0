#include "contract.hpp"

namespace mirtich {

// 8.4 mass_properties: mass, centre of mass and inertia.
// What is demanded stands in contract.hpp. Ask: ./tumble hint 8.4 · Be judged: ./tumble check 8.4
MassProperties mass_properties(const Polyhedron& body, double density) {
  throw NotImplemented{};
}

}  // namespace mirtich
