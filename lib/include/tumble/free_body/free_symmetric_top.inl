#pragma once

#include "tumble/free_body/free_symmetric_top.hpp"

#include "tumble/core/compiled.hpp"
#include "tumble/core/require.hpp"

namespace tumble {

TUMBLE_BODY RigidBodyState<> free_symmetric_top(const RigidBody<>& body,
                                                const RigidBodyState<>& start, double t) {
  const SymmetricMoments top = nearest_symmetric_top(body);
  require(top.asymmetry <= 4 * detail::inertia_rounding,
          "free_symmetric_top: no two principal moments are ", "equal; the nearest differ by ",
          top.asymmetry, " of their size");
  return {start.x + t / body.mass() * start.P,
          detail::FreeSymmetricTop(top, start.q, start.L).at(t), start.P, start.L};
}

}  // namespace tumble
