#pragma once
/// @file
/// Particles and their forces as a right-hand side.
///
///     d/dt (x, v) = (v, F/m)
///
/// The forces are a tuple of their own types: one that is not there costs nothing.
/// Source: Witkin & Baraff, "Physically Based Modeling", SIGGRAPH course notes (2001), "Particle
/// System Dynamics", sections 2 and 3.

#include <array>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

#include "tumble/particles/flatten.hpp"
#include "tumble/particles/force.hpp"

namespace tumble::particles {

/// @addtogroup particles
/// @{

/// The masses of n particles (or Eigen::Dynamic) and the forces on them, as an OdeRhs:
///
///     ParticleSystem system(particles, UniformGravity{{0, 0, -9.81}}, LinearDrag{0.1});
///     integrate_adaptive<DormandPrince54>(system, flatten(particles), 0, 1);
template <class T, int n, Force<T>... Forces>
class ParticleSystem {
 public:
  using State = ParticleState<T, n>;

  /// Takes the masses of the particles, in a std::vector or std::array; their positions and
  /// velocities are only looked at by flatten().
  /// @throws std::invalid_argument if a mass is not positive and finite, or a force refuses
  template <class Particles>
  explicit ParticleSystem(const Particles& particles, Forces... forces)
      : masses_(static_cast<Eigen::Index>(particles.size()), 1), forces_(std::move(forces)...) {
    Eigen::Index i = 0;
    for (const Particle<T>& particle : particles) {
      require(particle.mass > 0 && std::isfinite(particle.mass), "particle ", i,
              ": mass = ", particle.mass, " is not positive and finite");
      masses_[i++] = particle.mass;
    }
    std::apply([&](const auto&... force) { (check(force), ...); }, forces_);
  }

  int size() const { return static_cast<int>(masses_.size()); }

  /// The derivative of the state y at time t.
  /// @throws std::invalid_argument if y does not have 6 numbers for each particle
  State dydt(T t, const State& y) const {
    require(y.size() == 6 * masses_.size(), "particle system: a state of ", y.size(),
            " numbers for ", size(), " particles, which need 6 each");
    State ydot = y;
    dydt(t, y.data(), ydot.data());
    return ydot;
  }
  State operator()(T t, const State& y) const { return dydt(t, y); }

  /// The same on plain arrays of 6 numbers for each particle, which do not overlap.
  void dydt(T t, const T y[], T ydot[]) const {
    for (int i = 0; i < size(); ++i) {
      for (int k = 6 * i; k < 6 * i + 3; ++k) {
        ydot[k] = y[k + 3];
        ydot[k + 3] = 0;
      }
    }
    const ParticlesView<T> particles(y, masses_.data(), size());
    const ForceSums<T> push(ydot);
    std::apply([&](const auto&... force) { (apply(force, t, particles, push), ...); }, forces_);
    for (int i = 0; i < size(); ++i)
      for (int k = 6 * i + 3; k < 6 * i + 6; ++k) ydot[k] /= masses_[i];
  }
  void operator()(T t, const T y[], T ydot[]) const { dydt(t, y, ydot); }

 private:
  template <class AForce>
  void check(const AForce& force) const {
    if constexpr (detail::ValidatedForce<AForce>) force.require_valid(size());
  }

  template <class AForce>
  static void apply(const AForce& force, T t, const ParticlesView<T>& particles,
                    const ForceSums<T>& push) {
    if constexpr (ParticleForce<AForce, T>) {
      for (int i = 0; i < particles.size(); ++i) push(i, force(t, particles[i]));
    } else {
      force(t, particles, push);
    }
  }

  Eigen::Matrix<T, n, 1> masses_;
  std::tuple<Forces...> forces_;
};

template <class T, class... Forces>
ParticleSystem(const std::vector<Particle<T>>&, Forces...)
    -> ParticleSystem<T, Eigen::Dynamic, Forces...>;
template <class T, std::size_t n, class... Forces>
ParticleSystem(const std::array<Particle<T>, n>&, Forces...)
    -> ParticleSystem<T, static_cast<int>(n), Forces...>;

/// @}

}  // namespace tumble::particles
