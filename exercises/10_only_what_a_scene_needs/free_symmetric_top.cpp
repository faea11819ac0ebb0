#include "contract.hpp"

namespace only_what_a_scene_needs {

// 10.2 free_symmetric_top: any time at once.
// contract.hpp says what to write. Stuck? ./tumble hint 10.2 · Done? ./tumble check 10.2
Quaternion free_symmetric_top(double A, double C, const Quaternion& q0, const Eigen::Vector3d& L,
                              double t) {
  throw NotImplemented{};
}

}  // namespace only_what_a_scene_needs
