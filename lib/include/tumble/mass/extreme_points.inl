#pragma once

#include "tumble/mass/extreme_points.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tumble/core/compiled.hpp"

namespace tumble::detail {

TUMBLE_BODY std::vector<Vec3> half_sphere(int count) {
  std::vector<Vec3> directions;
  for (int i = 0; i < count; ++i) {
    const double z = (i + 0.5) / count, r = std::sqrt(1 - z * z);
    const double turn = 2 * std::numbers::pi * i / std::numbers::phi;
    directions.emplace_back(r * std::cos(turn), r * std::sin(turn), z);
  }
  return directions;
}

TUMBLE_BODY std::vector<Vec3> extreme_points(std::span<const Vec3> points) {
  constexpr std::size_t few = 600;
  if (points.size() <= few) return {points.begin(), points.end()};
  std::vector<bool> chosen(points.size());
  for (const Vec3& direction : half_sphere(static_cast<int>(few) / 2)) {
    std::size_t low = 0, high = 0;
    double least = direction.dot(points[0]), most = least;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const double along = direction.dot(points[i]);
      if (along < least) least = along, low = i;
      if (along > most) most = along, high = i;
    }
    chosen[low] = chosen[high] = true;
  }
  std::vector<Vec3> extreme;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (chosen[i]) extreme.push_back(points[i]);
  return extreme;
}

}  // namespace tumble::detail
