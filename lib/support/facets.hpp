#pragma once
/// @file
/// A picture of a mesh of few, large faces: each is one polygon, as it was given.

#include "support/view.hpp"

namespace tumble::support {

/// How bright a face is: 0 darkest … 15 lightest.
/// @param normal of the face, in the viewer's axes
inline int shade_of(const Vec3& normal) {
  const Vec3 light = Vec3(-0.4, 0.55, 0.73).normalized();
  return static_cast<int>(15 * std::max(0.0, normal.normalized().dot(light)));
}

/// A face in one colour.
/// @param path of its corners, as SVG wants it
/// @param dark the shade of what the light does not reach
inline std::string draw_facet(const std::string& path, int shade, int dark) {
  const std::string colour = view_detail::shade_colour(dark + shade * (15 - dark) / 15);
  return "<path fill=\"" + colour + "\" stroke=\"" + colour + "\" stroke-width=\"0.6\" d=\"" +
         path + "\"/>\n";
}

namespace facets_detail {

inline view_detail::PaintedFace painted(const PolygonMesh& mesh, int f, const Mat3& R,
                                        const Placement& at) {
  Vec3 normal = Vec3::Zero();  // twice the area, by Newell's sum over the edges
  double depth = 0;
  SvgPath path;
  const std::span<const int> face = mesh.face(f);
  for (std::size_t k = 0; k < face.size(); ++k) {
    const Vec3 a = R * mesh.vertex(face[k]), b = R * mesh.vertex(face[(k + 1) % face.size()]);
    normal += a.cross(b);
    depth += a.z() / static_cast<double>(face.size());
    path.add(at.x + at.scale * a.x(), at.y - at.scale * a.y(), k == 0);
  }
  return {depth, normal.z() > 0 ? shade_of(normal) : -1, path.text() + "Z"};
}

/// The faces that look towards the viewer, far ones first.
inline std::vector<view_detail::PaintedFace> painted_facets(const PolygonMesh& mesh, const Mat3& R,
                                                            const Placement& at) {
  std::vector<view_detail::PaintedFace> faces;
  for (int f = 0; f < mesh.face_count(); ++f) {
    faces.push_back(painted(mesh, f, R, at));
    if (faces.back().shade < 0) faces.pop_back();
  }
  std::stable_sort(faces.begin(), faces.end(),
                   [](const auto& a, const auto& b) { return a.depth < b.depth; });
  return faces;
}

}  // namespace facets_detail

/// The mesh as SVG paths, seen along −z with y up; far faces first, those turned away not at all.
/// @param R    turns the mesh's coordinates into the viewer's
/// @param dark the shade of what the light does not reach: 0 is darkest, 15 leaves no shadows
inline std::string draw_facets(const PolygonMesh& mesh, const Mat3& R, const Placement& at,
                               int dark = 0) {
  std::string svg;
  for (const view_detail::PaintedFace& face : facets_detail::painted_facets(mesh, R, at))
    svg += draw_facet(face.path, face.shade, dark);
  return svg;
}

/// The same without deep shadows and a little transparent: a ground for arrows.
inline std::string draw_pale_facets(const PolygonMesh& mesh, const Mat3& R, const Placement& at) {
  constexpr int dark = 7;
  return "<g opacity=\"0.75\">\n" + draw_facets(mesh, R, at, dark) + "</g>\n";
}

}  // namespace tumble::support
