#pragma once
/// @file
/// Do two triangles meet? Exactly.
///
/// They do where an edge of one goes through the other, and that is a matter of signs: on which
/// side of a plane is a point, on which side of an edge does a line pass. Source: Shewchuk,
/// "Adaptive precision floating-point arithmetic and fast robust geometric predicates", Discrete
/// Comput. Geom. 18 (1997), §4.4 (the bound); Möller & Trumbore, J. Graphics Tools 2(1), 1997, for
/// the edge and the triangle.

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "tumble/mesh/orientation.hpp"

namespace tumble::detail {

/// Adds sign · p · (q × r) to an exact sum.
template <std::size_t n>
void add_determinant(ExactSum<n>& sum, double sign, const Vec3& p, const Vec3& q, const Vec3& r) {
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    for (const auto& [y, z, s] : {std::tuple{j, k, sign}, std::tuple{k, j, -sign}}) {
      const double x = s * p[i], product = x * q[y], rest = std::fma(x, q[y], -product);
      sum.add_product(rest, r[z]);
      sum.add_product(product, r[z]);
    }
  }
}

/// Whether the difference of two points has no rounding; one that overflows has some (NaN).
bool has_exact_difference(const Vec3& p, const Vec3& q);

/// The exact sign of (a − d) · ((b − d) × (c − d)): from the differences where these are exact, as
/// between points that are near each other, else from the 24 products of the points themselves;
/// either by whole numbers, if those of an axis are not too far apart.
int exact_side_of_plane(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// On which side of the plane through a, b and c the point d is: the sign of (a − d) · ((b − d) ×
/// (c − d)), 0 when on it.
int side_of_plane(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

using Triangle = std::array<Vec3, 3>;

/// How an edge and a triangle lie to each other.
enum class Meeting { apart, touching, through };

/// Whether the edge from p to q meets a triangle: inside both, or where one of them ends.
Meeting edge_meets(const Vec3& p, const Vec3& q, const Triangle& t);

/// How two triangles lie to each other that have one corner in common: their edges opposite
/// to it count.
Meeting triangles_meet_beside(const Triangle& s, const Triangle& t);

/// How two triangles lie to each other: the closest that an edge of one comes to the other. Where
/// they are in one plane, or only touch, they may.
Meeting triangles_meet(const Triangle& s, const Triangle& t);

/// Where two triangles pass through each other, and how far.
struct TriangleCrossing {
  Vec3 place;        ///< the mean of where edges go through [m]
  double depth;      ///< how far you move one of them to part them, at most [m]
  double reach = 0;  ///< how far from `place` edges go through [m]
};

/// How far an edge goes through the plane of a triangle: how far the nearer end is from it [m].
inline double depth_of_edge(const Vec3& p, const Vec3& q, const Triangle& t) {
  const Vec3 n = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
  return std::min(std::abs(n.dot(p - t[0])), std::abs(n.dot(q - t[0])));
}

/// How far two triangles have to be moved at least to part them [m]: along the normal of one of
/// them, or across an edge of each. Source: Gottschalk, Lin & Manocha, "OBBTree", SIGGRAPH (1996)
/// (separating axes).
double parting_distance(const Triangle& s, const Triangle& t);

/// Measures two triangles that pass through each other, in doubles.
TriangleCrossing measure_crossing(const Triangle& s, const Triangle& t);

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/mesh/triangles_meet.inl"
#endif
