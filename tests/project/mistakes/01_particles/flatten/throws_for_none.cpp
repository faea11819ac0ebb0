// expect: threw
// The first particle is written before the loop, even if there is none.
#include "contract.hpp"

namespace particles {

Eigen::VectorXd flatten(const std::vector<Particle>& particles) {
  // y = (x₁, v₁, x₂, v₂, …)
  Eigen::VectorXd y(6 * particles.size());
  Eigen::Index place = 0;
  const Particle& first = particles.at(0);
  y.head<6>() << first.x, first.v;
  for (std::size_t n = 1; n < particles.size(); ++n) {
    place += 6;
    y.segment<6>(place) << particles[n].x, particles[n].v;
  }
  return y;
}

}  // namespace particles
