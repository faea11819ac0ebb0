#pragma once
/// @file
/// A picture of a mesh: flat-shaded, without perspective, far faces painted first.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "support/svg.hpp"
#include "support/svg_path.hpp"
#include "tumble/mesh/polygon_mesh.hpp"

namespace tumble::support {

/// Where in the figure a body is and how large it is drawn.
struct Placement {
  double x, y;   ///< where the body's origin is drawn [px]
  double scale;  ///< [px/m]
};

namespace view_detail {

struct PaintedFace {
  double depth;
  int shade;  // 0 darkest … 15 lightest
  std::string path;
};

/// Faces turned away are not drawn; light comes from above the viewer's left shoulder.
inline std::vector<PaintedFace> painted_faces(const PolygonMesh& mesh, const Mat3& R,
                                              const Placement& at) {
  const Vec3 light = Vec3(-0.4, 0.55, 0.73).normalized();
  std::vector<PaintedFace> faces;
  for_each_triangle(mesh, [&](int, const std::array<int, 3>& corners) {
    const Vec3 a = R * mesh.vertex(corners[0]), b = R * mesh.vertex(corners[1]),
               c = R * mesh.vertex(corners[2]);
    const Vec3 normal = (b - a).cross(c - a);
    if (normal.z() <= 0) return;
    const double lambert = std::max(0.0, normal.normalized().dot(light));
    SvgPath path;
    for (const Vec3& p : {a, b, c})
      path.add(at.x + at.scale * p.x(), at.y - at.scale * p.y(), path.text().empty());
    faces.push_back({(a + b + c).z(), static_cast<int>(15 * lambert), path.text() + "Z"});
  });
  std::stable_sort(faces.begin(), faces.end(),
                   [](const PaintedFace& a, const PaintedFace& b) { return a.depth < b.depth; });
  return faces;
}

/// Steel blue, from shadow to light; readable on white and on black.
inline std::string shade_colour(int shade) {
  const double s = 0.42 + 0.58 * shade / 15;
  const auto channel = [&](double full) { return std::to_string(std::lround(full * s)); };
  return "rgb(" + channel(168) + "," + channel(194) + "," + channel(222) + ")";
}

}  // namespace view_detail

/// The mesh as SVG paths, seen along −z with y up.
/// @param R turns the mesh's coordinates into the viewer's
inline std::string draw_mesh(const PolygonMesh& mesh, const Mat3& R, const Placement& at) {
  using namespace view_detail;
  std::string svg;
  int shade = -1;
  for (const PaintedFace& face : painted_faces(mesh, R, at)) {
    if (face.shade != shade) {
      if (shade >= 0) svg += "\"/>\n";
      const std::string colour = shade_colour(face.shade);
      svg += "<path fill=\"" + colour + "\" stroke=\"" + colour + "\" stroke-width=\"0.6\" d=\"";
      shade = face.shade;
    }
    svg += face.path;
  }
  return shade >= 0 ? svg + "\"/>\n" : svg;
}

/// A coarser mesh for drawing: vertices in the same cell of a grid become one, faces that vanish
/// go. It need not be closed; its mass properties mean nothing.
/// @param cells cells along the longest side of the bounding box
inline PolygonMesh coarsened(const PolygonMesh& mesh, int cells) {
  const Eigen::AlignedBox3d box = bounds(mesh);
  const double cell = box.sizes().maxCoeff() / cells;
  std::map<std::array<std::int64_t, 3>, int> cell_vertex;
  std::vector<int> count, new_index;
  PolygonMesh coarse;
  for (const Vec3& v : mesh.vertices) {
    const Vec3 p = (v - box.min()) / cell;
    const auto [it, fresh] =
        cell_vertex.try_emplace({std::llround(p.x()), std::llround(p.y()), std::llround(p.z())},
                                static_cast<int>(coarse.vertices.size()));
    if (fresh) {
      coarse.vertices.push_back(Vec3::Zero());
      count.push_back(0);
    }
    const auto index = static_cast<std::size_t>(it->second);
    coarse.vertices[index] += v;
    ++count[index];
    new_index.push_back(it->second);
  }
  for (std::size_t i = 0; i < count.size(); ++i) coarse.vertices[i] /= count[i];
  for_each_triangle(mesh, [&](int, const std::array<int, 3>& corner) {
    const int a = new_index[static_cast<std::size_t>(corner[0])],
              b = new_index[static_cast<std::size_t>(corner[1])],
              c = new_index[static_cast<std::size_t>(corner[2])];
    if (a != b && b != c && c != a) coarse.add_face({a, b, c});
  });
  return coarse;
}

}  // namespace tumble::support
