#include "contract.hpp"

namespace only_what_a_scene_needs {

// 10.1 choose_model: the least that will do.
// What is demanded stands in contract.hpp. Ask: ./tumble hint 10.1 · Be judged: ./tumble check 10.1
Choice choose_model(const Scene& scene, double tolerance) {
  throw NotImplemented{};
}

}  // namespace only_what_a_scene_needs
