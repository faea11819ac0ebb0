#pragma once
/// @file
/// Mass properties of a mesh by columns: vertical lines, each with the body's exact integral along
/// it.
///
/// ∫∫∫ f dz dx dy over the body is ∫∫ F(x, y, z) dx dy over its surface, F = ∫ f dz, + where z
/// leaves the body and − where it enters. Each triangle is drawn onto the lines that pass it and
/// adds ±F: nothing is sorted or kept, and no point is asked whether it is inside. That is the
/// midpoint rule (or a stratified one) for the surface integrals that Mirtich solves exactly.
///
/// Errors with N columns, measured over turned bodies: grid N^(−1) for curved outlines to N^(−3/2)
/// for polyhedra, jittered N^(−1). Where faces are vertical and parallel to x or y the grid's
/// columns are in or out by whole rows: N^(−1/2), unless the faces lie on borders of cells. Source:
/// the reduction is Mirtich's, "Fast and accurate computation of polyhedral mass properties", J.
/// Graphics Tools 1(2), 1996, §3, stopped before the last integral.

#include "tumble/mass/moments.hpp"
#include "tumble/mesh/line_height.hpp"
#include "tumble/mesh/orientation.hpp"
#include "tumble/mesh/polygon_mesh.hpp"

namespace tumble::sampling {

/// @addtogroup mass
/// @{

/// Mass properties and what they were made from.
struct ColumnMassProperties : MassProperties {
  std::int64_t columns = 0;    ///< vertical lines over the body's box
  std::int64_t crossings = 0;  ///< how often they met the surface
};

/// @}

}  // namespace tumble::sampling

namespace tumble::detail {

/// ∫ {1, x, y, z, …} dz from height 0 to z on the line through (x, y), times `sign`.
inline Moments<double> moments_below(double x, double y, double z, double sign) {
  const double length = sign * z;           // ∫ dz
  const double first = length * z / 2;      // ∫ z dz
  const double second = 2 * first * z / 3;  // ∫ z² dz
  return {length,         x * length, y * length,     first,     x * x * length,
          y * y * length, second,     x * y * length, y * first, x * first};
}

/// The box around a mesh when its middle is taken as the origin [m].
inline Eigen::AlignedBox3d centred(const Eigen::AlignedBox3d& box) {
  return {box.min() - box.center(), box.max() - box.center()};
}

/// Mass properties from where lines meet the surface; nothing is checked.
/// @param lines a LineLattice or JitteredLines over centred(bounds(mesh))
template <class Lines>
sampling::ColumnMassProperties sum_of_columns(const PolygonMesh& mesh, double density,
                                              const Lines& lines) {
  const Eigen::AlignedBox3d box = bounds(mesh);
  const Vec3 middle = box.center();
  BlockedMoments sum;
  std::int64_t crossings = 0;
  for_each_triangle(mesh, [&](int, const std::array<int, 3>& t) {
    const Vec3 a = mesh.vertex(t[0]) - middle, b = mesh.vertex(t[1]) - middle,
               c = mesh.vertex(t[2]) - middle;
    lines.for_each_in(rectangle_of(a, b, c), [&](int, const PlanePoint& line) {
      const int crossing = line_crossing(a, b, c, line.x(), line.y());
      if (crossing == 0) return;
      const double z = LineWeights(a, b, c, line).height(a, b, c);
      sum.add(moments_below(line.x(), line.y(), z, crossing));
      ++crossings;
    });
  });
  const double column_area = box.sizes().x() * box.sizes().y() / lines.size();
  return {mass_properties(sum.total(), middle, density * column_area), lines.size(), crossings};
}

/// Refuses what columns cannot be drawn through.
void require_columns(const PolygonMesh& mesh, double density, int columns);

/// Passes on what the surface confirms: columns miss a thin body, or meet all of it at once, and
/// nothing in their own numbers tells.
sampling::ColumnMassProperties require_resolved(const PolygonMesh& mesh, double density,
                                                const sampling::ColumnMassProperties& body);

}  // namespace tumble::detail

namespace tumble::sampling {

/// @addtogroup mass
/// @{

/// Mass properties of a mesh by columns in a regular grid, each in the middle of its cell.
/// @param mesh    closed, faces counter-clockwise seen from outside; parts that overlap count twice
///                [m]
/// @param density [kg/m³]
/// @param columns about how many, never more; 10⁵ give errors of about 10⁻⁵
/// @throws std::invalid_argument if the density is not positive and finite, columns ≤ 0 or beyond
///         10⁸, the mesh is as require_closed() refuses, is inside out, or so thin that the columns
///         are wrong by half its mass or more
ColumnMassProperties column_mass_properties(const PolygonMesh& mesh, double density, int columns);

/// The same by columns at random, one in each cell: right on average, and as sets of points are
/// (replicated_sampling.hpp) several with different seeds tell the error.
/// @param seed the same seed gives the same columns
ColumnMassProperties jittered_column_mass_properties(const PolygonMesh& mesh, double density,
                                                     int columns, std::uint64_t seed = 1);

/// @}

}  // namespace tumble::sampling

#ifndef TUMBLE_COMPILED
#include "tumble/mass/column_mass_properties.inl"
#endif
