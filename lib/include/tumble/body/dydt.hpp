#pragma once
/// @file
/// The equation of motion of a rigid body, the goal of the course:
///
///   d/dt (x, q, P, L) = (P/m, ½⟨0, ω⟩q, F, τ)
///
/// Source: Baraff, "Rigid Body Simulation I" (1997), eq. 2-22 and §4.

#include <tuple>

#include "tumble/body/derived.hpp"
#include "tumble/body/forces.hpp"
#include "tumble/body/state.hpp"
#include "tumble/quaternion/quaternion_dot.hpp"

namespace tumble {

/// @addtogroup body
/// @{

/// A body and the forces on it, as a right-hand side for the solvers in ode/. The types of the
/// forces are known at compile time: one that is not there costs nothing.
template <class T, BodyForce<T>... Forces>
class RigidBodyRhs {
 public:
  /// @throws std::invalid_argument if a force refuses what it was made of
  explicit RigidBodyRhs(const RigidBody<T>& body, const Forces&... forces)
      : body_(body), forces_(detail::valid_forces(forces...)) {}

  const RigidBody<T>& body() const { return body_; }

  /// dy/dt of the packed state y at time t [s].
  TUMBLE_FLATTEN PackedState<T> operator()(T t, const PackedState<T>& y) const {
    return pack(rate(t, unpack(y)));
  }

  /// The same on the unpacked state: each member holds its own time derivative.
  RigidBodyState<T> rate(T t, const RigidBodyState<T>& state) const {
    const Derived<T> now = derived(body_, state);
    const Wrench<T> wrench = net(t, now);
    return {now.v, rotation::quaternion_dot(state.q, now.omega), wrench.force, wrench.torque};
  }

  /// What all forces do to the body in a motion, or in a state.
  Wrench<T> net(T t, const Derived<T>& now) const { return net_wrench(t, body_, now, forces_); }
  Wrench<T> net(T t, const RigidBodyState<T>& state) const { return net(t, derived(body_, state)); }

 private:
  RigidBody<T> body_;
  std::tuple<Forces...> forces_;
};

template <class T, class... Forces>
RigidBodyRhs(const RigidBody<T>&, const Forces&...) -> RigidBodyRhs<T, Forces...>;

/// @}

}  // namespace tumble
