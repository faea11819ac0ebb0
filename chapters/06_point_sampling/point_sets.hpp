#pragma once
/// @file
/// The four sets of points of the chapter, by their number.

#include <cmath>
#include <cstdint>
#include <vector>

#include "tumble/core/solid.hpp"
#include "tumble/mass/grid_points.hpp"
#include "tumble/mass/low_discrepancy_points.hpp"
#include "tumble/mass/random_points.hpp"
#include "tumble/mass/stratified_points.hpp"

namespace point_sampling_chapter {

using Seed = std::uint64_t;

inline int per_axis(int n) { return static_cast<int>(std::lround(std::cbrt(n))); }

/// What `use` gives for about n points of a set: random, grid, stratified, R3.
template <class Use>
auto with_points(int set, int n, Seed seed, const Use& use) {
  namespace sampling = tumble::sampling;
  if (set == 0) return use(sampling::RandomPoints(n, seed));
  if (set == 1) return use(sampling::GridPoints(per_axis(n)));
  if (set == 2) return use(sampling::StratifiedPoints(per_axis(n), seed));
  return use(sampling::R3Points(n));
}

/// The points, spread over the solid's bounds, that are inside it.
template <tumble::solids::Solid S, tumble::sampling::SamplePoints P>
std::vector<tumble::Vec3> points_inside(const S& solid, P points) {
  std::vector<tumble::Vec3> inside;
  const Eigen::AlignedBox3d& box = solid.bounds();
  for (std::int64_t i = points.count(); i > 0; --i) {
    const tumble::Vec3 p = box.min() + points.next().cwiseProduct(box.sizes());
    if (solid.contains(p)) inside.push_back(p);
  }
  return inside;
}

}  // namespace point_sampling_chapter
