#pragma once
/// @file
/// Particles as one column vector for the ODE solver, and back.
///
///     y = (x₁, v₁, x₂, v₂, …),   six numbers a particle
///
/// Source: Witkin & Baraff, "Physically Based Modeling", SIGGRAPH course notes (2001), "Particle
/// System Dynamics", section 3.

#include <array>
#include <span>
#include <vector>

#include "tumble/core/require.hpp"
#include "tumble/particles/particle.hpp"

namespace tumble::particles {

/// @addtogroup particles
/// @{

/// The state of n particles of scalar T: fixed size if n is known, else with n = Eigen::Dynamic.
template <class T, int n>
using ParticleState = Eigen::Matrix<T, n == Eigen::Dynamic ? n : 6 * n, 1>;

/// The positions and velocities one after the other.
/// @return 6n numbers [m, m/s]
template <class T, std::size_t extent>
auto flatten(std::span<const Particle<T>, extent> particles) {
  constexpr int n = extent == std::dynamic_extent ? Eigen::Dynamic : static_cast<int>(extent);
  ParticleState<T, n> y(6 * static_cast<Eigen::Index>(particles.size()), 1);
  Eigen::Index i = 0;
  for (const Particle<T>& particle : particles) {
    y.template segment<3>(i) = particle.x;
    y.template segment<3>(i + 3) = particle.v;
    i += 6;
  }
  return y;
}

/// The same of a std::vector: a state of dynamic size.
template <class T>
ParticleState<T, Eigen::Dynamic> flatten(const std::vector<Particle<T>>& particles) {
  return flatten(std::span<const Particle<T>>(particles));
}

/// The same of a std::array: a state of fixed size, which needs no heap.
template <class T, std::size_t n>
ParticleState<T, static_cast<int>(n)> flatten(const std::array<Particle<T>, n>& particles) {
  return flatten(std::span<const Particle<T>, n>(particles));
}

/// The particles with positions and velocities taken from y, and the masses that they had.
/// @param y         6n numbers, as flatten() orders them
/// @param particles n particles, in a std::vector or std::array
/// @throws std::invalid_argument if the sizes do not match
template <class Particles, class Derived>
Particles unflatten(const Eigen::MatrixBase<Derived>& y, Particles particles) {
  require(y.size() == 6 * static_cast<Eigen::Index>(particles.size()), "unflatten: a state of ",
          y.size(), " numbers for ", particles.size(), " particles, which need 6 each");
  Eigen::Index i = 0;
  for (auto& particle : particles) {
    particle.x = y.template segment<3>(i);
    particle.v = y.template segment<3>(i + 3);
    i += 6;
  }
  return particles;
}

/// @}

}  // namespace tumble::particles
