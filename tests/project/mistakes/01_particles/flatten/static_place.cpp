// expect: wrong | crashed
// The place is kept from the last call.
#include "contract.hpp"

namespace particles {

Eigen::VectorXd flatten(const std::vector<Particle>& particles) {
  // y = (x₁, v₁, x₂, v₂, …)
  Eigen::VectorXd y(6 * particles.size());
  static Eigen::Index place = 0;
  for (const Particle& particle : particles) {
    y.segment<3>(place) = particle.x;
    y.segment<3>(place + 3) = particle.v;
    place += 6;
  }
  return y;
}

}  // namespace particles
