#pragma once
/// @file
/// The shortest rotation from one direction to another, in closed form.
///
/// Eigen's FromTwoVectors() finds the axis between opposite directions by a singular value
/// decomposition. That takes seconds to compile in every program, and near it 6 digits are lost.

#include <cmath>

#include "tumble/core/types.hpp"

namespace tumble::detail {

/// A unit vector perpendicular to `n`, with no digit lost: n × the axis that n is furthest from.
inline Vec3 perpendicular_to(const Vec3& n) {
  int axis = 0;
  n.cwiseAbs().minCoeff(&axis);
  return n.cross(Vec3::Unit(axis)).normalized();
}

/// The rotation that takes a to b, about a × b and by at most π; with c = a · b and s = a + b it is
///
///     q = ⟨√((1 + c)/2), a × b / √(2 (1 + c))⟩ = ⟨|s|/2, √(1 − |s|²/4) a × s / |a × s|⟩
///
/// The second form keeps its digits where a and b are nearly opposite: s is then exact, 1 + c is
/// not.
/// @param a, b unit vectors
/// @return a unit quaternion; for b = −a the axis is any one across a
inline Quat between_directions(const Vec3& a, const Vec3& b) {
  Quat q;
  const double c = a.dot(b);
  if (c > -0.5) {
    const double root = std::sqrt((1 + c) * 2);
    q.vec() = a.cross(b) * (1 / root);
    q.w() = root * 0.5;
    return q;
  }
  const Vec3 s = a + b, across = a.cross(s);
  const double w = s.norm() / 2, length = across.norm();
  q.vec() = std::sqrt(1 - w * w) * (length > 0 ? Vec3(across / length) : perpendicular_to(a));
  q.w() = w;
  return q;
}

}  // namespace tumble::detail
