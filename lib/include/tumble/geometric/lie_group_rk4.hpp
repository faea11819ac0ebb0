#pragma once
/// @file
/// The method of Runge and Kutta for orientations: its increments are turns, so that a unit
/// quaternion stays one without being pulled back. Two turns end a step of order 4.
///
///     q₂ = e^{½hω₁} q,  q₃ = e^{½hω₂} q,  q₄ = e^{hω₃ − ½hω₁} q₂
///     q' = e^{h(−ω₁ + 2ω₂ + 2ω₃ + 3ω₄)/12} e^{h(3ω₁ + 2ω₂ + 2ω₃ − ω₄)/12} q
///
/// x, P and L go as in RK4. Source: Celledoni, Marthinsen & Owren, "Commutator-free Lie group
/// methods", Future Generation Computer Systems 19 (2003), §3; Iserles, Munthe-Kaas, Nørsett &
/// Zanna, "Lie-group methods", Acta Numerica 9 (2000).

#include "tumble/body/dydt.hpp"
#include "tumble/quaternion/exp_log.hpp"

namespace tumble::geometric {

/// @addtogroup geometric
/// @{

/// Steps of a body by turns.
struct LieGroupRk4 {
  static constexpr int order = 4;

  /// The state a time h [s] after `state` at time t, four evaluations of the forces.
  template <class T, class... Forces>
  static TUMBLE_FLATTEN RigidBodyState<T> step(const RigidBodyRhs<T, Forces...>& motion, T t,
                                               const RigidBodyState<T>& state, T h) {
    const T half = h / 2;
    const Rate<T> k1 = rate(motion, t, state);
    const RigidBodyState<T> s2 = moved<T>(state, half, k1, turn<T>(half * k1.omega, state.q));
    const Rate<T> k2 = rate(motion, t + half, s2);
    const RigidBodyState<T> s3 = moved<T>(state, half, k2, turn<T>(half * k2.omega, state.q));
    const Rate<T> k3 = rate(motion, t + half, s3);
    const RigidBodyState<T> s4 =
        moved<T>(state, h, k3, turn<T>(h * k3.omega - half * k1.omega, s2.q));
    const Rate<T> k4 = rate(motion, t + h, s4);

    const T twelfth = h / 12;
    const Vector3<T> both = 2 * k2.omega + 2 * k3.omega;
    const Quaternion<T> first = turn<T>(twelfth * (3 * k1.omega + both - k4.omega), state.q);
    const Quaternion<T> q = turn<T>(twelfth * (3 * k4.omega + both - k1.omega), first);
    const Rate<T> mean{
        (k1.v + 2 * k2.v + 2 * k3.v + k4.v) / 6,
        {},
        {(k1.net.force + 2 * k2.net.force + 2 * k3.net.force + k4.net.force) / 6,
         (k1.net.torque + 2 * k2.net.torque + 2 * k3.net.torque + k4.net.torque) / 6}};
    return moved<T>(state, h, mean, q);
  }

 private:
  template <class T>
  struct Rate {
    Vector3<T> v, omega;  // world
    Wrench<T> net;
  };

  template <class T, class... Forces>
  static Rate<T> rate(const RigidBodyRhs<T, Forces...>& motion, T t,
                      const RigidBodyState<T>& state) {
    const Derived<T> now = derived(motion.body(), state);
    return {now.v, now.omega, motion.net(t, now)};
  }

  template <class T>
  static Quaternion<T> turn(const Vector3<T>& by, const Quaternion<T>& q) {
    return exp_quaternion<T>(by) * q;
  }

  template <class T>
  static RigidBodyState<T> moved(const RigidBodyState<T>& state, T h, const Rate<T>& rate,
                                 const Quaternion<T>& q) {
    return {state.x + h * rate.v, q, state.P + h * rate.net.force, state.L + h * rate.net.torque};
  }
};

/// @}

}  // namespace tumble::geometric
