#include "contract.hpp"

namespace mirtich {

// 8.1 projection_integrals: from a shadow to its edges.
// contract.hpp says what to write. Stuck? ./tumble hint 8.1 · Done? ./tumble check 8.1
ProjectionIntegrals projection_integrals(const std::vector<Eigen::Vector3d>& corners, int gamma) {
  throw NotImplemented{};
}

}  // namespace mirtich
