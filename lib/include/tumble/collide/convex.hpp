#pragma once
/// @file
/// Convex bodies, told by the farthest point in each direction: balls, boxes, hulls of points, and
/// half spaces for floors and walls.
///
/// A body that is not convex is taken for its hull: a cup collides as if it were filled.

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "tumble/collide/bounds.hpp"
#include "tumble/core/require.hpp"
#include "tumble/mesh/polygon_mesh.hpp"

namespace tumble::collide {

/// @addtogroup collide
/// @{

/// Where a body is and how it is turned.
struct Pose {
  Vec3 x = Vec3::Zero();      ///< its centre of mass, the origin of body coordinates [m]
  Mat3 R = Mat3::Identity();  ///< body → world
};

/// A convex body: the hull of some points, and all that is no farther than `radius` from it.
class Convex {
 public:
  /// A ball around the centre of mass.
  /// @throws std::invalid_argument if the radius [m] is not positive and finite
  static Convex ball(double radius) {
    require(radius > 0 && std::isfinite(radius), "convex body: the ball's radius ", radius,
            " m is not positive and finite");
    return {{Vec3::Zero()}, radius};
  }

  /// A box of full edge lengths `size` [m], in body coordinates.
  /// @throws std::invalid_argument if an edge is not positive and finite, or R no rotation
  static Convex box(const Vec3& size, const Vec3& centre = Vec3::Zero(),
                    const Mat3& R = Mat3::Identity()) {
    require(size.allFinite() && size.minCoeff() > 0, "convex body: the box's edges (",
            size.transpose(), ") m are not positive and finite");
    require(centre.allFinite() && R.allFinite(), "convex body: the box's place is not finite");
    require(
        (R.transpose() * R).isIdentity(1e-6),
        "convex body: the box's R is no rotation: its columns are not perpendicular unit vectors");
    std::vector<Vec3> corners;
    for (int i = 0; i < 8; ++i) {
      const Vec3 signs(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
      corners.emplace_back(centre + R * Vec3(signs.cwiseProduct(size) / 2));
    }
    Convex made(std::move(corners), 0);
    made.edges_ = {R.col(0), R.col(1), R.col(2)};
    return made;
  }

  /// The hull of points in body coordinates [m].
  /// @throws std::invalid_argument if it has no volume, or a point is not finite
  static Convex hull(std::span<const Vec3> points) {
    for (std::size_t i = 0; i < points.size(); ++i)
      require(points[i].allFinite(), "convex body: point ", i, " is not finite");
    Convex made({points.begin(), points.end()}, 0);
    require(made.has_volume(), "convex body: the hull of ", points.size(), " points has no volume");
    return made;
  }

  /// The hull of a mesh's vertices. If the mesh is not convex, the hull is larger than the body.
  /// @param centre of mass, in the mesh's coordinates: the origin of body coordinates
  /// @throws std::invalid_argument as the hull of points does
  static Convex hull(const PolygonMesh& mesh, const Vec3& centre = Vec3::Zero()) {
    std::vector<Vec3> points = mesh.vertices;
    for (Vec3& point : points) point -= centre;
    return hull(points);
  }

  const std::vector<Vec3>& points() const { return points_; }  ///< body coordinates [m]
  /// The directions of a box's edges, which are those of its faces, too; of other bodies none.
  const std::vector<Vec3>& box_edges() const { return edges_; }
  double radius() const { return radius_; }  ///< around the hull of the points [m]
  double reach() const { return reach_; }    ///< of the ball around the centre that holds it [m]

  /// The number of the point that is farthest along a direction in body coordinates.
  int farthest(const Vec3& direction) const {
    int best = 0;
    double most = points_[0].dot(direction);
    for (int i = 1; i < static_cast<int>(points_.size()); ++i) {
      const double along = point(i).dot(direction);
      if (along > most) {
        most = along;
        best = i;
      }
    }
    return best;
  }
  const Vec3& point(int i) const { return points_[static_cast<std::size_t>(i)]; }

 private:
  Convex(std::vector<Vec3> points, double radius) : points_(std::move(points)), radius_(radius) {
    for (const Vec3& p : points_) reach_ = std::max(reach_, p.norm() + radius);
  }

  /// Whether four points span a tetrahedron that rounding cannot have made.
  bool has_volume() const {
    if (points_.size() < 4) return false;
    const auto farthest_by = [&](const auto& measure) {
      return *std::max_element(points_.begin(), points_.end(), [&](const Vec3& p, const Vec3& q) {
        return measure(p) < measure(q);
      });
    };
    const Vec3 a = points_[0];
    const Vec3 ab = farthest_by([&](const Vec3& p) { return (p - a).norm(); }) - a;
    const Vec3 ac = farthest_by([&](const Vec3& p) { return (p - a).cross(ab).norm(); }) - a;
    const Vec3 normal = ab.cross(ac);
    const Vec3 ad = farthest_by([&](const Vec3& p) { return std::abs((p - a).dot(normal)); }) - a;
    return std::abs(ad.dot(normal)) > 1e-14 * reach_ * normal.norm() && normal.norm() > 0;
  }

  std::vector<Vec3> points_, edges_;
  double radius_ = 0, reach_ = 0;
};

/// All that is below a plane, such as a floor: (p − point)·normal ≤ 0.
struct HalfSpace {
  Vec3 point = Vec3::Zero();    ///< on the plane [m]
  Vec3 normal = Vec3::UnitZ();  ///< out of the half space, length 1

  /// @throws std::invalid_argument if the normal has not the length 1, or a number is not finite
  void require_valid() const {
    require(point.allFinite(), "half space: its point is not finite");
    require(std::abs(normal.norm() - 1) < 1e-9, "half space: its normal (", normal.transpose(),
            ") does not have length 1");
  }
};

/// The bounds of a body that stands [m].
Bounds bounds_of(const Convex& body, const Pose& pose);

/// @}

}  // namespace tumble::collide

#ifndef TUMBLE_COMPILED
#include "tumble/collide/convex.inl"
#endif
