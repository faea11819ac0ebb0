#pragma once
/// @file
/// A racket for a figure: points, lines and exact mass properties, without what checks a mesh.

#include "askew_box.hpp"
#include "objects/objects.hpp"
#include "objects/racket_lines.hpp"
#include "tumble/mass/mirtich/volume_integrals.hpp"
#include "tumble/mesh/reference_point.hpp"

namespace bounding_boxes_chapter {

/// The racket about its centre of mass.
struct Racket {
  Points points;
  MassProperties truth;
  PrincipalAxes axes;
  objects::RacketLines lines;
};

inline const Racket& racket_itself() {
  static const Racket made = [] {
    PolygonMesh mesh = objects::tennis_racket(1);
    const Vec3 middle = tumble::detail::reference_point(mesh);
    const MassProperties truth =
        mass_properties(mirtich::volume_integrals(mesh, middle), middle, objects::ash_wood);
    objects::RacketLines lines = objects::racket_lines();
    for (auto* part : {&lines.frame, &lines.strings, &lines.throat, &lines.handle})
      for (std::vector<Vec3>& line : *part)
        for (Vec3& p : line) p -= truth.centre;
    for (Vec3& p : mesh.vertices) p -= truth.centre;
    return Racket{mesh.vertices, truth, principal_axes(truth.inertia), lines};
  }();
  return made;
}

}  // namespace bounding_boxes_chapter
