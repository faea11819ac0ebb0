#pragma once
/// @file
/// Steps that a body under forces takes in parts: moving freely, exactly, and being kicked, P and L
/// changing while x and q stand still.
///
/// Each part is the exact motion of a part of the energy, so that whole steps keep what exact
/// motions keep: they are reversible and symplectic, the energy does not drift however many steps
/// there are, the quaternion stays a unit one by itself, and a body without forces goes exactly
/// where it should. For forces that depend on time and place only.
///
/// Source: Hairer, Lubich & Wanner, "Geometric Numerical Integration" (2nd ed. 2006), §II.5,
/// §VII.5; Celledoni, Fassò, Säfström & Zanna, SIAM J. Sci. Comput. 30 (2008), §5.

#include <type_traits>

#include "tumble/body/dydt.hpp"
#include "tumble/free_body/free_flow.hpp"
#include "tumble/geometric/composition.hpp"

namespace tumble::geometric {

/// @addtogroup geometric
/// @{

/// A body that takes such steps; splitting<Strang>(motion) makes one.
/// @tparam Scheme Strang, BlanesMoan4, BlanesMoan6 or KahanLi8
template <class Scheme, BodyForce<double>... Forces>
class Splitting {
 public:
  static constexpr int order = Scheme::order;

  using Motion = RigidBodyRhs<double, std::remove_const_t<Forces>...>;

  explicit Splitting(const Motion& motion) : motion_(motion), flow_(motion.body()) {}

  /// The state a time h [s] after `state` at time t.
  TUMBLE_FLATTEN RigidBodyState<> step(double t, RigidBodyState<> state, double h) const {
    bool kick = Scheme::composition.kick_first;
    for (const double part : Scheme::composition.parts) {
      if (kick) {
        push(t, state, part * h);
      } else {
        move(state, part * h);
        t += part * h;
      }
      kick = !kick;
    }
    return state;
  }

 private:
  void push(double t, RigidBodyState<>& state, double h) const {
    if constexpr (sizeof...(Forces) > 0) {
      const Wrench<> net = motion_.net(t, state);
      state.P += h * net.force;
      state.L += h * net.torque;
    }
  }

  void move(RigidBodyState<>& state, double h) const {
    state.x += (h / motion_.body().mass()) * state.P;
    state.q = flow_.advance(state.q, state.L, h);
  }

  Motion motion_;
  detail::FreeFlow flow_;
};

/// The body of a motion, under its forces, that takes steps of a scheme.
template <class Scheme, class... Forces>
Splitting<Scheme, Forces...> splitting(const RigidBodyRhs<double, Forces...>& motion) {
  return Splitting<Scheme, Forces...>(motion);
}

/// @}

}  // namespace tumble::geometric
