// expect: crashed
// The last index is computed as size() - 1, which underflows if there are none.
#include "contract.hpp"

namespace particles {

Eigen::VectorXd flatten(const std::vector<Particle>& particles) {
  // y = (x₁, v₁, x₂, v₂, …)
  Eigen::VectorXd y(6 * particles.size());
  Eigen::Index place = 0;
  for (std::size_t n = 0; n <= particles.size() - 1; ++n) {
    const Particle& particle = particles[n];
    y.segment<3>(place) = particle.x;
    y.segment<3>(place + 3) = particle.v;
    place += 6;
  }
  return y;
}

}  // namespace particles
