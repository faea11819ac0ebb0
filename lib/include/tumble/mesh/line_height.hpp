#pragma once
/// @file
/// How high a vertical line meets a triangle.
///
/// z = (A_a z_a + A_b z_b + A_c z_c) / A with A_a the area, seen from above, of the triangle that
/// the line makes with the side opposite to a: a mean of the corners' heights, never beyond them,
/// however steep the triangle. Source: any text on barycentric coordinates.

#include <algorithm>
#include <cmath>

#include "tumble/mesh/xy_grid.hpp"

namespace tumble::detail {

/// The weights of a line that meets the triangle a, b, c.
struct LineWeights {
  double of_b, of_c;  ///< 2 A_b, 2 A_c [m²]
  double area;        ///< 2 A; 0 for a triangle that is seen edge-on [m²]

  LineWeights(const Vec3& a, const Vec3& b, const Vec3& c, const PlanePoint& line) {
    of_b = twice_area(c, a, line);
    of_c = twice_area(a, b, line);
    area = twice_area(b, c, line) + of_b + of_c;
  }

  /// The height at which the line meets the triangle; that of the lowest corner when edge-on [m].
  double height(const Vec3& a, const Vec3& b, const Vec3& c) const {
    if (!(area > 0)) return std::min({a.z(), b.z(), c.z()});
    return a.z() + (of_b * (b.z() - a.z()) + of_c * (c.z() - a.z())) / area;
  }

 private:
  static double twice_area(const Vec3& p, const Vec3& q, const PlanePoint& line) {
    return std::abs((q.x() - p.x()) * (line.y() - p.y()) - (q.y() - p.y()) * (line.x() - p.x()));
  }
};

}  // namespace tumble::detail
