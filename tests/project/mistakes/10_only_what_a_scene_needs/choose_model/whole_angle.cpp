// expect: wrong
// The angle is stored in an int.
#include <algorithm>

#include "contract.hpp"

namespace only_what_a_scene_needs {

Choice choose_model(const Scene& scene, double tolerance) {
  const bool orientation_counts = scene.orientation_is_asked || scene.force_depends_on_orientation;
  if (!orientation_counts) return {Model::particle, false};

  Eigen::Vector3d moments = scene.moments;
  std::sort(moments.begin(), moments.end());
  const double low = moments[0], middle = moments[1], high = moments[2];
  const auto equal = [&](double larger, double smaller) {
    // (a − b)/a · ω T ≤ tolerance
    const int angle = static_cast<int>(scene.omega * scene.duration);
    return (larger - smaller) / larger * angle <= tolerance;
  };
  Model model = Model::full_body;
  if (equal(high, middle) || equal(middle, low)) model = Model::symmetric_top;
  if (equal(high, low)) model = Model::ball;
  return {model, scene.torque_acts};
}

}  // namespace only_what_a_scene_needs
