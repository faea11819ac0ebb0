#pragma once
/// @file
/// A paper plane, drawn in any orientation.

#include "mixtures.hpp"
#include "support/sketch.hpp"
#include "support/view.hpp"

namespace quaternions_chapter {

/// Nose along x, left wing along y, both sides of the paper.
inline PolygonMesh paper_plane() {
  PolygonMesh mesh;
  mesh.vertices = {{0.6, 0, 0.01},       {-0.45, 0.42, 0.1},   {-0.45, 0.04, 0.02},
                   {-0.45, -0.42, 0.1},  {-0.45, -0.04, 0.02}, {-0.45, 0, -0.22},
                   {-0.42, 0.04, 0.019}, {-0.42, -0.04, 0.019}};
  const auto add_sheet = [&](int a, int b, int c) {
    mesh.add_face({a, b, c});
    mesh.add_face({a, c, b});
  };
  add_sheet(0, 1, 2);
  add_sheet(0, 4, 3);
  add_sheet(0, 2, 5);
  add_sheet(0, 5, 4);
  return mesh;
}

/// From the viewer's side: the world's x to the right, z up, seen from a little above.
inline const Mat3 viewer = axis_rotation(0, -65 * degree) * axis_rotation(2, -20 * degree);

/// Drawings of the plane go in before the figure's end.
inline std::string with_planes(const support::Sketch& sketch, const std::string& planes) {
  std::string svg = sketch.svg();
  return svg.insert(svg.rfind("</svg>"), planes);
}

}  // namespace quaternions_chapter
