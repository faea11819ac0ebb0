#pragma once
/// @file
/// How deep the origin lies in a difference: its nearest face, found by letting a tetrahedron in it
/// grow there.
///
/// Source: van den Bergen, "Proximity queries and penetration depth computation on 3D game
/// objects", GDC 2001 (the expanding polytope).

#include <limits>
#include <vector>

#include "tumble/collide/nearest_in_simplex.hpp"

namespace tumble::collide::detail {

/// The nearest face of a difference.
struct Penetration {
  Vec3 outwards;     ///< unit normal, out of the difference
  double depth;      ///< of the plane with this normal that holds all of the difference [m]
  double uncertain;  ///< by how much the true depth may be less [m]
  int rounds;        ///< how often it grew
};

/// A polytope around the origin, inside of the difference.
class Polytope {
 public:
  /// @param inside corners around the origin: one to four
  Polytope(const Difference& difference, Simplex inside)
      : difference_(difference), rounding_(rounding_of(difference)) {
    while (inside.size < 4) inside.add(farthest_from(inside));
    for (const Corner& corner : inside.corners) corners_.push_back(corner);
    const Vec3 middle = (inside.w(0) + inside.w(1) + inside.w(2) + inside.w(3)) / 4;
    for (const auto& [a, b, c] :
         {Triple{0, 1, 2}, Triple{0, 3, 1}, Triple{0, 2, 3}, Triple{1, 3, 2}}) {
      const bool inwards = (w(b) - w(a)).cross(w(c) - w(a)).dot(w(a) - middle) < 0;
      inwards ? add_face(a, c, b) : add_face(a, b, c);
    }
  }

  Penetration grow() {
    constexpr int max_rounds = 500;
    Penetration best{Vec3::UnitZ(), std::numeric_limits<double>::infinity(), 0, 0};
    for (int round = 1; round <= max_rounds; ++round) {
      const Face nearest = faces_[nearest_face()];
      const Corner next = difference_.nearest_along(-nearest.normal);
      const double depth = nearest.normal.dot(next.w);
      if (depth < best.depth) {
        best.outwards = nearest.normal;
        best.depth = depth;
      }
      best.uncertain = std::max(0., best.depth - nearest.distance);
      best.rounds = round;
      if (best.uncertain <= rounding_ || !add(next)) break;
    }
    return best;
  }

  /// Where the plane of a penetration touches the difference: a part of a face, with the weights of
  /// the point that is nearest to the origin. Faces on the other side may be as near, as where the
  /// bodies have one centre; and several triangles share a plane.
  Simplex touched_by(const Penetration& plane) const {
    const Vec3 foot = plane.depth * plane.outwards;
    Simplex best;
    for (const Face& face : faces_) {
      Simplex all;
      for (const int i : face.corners) all.add(corners_[static_cast<std::size_t>(i)]);
      const Simplex part = nearest_in(all, rounding_);
      if (best.size == 0 || (part.point() - foot).norm() < (best.point() - foot).norm())
        best = part;
    }
    return best;
  }

 private:
  using Triple = std::array<int, 3>;
  struct Face {
    Triple corners;
    Vec3 normal;      ///< outwards
    double distance;  ///< of its plane from the origin, along the normal
  };
  static constexpr std::array<std::array<int, 2>, 3> sides{{{0, 1}, {1, 2}, {2, 0}}};

  const Vec3& w(int i) const { return corners_[static_cast<std::size_t>(i)].w; }

  /// The corner that lies farthest outside of the point, line or plane through the simplex.
  Corner farthest_from(const Simplex& simplex) const {
    const auto off = [&](const Vec3& w) -> double {
      const Vec3 d = w - simplex.w(0);
      if (simplex.size == 1) return d.norm();
      const Vec3 edge = (simplex.w(1) - simplex.w(0)).normalized();
      if (simplex.size == 2) return d.cross(edge).norm();
      return std::abs(d.dot(edge.cross(simplex.w(2) - simplex.w(0))));
    };
    Corner best{};
    double most = -1;
    for (const Vec3& direction : directions_off(simplex)) {
      const Corner corner = difference_.nearest_along(direction);
      if (const double by = off(corner.w); by > most) {
        most = by;
        best = corner;
      }
    }
    return best;
  }

  static std::vector<Vec3> directions_off(const Simplex& simplex) {
    Mat3 axes = Mat3::Identity();
    if (simplex.size == 2) {
      const Vec3 edge = (simplex.w(1) - simplex.w(0)).normalized();
      const Vec3 side = edge.unitOrthogonal(), other = edge.cross(side);
      axes << side, other, (side + other).normalized();
    } else if (simplex.size == 3) {
      const Vec3 normal =
          (simplex.w(1) - simplex.w(0)).cross(simplex.w(2) - simplex.w(0)).normalized();
      axes << normal, normal, normal;
    }
    std::vector<Vec3> directions;
    for (int k = 0; k < 3; ++k)
      for (const double sign : {1., -1.}) directions.emplace_back(sign * axes.col(k));
    return directions;
  }

  void add_face(int a, int b, int c) {
    const Vec3 normal = (w(b) - w(a)).cross(w(c) - w(a));
    const double size = normal.norm();
    // A face without area is never the nearest one.
    if (size == 0)
      faces_.push_back({{a, b, c}, Vec3::Zero(), std::numeric_limits<double>::infinity()});
    else
      faces_.push_back({{a, b, c}, normal / size, normal.dot(w(a)) / size});
  }

  std::size_t nearest_face() const {
    std::size_t best = 0;
    for (std::size_t i = 1; i < faces_.size(); ++i)
      if (faces_[i].distance < faces_[best].distance) best = i;
    return best;
  }

  /// Grows to a new corner: the faces that it sees give way to those between it and their border.
  /// @return whether that changed anything
  bool add(const Corner& corner) {
    for (const Corner& known : corners_)
      if (known == corner) return false;
    std::vector<std::array<int, 2>> border;
    std::vector<Face> kept;
    for (const Face& face : faces_) {
      // In the plane of a face it does not see it: whether it would, only rounding says, and faces
      // may turn over.
      const bool seen = face.normal.dot(corner.w) > face.distance + rounding_;
      if (!seen) kept.push_back(face);
      for (const auto& side : sides)
        if (seen)
          toggle(border, {face.corners[static_cast<std::size_t>(side[0])],
                          face.corners[static_cast<std::size_t>(side[1])]});
    }
    if (kept.empty() || border.empty()) return false;
    faces_ = std::move(kept);
    corners_.push_back(corner);
    for (const auto& [from, to] : border) add_face(from, to, static_cast<int>(corners_.size()) - 1);
    return true;
  }

  /// A side that two seen faces share is no border.
  static void toggle(std::vector<std::array<int, 2>>& border, const std::array<int, 2>& side) {
    const auto twin = std::find(border.begin(), border.end(), std::array{side[1], side[0]});
    if (twin == border.end())
      border.push_back(side);
    else
      border.erase(twin);
  }

  const Difference& difference_;
  double rounding_;
  std::vector<Corner> corners_;
  std::vector<Face> faces_;
};

}  // namespace tumble::collide::detail
