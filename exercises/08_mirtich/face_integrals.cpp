#include "contract.hpp"

namespace mirtich {

// 8.2 face_integrals: from a face to its shadow.
// contract.hpp says what to write. Stuck? ./tumble hint 8.2 · Done? ./tumble check 8.2
FaceIntegrals face_integrals(const ProjectionIntegrals& shadow, const Plane& plane, int gamma) {
  throw NotImplemented{};
}

}  // namespace mirtich
