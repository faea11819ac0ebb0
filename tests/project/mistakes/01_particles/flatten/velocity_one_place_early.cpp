// expect: wrong | named not a number | may be named never set
// The velocity starts at place 2 of the particle, not 3.
#include "contract.hpp"

namespace particles {

Eigen::VectorXd flatten(const std::vector<Particle>& particles) {
  // y = (x₁, v₁, x₂, v₂, …)
  Eigen::VectorXd y(6 * particles.size());
  Eigen::Index place = 0;
  for (const Particle& particle : particles) {
    y.segment<3>(place) = particle.x;
    y.segment<3>(place + 2) = particle.v;
    place += 6;
  }
  return y;
}

}  // namespace particles
