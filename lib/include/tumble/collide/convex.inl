#pragma once

#include "tumble/collide/convex.hpp"
#include "tumble/core/compiled.hpp"

namespace tumble::collide {

TUMBLE_BODY Bounds bounds_of(const Convex& body, const Pose& pose) {
  Bounds around;
  for (const Vec3& p : body.points()) around.extend(Vec3(pose.R * p));
  const Vec3 wider = Vec3::Constant(body.radius());
  return {pose.x + around.min() - wider, pose.x + around.max() + wider};
}

}  // namespace tumble::collide
