// expect: wrong
// Without particles the state should be empty.
#include "contract.hpp"

namespace particles {

Eigen::VectorXd flatten(const std::vector<Particle>& particles) {
  // y = (x₁, v₁, x₂, v₂, …)
  if (particles.empty()) return Eigen::VectorXd::Zero(6);
  Eigen::VectorXd y(6 * particles.size());
  Eigen::Index place = 0;
  for (const Particle& particle : particles) {
    y.segment<3>(place) = particle.x;
    y.segment<3>(place + 3) = particle.v;
    place += 6;
  }
  return y;
}

}  // namespace particles
