#pragma once
/// @file
/// Bodies and scenes that tests of contacts throw.

#include <string>

#include "tumble/contact/simulate_contacts.hpp"
#include "tumble/mass/solids/ball.hpp"
#include "tumble/mass/solids/box.hpp"

namespace tumble::test {

using contact::ContactBody;
using contact::ContactScene;

inline constexpr double gravity = 9.81;
inline const Vec3 down(0, 0, -gravity);

inline ContactBody ball(const std::string& name, double radius, const Vec3& x, const Vec3& v,
                        const Vec3& omega = Vec3::Zero()) {
  const RigidBody<> body(mass_properties(Ball{radius}, 1000));
  return {name, body, collide::Convex::ball(radius),
          state_of_motion<double>(body, x, Quat::Identity(), v, omega)};
}

inline ContactBody box(const std::string& name, const Vec3& size, const Vec3& x, const Quat& q,
                       const Vec3& v, const Vec3& omega) {
  const RigidBody<> body(mass_properties(Box{size}, 1000));
  return {name, body, collide::Convex::box(size), state_of_motion<double>(body, x, q, v, omega)};
}

inline ContactScene over_floor(const ContactBody& body, double e, double mu = 0) {
  return {{body}, {collide::HalfSpace{}}, down, e, mu};
}

/// What an energy ledger lacks [J].
inline double balance(const contact::EnergyLedger& energy) {
  return energy.start + energy.impacts + energy.sliding + energy.settled - energy.end;
}

}  // namespace tumble::test
