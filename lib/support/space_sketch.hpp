#pragma once
/// @file
/// Points, arrows and axes of space in a plane drawing: a sketch with a viewer.

#include <array>
#include <string>
#include <vector>

#include "support/sketch.hpp"
#include "support/sphere_curves.hpp"

namespace tumble::support {

/// A sketch of space as one viewer sees it, without perspective.
class SpaceSketch {
 public:
  /// @param view to the viewer's axes: right, up, towards the viewer
  SpaceSketch(Sketch& sketch, const Mat3& view) : sketch_(sketch), view_(view) {}

  Vec2 seen(const Vec3& point) const { return (view_ * point).head<2>(); }
  /// How near to the viewer a point is: for what covers what.
  double nearness(const Vec3& point) const { return view_.row(2).dot(point); }

  void curve(const std::vector<Vec3>& points, const Pen& pen) {
    std::vector<Vec2> line;
    for (const Vec3& p : points) line.push_back(seen(p));
    sketch_.curve(line, pen);
  }

  void arrow(const Vec3& from, const Vec3& to, const Pen& pen) {
    sketch_.arrow(seen(from), seen(to), pen);
  }

  void dot(const Vec3& point, const std::string& colour, double pixels = 4) {
    sketch_.dot(seen(point), colour, pixels);
  }

  /// @param offset [px] right and down of the point
  void words(const Vec3& point, const Vec2& offset, const std::string& text,
             const std::string& colour = "ink", const std::string& anchor = "middle") {
    sketch_.words(seen(point), offset, text, colour, anchor);
  }

  /// The name of an arrow, beyond its tip.
  void name_at_tip(const Vec3& from, const Vec3& to, const std::string& name,
                   const std::string& colour = "ink") {
    sketch_.name_at_tip(seen(from), seen(to), name, colour);
  }

  /// Three arrows from a point, the columns of a matrix, with names at their tips.
  void axes(const Vec3& origin, const Mat3& columns, const std::array<std::string, 3>& names,
            const std::array<Pen, 3>& pens) {
    const auto tip_of = [&](std::size_t i) -> Vec3 {
      return origin + columns.col(static_cast<Eigen::Index>(i));
    };
    for (std::size_t i = 0; i < 3; ++i) arrow(origin, tip_of(i), pens[i]);
    for (std::size_t i = 0; i < 3; ++i) name_at_tip(origin, tip_of(i), names[i], pens[i].colour);
  }

  /// The world's axes, in ink.
  void world_axes(const Vec3& origin, double length) {
    const Pen pen{"ink", 1.5};
    axes(origin, length * Mat3::Identity(), {"x", "y", "z"}, {pen, pen, pen});
  }

 private:
  Sketch& sketch_;
  Mat3 view_;
};

/// A circle about a point, from `start` on, counter-clockwise about `axis`.
/// @param start from the centre to the circle; perpendicular to `axis`, which has length 1
inline std::vector<Vec3> arc(const Vec3& centre, const Vec3& start, const Vec3& axis,
                             double angle) {
  constexpr int parts = 60;
  std::vector<Vec3> points;
  for (int i = 0; i <= parts; ++i) {
    const double at = angle * i / parts;
    points.emplace_back(centre + std::cos(at) * start + std::sin(at) * axis.cross(start));
  }
  return points;
}

}  // namespace tumble::support
