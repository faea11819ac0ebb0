// expect: wrong | named torque turned as well
// The torque is turned, although it is in world axes.
#include "contract.hpp"

namespace rigid_body {

PackedState dydt(const Body& body, const WrenchAt& wrench, double t, const PackedState& y) {
  const State state = unpack(y);
  const Derived now = derived(body, state);
  const Wrench push = wrench(t, state);
  // d/dt (x, q, P, L) = (v, ½⟨0, ω⟩q, F, τ)
  const Quaternion qdot = quaternions::quaternion_dot(state.q, now.omega);
  return pack({now.v, qdot, push.force, now.R * push.torque});
}

}  // namespace rigid_body
