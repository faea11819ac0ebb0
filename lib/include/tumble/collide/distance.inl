#pragma once

#include "tumble/collide/distance.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include "tumble/collide/penetration.hpp"
#include "tumble/core/compiled.hpp"

namespace tumble::collide::detail {

TUMBLE_BODY Distance with_radii(const Difference& difference, const Simplex& nearest, double gap,
                                const Vec3& normal, const Convex& a, const Convex& b) {
  Distance found{gap - a.radius() - b.radius(), normal, a.radius() * normal,
                 -b.radius() * normal,          0,      0};
  for (int i = 0; i < nearest.size; ++i) {
    const Corner& corner = nearest.corners[static_cast<std::size_t>(i)];
    found.arm_a += nearest.weight(i) * difference.arm_a(corner.on_a);
    found.arm_b += nearest.weight(i) * difference.arm_b(corner.on_b);
  }
  return found;
}

TUMBLE_BODY Distance overlap(const Difference& difference, const Simplex& inside, const Convex& a,
                             const Convex& b) {
  if (a.points().size() == 1 && b.points().size() == 1)  // balls with one centre: all are nearest
    return with_radii(difference, inside, 0, Vec3::UnitZ(), a, b);
  Polytope polytope(difference, inside);
  const Penetration deep = polytope.grow();
  std::vector<Penetration> planes{deep};
  if (const auto gap = largest_gap(difference); gap && -gap->size <= deep.depth) {
    if (deep.depth + gap->size > rounding_of(difference)) planes.clear();
    planes.insert(planes.begin(), {-gap->normal, -gap->size, 0, deep.rounds});
  }
  Distance best{};
  best.uncertainty = std::numeric_limits<double>::infinity();
  for (const Penetration& plane : planes) {
    // Where faces are slivers, rounding moves their points, and those of the first touch are
    // nearer.
    for (const Simplex& points : {polytope.touched_by(plane), inside}) {
      Distance found = with_radii(difference, points, -plane.depth, -plane.outwards, a, b);
      const Vec3 off = difference.offset() + found.arm_b - found.arm_a - found.gap * found.normal;
      found.uncertainty = std::max(plane.uncertain, off.norm());
      found.rounds = plane.rounds;
      if (found.uncertainty < best.uncertainty) best = found;
    }
    // Of planes that are as near, the polytope may have grown to one only.
    if (best.uncertainty <= rounding_of(difference)) break;
  }
  return best;
}

}  // namespace tumble::collide::detail

namespace tumble::collide {

TUMBLE_BODY Distance distance(const Convex& a, const Pose& pose_a, const Convex& b,
                              const Pose& pose_b) {
  const detail::Difference difference(a, pose_a, b, pose_b);
  detail::Search search(difference);
  search.run();
  if (search.apart()) {
    Distance found =
        detail::with_radii(difference, search.nearest(), search.gap(), search.normal(), a, b);
    found.uncertainty = search.uncertainty();
    found.rounds = search.rounds();
    return found;
  }
  return detail::overlap(difference, search.nearest(), a, b);
}

TUMBLE_BODY Distance distance(const Convex& body, const Pose& pose, const HalfSpace& wall) {
  const Vec3 arm = pose.R * body.point(body.farthest(pose.R.transpose() * -wall.normal)) -
                   body.radius() * wall.normal;
  const Vec3 from_wall = (pose.x - wall.point) + arm;
  const double gap = from_wall.dot(wall.normal);
  return {gap, -wall.normal, arm, from_wall - gap * wall.normal, 0, 1};
}

}  // namespace tumble::collide
