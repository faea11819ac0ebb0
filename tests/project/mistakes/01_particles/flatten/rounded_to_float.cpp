// expect: wrong | named float
// The positions go through a float.
#include "contract.hpp"

namespace particles {

Eigen::VectorXd flatten(const std::vector<Particle>& particles) {
  // y = (x₁, v₁, x₂, v₂, …)
  Eigen::VectorXd y(6 * particles.size());
  Eigen::Index place = 0;
  for (const Particle& particle : particles) {
    y.segment<3>(place) = particle.x.cast<float>().cast<double>();
    y.segment<3>(place + 3) = particle.v;
    place += 6;
  }
  return y;
}

}  // namespace particles
