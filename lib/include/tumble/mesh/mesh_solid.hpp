#pragma once
/// @file
/// The inside of a closed mesh: a point is inside when the surface winds round it.
///
/// winding(p) = Σ ±1 over the triangles above p, + where the line going up leaves. The line's
/// candidates come from a grid of cells over the xy plane; a line through an edge or a vertex is
/// counted exactly once (orientation.hpp). Source: Haines, "Point in polygon strategies", Graphics
/// Gems IV (1994), one dimension up; the pitfall is the ray that meets an edge.

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "tumble/core/require.hpp"
#include "tumble/core/solid.hpp"
#include "tumble/mesh/check_faces.hpp"
#include "tumble/mesh/edge_balance.hpp"
#include "tumble/mesh/orientation.hpp"
#include "tumble/mesh/xy_grid.hpp"

namespace tumble {

/// The triangles of a mesh, sorted into the cells of a grid over the xy plane.
class VerticalBins {
 public:
  explicit VerticalBins(const PolygonMesh& mesh)
      : triangles_(list_triangles(mesh)),
        grid_(tumble::bounds(mesh), 1 + 2.0 * static_cast<double>(triangles_.size())),
        bins_(grid_, static_cast<int>(triangles_.size()),
              [&](int i) { return range(mesh, triangle(i)); }) {}

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
  CellRange range(const PolygonMesh& mesh, const std::array<int, 3>& t) const {
    const Rectangle r = rectangle_of(mesh.vertex(t[0]), mesh.vertex(t[1]), mesh.vertex(t[2]));
    return {grid_.column(r.x0), grid_.column(r.x1), grid_.row(r.y0), grid_.row(r.y1)};
  }

  std::vector<std::array<int, 3>> triangles_;
  XyGrid grid_;
  XyBins bins_;
};

/// The body inside a closed mesh, a Solid. Where parts overlap it is their union; parts that are
/// inside out count like others; diagnose() tells of both.
class MeshSolid {
 public:
  /// @throws std::invalid_argument for a mesh with an index out of range, a position that is not
  ///         finite, or an open edge: require_body() names them
  explicit MeshSolid(PolygonMesh mesh)
      : mesh_(checked(std::move(mesh))), bounds_(tumble::bounds(mesh_)), bins_(mesh_) {}

  /// Whether a point [m] is inside. On the surface itself either answer may come.
  bool contains(const Vec3& point) const { return bounds_.contains(point) && winding(point) != 0; }

  /// How often the surface winds round a point: 1 inside a body, 0 outside.
  int winding(const Vec3& p) const {
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
  static PolygonMesh checked(PolygonMesh mesh) {
    for (const auto& find : {find_bad_indices, find_not_finite})
      for (const Finding& finding : find(mesh)) require(false, finding.message);
    require(mesh.face_count() > 0, "the mesh has no faces");
    require(is_closed(mesh), "the mesh is not closed: diagnose() says where");
    return mesh;
  }

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

static_assert(Solid<MeshSolid>);

}  // namespace tumble
