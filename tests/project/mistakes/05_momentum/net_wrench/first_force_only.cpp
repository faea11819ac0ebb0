// expect: wrong
// The return is inside the loop.
#include "contract.hpp"

namespace momentum {

Wrench net_wrench(double mass, const Eigen::Vector3d& x, const Eigen::Matrix3d& R,
                  const Eigen::Vector3d& g, const std::vector<ForceAtBodyPoint>& forces) {
  // The weight m g acts at the centre of mass: no arm, no torque.
  Wrench net{mass * g, Eigen::Vector3d::Zero()};
  for (const auto& [force, p_body] : forces) {
    // p = x + R p_body
    const Eigen::Vector3d p = x + R * p_body;
    // F = m g + Σ Fᵢ,  τ = Σ (pᵢ − x) × Fᵢ
    net.force += force;
    net.torque += torque(force, p, x);
    return net;
  }
  return net;
}

}  // namespace momentum
