#pragma once
/// @file
/// Bodies and walls of the scenes.

#include <limits>

#include "project/bench/contact/contest.hpp"

namespace tumble::bench {

constexpr double eps = std::numeric_limits<double>::epsilon();
inline const Vec3 weight(0, 0, -9.81);  ///< [m/s²]

Body ball(double radius, double mass, const Vec3& x, const Vec3& v = Vec3::Zero());
Body box(const Vec3& size, double mass, const Vec3& x, const Quat& q);
/// Through the origin.
Wall plane(const Vec3& normal);
/// Walls that face each other, at half the size from the origin; none along an axis of size 0.
std::vector<Wall> room(const Vec3& size);

}  // namespace tumble::bench
