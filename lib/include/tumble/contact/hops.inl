#pragma once

#include "tumble/contact/hops.hpp"
#include "tumble/core/compiled.hpp"

namespace tumble::contact::detail {

TUMBLE_BODY bool lift_to_hop(Colliding& a, const collide::ContactPoints& points, const Vec3& normal,
                             double lowest) {
  Vec3 middle = Vec3::Zero();
  for (const Vec3& arm : points) middle += arm / static_cast<double>(points.size());
  const Touching touching(a, nullptr);
  const double ease = normal.dot(touching.K(middle) * normal);
  const double parting = normal.dot(touching.velocity(middle));
  // A motion is that of an impulse along the normal, and one that has no speed there: their
  // energies add up.
  const double all = kinetic_energy(a.body, a.state), hop = lowest * lowest / (2 * ease);
  const double now = parting * parting / (2 * ease), wanted = all < 3 * hop ? all / 50 : hop;
  if (parting >= lowest || now >= wanted) return false;
  const double slower = std::sqrt(1 - (wanted - now) / (all - now));
  const Vec3 impulse = (std::sqrt(2 * ease * wanted) - slower * parting) / ease * normal;
  a.state.P = slower * a.state.P + impulse;
  a.state.L = slower * a.state.L + middle.cross(impulse);
  return true;
}

}  // namespace tumble::contact::detail
