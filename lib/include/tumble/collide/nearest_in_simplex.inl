#pragma once

#include "tumble/collide/nearest_in_simplex.hpp"
#include "tumble/core/compiled.hpp"

namespace tumble::collide::detail {

TUMBLE_BODY Simplex part_of(const Simplex& all, int mask) {
  Simplex part;
  for (int i = 0; i < all.size; ++i)
    if (mask >> i & 1) part.add(all.corners[static_cast<std::size_t>(i)]);
  return part;
}

TUMBLE_BODY std::optional<Simplex> nearest_inside(const Simplex& all, int mask) {
  Simplex part = part_of(all, mask);
  const auto &a = part.w(0), &b = part.w(1), &c = part.w(2), &d = part.w(3);
  if (part.size == 1) {
    part.weights = {1};
  } else if (part.size == 2) {
    part.weights = {b.dot(b - a), -a.dot(b - a)};
  } else if (part.size == 3) {
    const Vec3 n = (b - a).cross(c - a);
    part.weights = {n.dot(b.cross(c - b)), n.dot(c.cross(a - c)), n.dot(a.cross(b - a))};
  } else {
    const double side = (b - a).cross(c - a).dot(d - a);
    part.weights = {b.dot((c - b).cross(d - b)), -a.dot((c - a).cross(d - a)),
                    a.dot((b - a).cross(d - a)), -a.dot((b - a).cross(c - a))};
    for (double& weight : part.weights) weight *= std::copysign(1, side);
  }
  double sum = 0;
  for (int i = 0; i < part.size; ++i) {
    if (!(part.weight(i) > 0)) return {};
    sum += part.weight(i);
  }
  for (int i = 0; i < part.size; ++i) part.weight(i) /= sum;
  return part;
}

TUMBLE_BODY Simplex nearest_in(const Simplex& all, double rounding) {
  Simplex best;
  double least = 0;
  for (int mask = 1; mask < 1 << all.size; ++mask) {
    const std::optional<Simplex> part = nearest_inside(all, mask);
    if (!part) continue;
    const double distance = part->point().norm();
    if (part->size == 4 && distance > rounding) continue;
    if (best.size == 0 || distance < least) {
      best = *part;
      least = distance;
    }
  }
  return best;
}

TUMBLE_BODY Vec3 direction_to(const Simplex& part, const Vec3& towards) {
  Vec3 n = part.size == 1 ? part.w(0).normalized() : towards.normalized();
  if (part.size == 3) {
    n = (part.w(1) - part.w(0)).cross(part.w(2) - part.w(0)).normalized();
    if (n.dot(towards) < 0) n = -n;
  } else if (part.size == 2) {
    const Vec3 edge = (part.w(1) - part.w(0)).normalized();
    n = (n - n.dot(edge) * edge).normalized();
  }
  return n;
}

}  // namespace tumble::collide::detail
