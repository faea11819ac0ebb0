// expect: threw
// The first particle is looked at even if there is none.
#include "contract.hpp"

namespace particles {

Eigen::VectorXd flatten(const std::vector<Particle>& particles) {
  // y = (x₁, v₁, x₂, v₂, …)
  Eigen::VectorXd y = Eigen::VectorXd::Zero(6 * particles.size() + (particles.empty() ? 3 : 0));
  y.head<3>() = particles.at(0).x;
  Eigen::Index place = 0;
  for (const Particle& particle : particles) {
    y.segment<3>(place) = particle.x;
    y.segment<3>(place + 3) = particle.v;
    place += 6;
  }
  return y;
}

}  // namespace particles
