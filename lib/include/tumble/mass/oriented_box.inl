#pragma once

#include "tumble/mass/oriented_box.hpp"

#include <cmath>

#include "tumble/core/compiled.hpp"
#include "tumble/mass/as_point.hpp"
#include "tumble/mass/transform.hpp"

namespace tumble::boxes {

TUMBLE_BODY OrientedBox box_around(std::span<const Vec3> points, const Mat3& R) {
  require(!points.empty(), "there are no points to put a box around");
  Eigen::AlignedBox3d box;
  for (std::size_t i = 0; i < points.size(); ++i) {
    require(points[i].allFinite(), "point ", i, " at ", detail::AsPoint{points[i]},
            " is not finite");
    box.extend(Vec3(R.transpose() * points[i]));
  }
  return {R * box.center(), R, box.sizes()};
}

TUMBLE_BODY MassProperties box_mass_properties(const OrientedBox& box, double mass) {
  detail::require_positive(mass, "the mass");
  MassProperties body = mass_properties(Box{box.size}, 1);
  body.inertia *= mass / body.mass;
  body.mass = mass;
  return translated(rotated(body, box.R), box.centre);
}

TUMBLE_BODY OrientedBox shrunk_to(const OrientedBox& box, double volume) {
  detail::require_positive(volume, "the volume");
  detail::require_positive(box.volume(), "the box's volume");
  return {box.centre, box.R, box.size * std::cbrt(volume / box.volume())};
}

}  // namespace tumble::boxes
