#pragma once

#include "tumble/collide/motion.hpp"

#include <cmath>

#include "tumble/core/compiled.hpp"

namespace tumble::collide::detail {

TUMBLE_BODY Reach farthest_reach(const Convex& body, const Derived<>& now, const Vec3& n,
                                 double s) {
  const Vec3 along = now.R.transpose() * (n + s * n.cross(now.omega));
  const Vec3 arm = now.R * body.point(body.farthest(along));
  return {n.dot(arm) + body.radius(), n.dot(now.v + now.omega.cross(arm))};
}

}  // namespace tumble::collide::detail
