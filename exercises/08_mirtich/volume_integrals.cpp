#include "contract.hpp"

namespace mirtich {

// 8.3 volume_integrals: from a volume to its surface.
// What is demanded stands in contract.hpp. Ask: ./tumble hint 8.3 · Be judged: ./tumble check 8.3
VolumeIntegrals volume_integrals(const Polyhedron& body) {
  throw NotImplemented{};
}

}  // namespace mirtich
