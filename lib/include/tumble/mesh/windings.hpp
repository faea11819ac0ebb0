#pragma once
/// @file
/// How often the surface of a mesh winds round a point; whether the mesh is closed is not checked.
///
/// winding(p) = Σ ±1 over the triangles above p, + where the line going up leaves. The line's
/// candidates come from a grid of cells over the xy plane; a line through an edge or a vertex is
/// counted exactly once (orientation.hpp). Source: Haines, "Point in polygon strategies", Graphics
/// Gems IV (1994), one dimension up; the pitfall is the ray that meets an edge.

#include <algorithm>
#include <array>
#include <limits>
#include <utility>
#include <vector>

#include "tumble/mesh/orientation.hpp"
#include "tumble/mesh/polygon_mesh.hpp"
#include "tumble/mesh/xy_grid.hpp"

namespace tumble::detail {

/// The triangles of a mesh, sorted into the cells of a grid over the xy plane.
class VerticalBins {
 public:
  explicit VerticalBins(const PolygonMesh& mesh)
      : triangles_(list_triangles(mesh)),
        grid_(tumble::bounds(mesh), 1 + 2.0 * static_cast<double>(triangles_.size())),
        bins_(grid_, static_cast<int>(triangles_.size()),
              [&](int i) { return range(mesh, triangle(i)); }) {
    heights_.reserve(static_cast<std::size_t>(grid_.nx()) * static_cast<std::size_t>(grid_.ny()));
    for (int row = 0; row < grid_.ny(); ++row)
      for (int column = 0; column < grid_.nx(); ++column)
        heights_.push_back(heights(mesh, bins_.items(column, row)));
  }

  /// Whether a point is below or above all candidates of the vertical line through it.
  bool is_beyond(const Vec3& p) const {
    const Heights& h =
        heights_[static_cast<std::size_t>(grid_.row(p.y())) * static_cast<std::size_t>(grid_.nx()) +
                 static_cast<std::size_t>(grid_.column(p.x()))];
    return p.z() < h.low || p.z() > h.high;
  }

  /// Calls `visit(triangle)` for each triangle whose cells the vertical line through (x, y) meets.
  template <class Visit>
  void for_each_candidate(double x, double y, Visit&& visit) const {
    for (const int i : bins_.items(grid_.column(x), grid_.row(y))) visit(triangle(i));
  }

 private:
  static std::vector<std::array<int, 3>> list_triangles(const PolygonMesh& mesh) {
    std::vector<std::array<int, 3>> list;
    list.reserve(mesh.corners.size());
    for_each_triangle(mesh, [&](int, const std::array<int, 3>& t) { list.push_back(t); });
    return list;
  }
  const std::array<int, 3>& triangle(int i) const {
    return triangles_[static_cast<std::size_t>(i)];
  }
  /// From the lowest to the highest corner of some triangles.
  struct Heights {
    double low = std::numeric_limits<double>::infinity(), high = -low;
  };
  Heights heights(const PolygonMesh& mesh, std::span<const int> items) const {
    Heights h;
    for (const int i : items)
      for (const int v : triangle(i))
        h = {std::min(h.low, mesh.vertex(v).z()), std::max(h.high, mesh.vertex(v).z())};
    return h;
  }
  CellRange range(const PolygonMesh& mesh, const std::array<int, 3>& t) const {
    const Rectangle r = rectangle_of(mesh.vertex(t[0]), mesh.vertex(t[1]), mesh.vertex(t[2]));
    return {grid_.column(r.x0), grid_.column(r.x1), grid_.row(r.y0), grid_.row(r.y1)};
  }

  std::vector<std::array<int, 3>> triangles_;
  XyGrid grid_;
  XyBins bins_;
  std::vector<Heights> heights_;
};

/// A mesh with its triangles in cells. Made once, asked for many points.
class Windings {
 public:
  explicit Windings(PolygonMesh mesh)
      : mesh_(std::move(mesh)), bounds_(tumble::bounds(mesh_)), bins_(mesh_) {}

  /// Whether a point [m] is inside. On the surface itself either answer may come.
  bool contains(const Vec3& point) const { return bounds_.contains(point) && around(point) != 0; }

  /// How often the surface winds round a point: 1 inside a body, 0 outside.
  int around(const Vec3& p) const {
    if (bins_.is_beyond(p)) return 0;  // above p as many leave as enter, or there are none
    int sum = 0;
    bins_.for_each_candidate(p.x(), p.y(), [&](const std::array<int, 3>& t) {
      const Vec3 &a = mesh_.vertex(t[0]), &b = mesh_.vertex(t[1]), &c = mesh_.vertex(t[2]);
      if (a.z() < p.z() && b.z() < p.z() && c.z() < p.z()) return;
      const int crossing = line_crossing(a, b, c, p.x(), p.y());
      if (crossing != 0 && crossing * height_above(a, b, c, p) > 0) sum += crossing;
    });
    return sum;
  }

  const Eigen::AlignedBox3d& bounds() const { return bounds_; }
  const PolygonMesh& mesh() const { return mesh_; }

 private:
  /// 6 × the volume of the tetrahedron p, a, b, c: positive when p is below a triangle that is seen
  /// counter-clockwise from above.
  static double height_above(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
    const Vec3 u = a - p, v = b - p, w = c - p;
    return u.dot(v.cross(w));
  }

  PolygonMesh mesh_;
  Eigen::AlignedBox3d bounds_;
  VerticalBins bins_;
};

}  // namespace tumble::detail
