#pragma once
/// @file
/// What a force is: a law for one particle, or one for all of them.
///
/// - F = force(t, particle): the same law for each particle, whatever the others do;
/// - force(t, particles, push): a law that knows who is who and calls push(i, F).
///
/// A lambda of either shape is a force. Source: Witkin & Baraff, "Physically Based Modeling",
/// SIGGRAPH course notes (2001), "Particle System Dynamics", section 4 (unary and n-ary forces).

#include <concepts>

#include "tumble/particles/particle.hpp"

namespace tumble::particles {

/// @addtogroup particles
/// @{

/// All particles, to look at. Indices are from 0 to size() − 1 and are not checked.
template <class T>
class ParticlesView {
 public:
  /// @param y      (x₁, v₁, x₂, v₂, …)
  /// @param masses as many as there are particles
  ParticlesView(const T y[], const T masses[], int size) : y_(y), masses_(masses), size_(size) {}

  int size() const { return size_; }
  T mass(int i) const { return masses_[i]; }                  ///< [kg]
  Vector3<T> x(int i) const { return vector_at(6 * i); }      ///< position [m]
  Vector3<T> v(int i) const { return vector_at(6 * i + 3); }  ///< velocity [m/s]
  Particle<T> operator[](int i) const { return {mass(i), x(i), v(i)}; }

 private:
  Vector3<T> vector_at(int k) const { return {y_[k], y_[k + 1], y_[k + 2]}; }

  const T* y_;
  const T* masses_;
  int size_;
};

/// Where the forces on each particle are summed up.
template <class T>
class ForceSums {
 public:
  /// @param sums six numbers a particle, the last three of them for the sum of its forces
  explicit ForceSums(T sums[]) : sums_(sums) {}

  /// Adds the force F [N] on particle i.
  void operator()(int i, const Vector3<T>& F) const {
    for (int k = 0; k < 3; ++k) sums_[6 * i + 3 + k] += F[k];
  }

 private:
  T* sums_;
};

/// A force on each particle by itself [N].
template <class F, class T>
concept ParticleForce = requires(const F& force, T t, const Particle<T>& particle) {
  { force(t, particle) } -> std::convertible_to<Vector3<T>>;
};

/// A force that looks at all particles and pushes some.
template <class F, class T>
concept SystemForce = requires(const F& force, T t, const ParticlesView<T>& particles,
                               const ForceSums<T>& push) {
  force(t, particles, push);
};

/// A force of either kind.
template <class F, class T>
concept Force = ParticleForce<F, T> || SystemForce<F, T>;

/// @}

}  // namespace tumble::particles

namespace tumble::detail {

/// A force with a method require_valid(n) that refuses what makes no sense for n particles.
template <class F>
concept ValidatedForce = requires(const F& force, int n) {
  force.require_valid(n);
};

}  // namespace tumble::detail
