#pragma once

#include "tumble/contact/several_points.hpp"

#include <algorithm>

#include "tumble/contact/friction_impulse.hpp"
#include "tumble/core/compiled.hpp"

namespace tumble::contact::detail {

TUMBLE_BODY MeanPoint mean_of_coming(const Touching& touching, const collide::ContactPoints& points,
                                     const Vec3& normal) {
  MeanPoint mean;
  double sum = 0;
  for (const Vec3& arm : points) {
    const double coming = std::max(0., -normal.dot(touching.velocity(arm)));
    mean.arm += coming * arm;
    sum += coming;
    mean.fastest = std::max(mean.fastest, coming);
  }
  if (sum > 0) mean.arm /= sum;
  return mean;
}

}  // namespace tumble::contact::detail

namespace tumble::contact {

TUMBLE_BODY std::vector<PointImpulse> collide_at_points(Colliding& a, Colliding* b,
                                                        const collide::ContactPoints& points,
                                                        const Surface& surface) {
  constexpr int max_impulses = 100;
  constexpr double nothing = 1e-12;  // of the speed at which the first point comes
  detail::Touching touching(a, b);
  std::vector<PointImpulse> impulses;
  double first = 0;
  for (int i = 0; i < max_impulses; ++i) {
    const auto mean = detail::mean_of_coming(touching, points, surface.normal);
    if (mean.fastest <= nothing * first) break;
    first = std::max(first, mean.fastest);
    const ImpactResult result = collide_with_friction(
        {touching.K(mean.arm), touching.velocity(mean.arm), surface.normal, surface.e, surface.mu});
    touching.push(result.impulse, mean.arm);
    impulses.push_back({mean.arm, result});
  }
  return impulses;
}

TUMBLE_BODY double least_parting(Colliding& a, Colliding* b, const collide::ContactPoints& points,
                                 const Vec3& normal) {
  const detail::Touching touching(a, b);
  double least = std::numeric_limits<double>::infinity();
  for (const Vec3& arm : points) least = std::min(least, normal.dot(touching.velocity(arm)));
  return least;
}

}  // namespace tumble::contact
