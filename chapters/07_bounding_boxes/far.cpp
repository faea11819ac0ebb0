/// @file
/// Boxes far from the origin of the world, by sums about it and by differences.

#include "common.hpp"
#include "parts.hpp"
#include "support/plot.hpp"

namespace bounding_boxes_chapter {

namespace {

/// A racket askew, its points on a grid of 2⁻²⁰ m: they can be moved by 2³⁰ m without being
/// rounded.
Points racket_on_grid() {
  Points points = turned(racket().points(), exp_rotation(Vec3(0.4, -0.3, 0.6)));
  for (Vec3& p : points) p = (p * 0x1p20).array().round() * 0x1p-20;
  return points;
}

/// The box along the axes of the scatter, which is found as a difference of two sums.
boxes::OrientedBox box_by_the_origin(const Points& points) {
  const double n = static_cast<double>(points.size());
  Vec3 mean = Vec3::Zero();
  Mat3 about_origin = Mat3::Zero();
  for (const Vec3& p : points) {
    mean += p / n;
    about_origin += p * p.transpose();
  }
  return boxes::box_around(points, principal_axes(about_origin - n * mean * mean.transpose()).R);
}

/// About a corner of the box, by way of the origin of the world and directly.
Mat3 inertia_by_the_origin(const boxes::OrientedBox& box, const Vec3& about) {
  const MassProperties body = boxes::box_mass_properties(box, 1);
  const Mat3 about_origin = inertia_about(body, Vec3::Zero());
  return inertia_about_centre(about_origin, 1, box.centre) + point_inertia(1, box.centre - about);
}

}  // namespace

std::string far_figure() {
  support::Plot plot{"a racket's box",
                     {"distance from the origin [m]", support::Scale::log},
                     {"relative error", support::Scale::log},
                     {}};
  const Points here = racket_on_grid();
  const boxes::OrientedBox truth = boxes::principal_box(here);
  const auto add = [&](const std::string& name, auto&& error) {
    support::Series series{name, {}, {}};
    for (int k = 0; k <= 28; k += 2) {
      const Vec3 shift(std::ldexp(1.0, k), 0, 0);
      series.x.push_back(shift.x());
      series.y.push_back(std::max(error(shift), 1e-17));
    }
    plot.series.push_back(series);
  };
  const auto moved = [&here](const Vec3& shift) {
    Points points = here;
    for (Vec3& p : points) p += shift;
    return points;
  };
  const auto box_error = [&](const boxes::OrientedBox& box) {
    return std::abs(box.volume() / truth.volume() - 1);
  };
  const Vec3 about(0.25, 0.5, -0.125);  // from the origin, moved along with the box
  const Mat3 I =
      inertia_about(boxes::box_mass_properties({Vec3::Zero(), truth.R, truth.size}, 1), about);
  const auto inertia_off = [&](auto&& find, const Vec3& shift) {
    return inertia_error(find(boxes::OrientedBox{shift, truth.R, truth.size}, shift + about), I);
  };
  add("scatter, by the origin",
      [&](const Vec3& s) { return box_error(box_by_the_origin(moved(s))); });
  add("inertia, by the origin",
      [&](const Vec3& s) { return inertia_off(inertia_by_the_origin, s); });
  add("scatter, differences",
      [&](const Vec3& s) { return box_error(boxes::principal_box(moved(s))); });
  add("inertia, differences", [&](const Vec3& s) {
    return inertia_off(
        [](const boxes::OrientedBox& box, const Vec3& p) {
          return inertia_about(boxes::box_mass_properties(box, 1), p);
        },
        s);
  });
  return support::to_svg(plot);
}

}  // namespace bounding_boxes_chapter
