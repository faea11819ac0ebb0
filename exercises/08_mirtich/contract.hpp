#pragma once
/// @file
/// Chapter 8, Mirtich's method: what is to be written, one function a file.
///
/// The integrals over a body become sums over its faces, those over a face become integrals over
/// the face's shadow in a coordinate plane, and those over the shadow sums over its edges.
///
/// γ is the axis along which the shadow is cast: 0 for x, 1 for y, 2 for z. α and β are the two
/// other axes, in a cycle: α = γ + 1 and β = γ + 2, modulo 3. So (α, β, γ) is (x, y, z), (y, z, x)
/// or (z, x, y), and whoever looks from the tip of the γ axis sees α go to the right and β go up.
/// The shadow of a point has its coordinates α and β; its γ is dropped.
///
/// "To rounding" means: off by some roundings of a double, not more.

#include <Eigen/Core>
#include <vector>

#include "not_implemented.hpp"

namespace mirtich {

/// ∬ f dα dβ over a shadow.
struct ProjectionIntegrals {
  double one;                 ///< of 1                  [m²]
  double a, b;                ///< of α, β               [m³]
  double aa, ab, bb;          ///< of α², αβ, β²         [m⁴]
  double aaa, aab, abb, bbb;  ///< of α³, α²β, αβ², β³   [m⁵]
};

// == 8.1 projection_integrals: from a shadow to its edges
/// The integrals over the shadow of a polygon. They count as they are where the shadow's corners go
/// round counter-clockwise, α to the right and β up, and with a minus where they go round
/// clockwise.
/// @param corners the polygon's corners in space [m], in order; the last one is joined to the
///                first. It may have any shape, also with dents, but does not cross itself. Corners
///                may lie in the middle of an edge, or be given twice in a row, the first one also
///                at the end. A shadow without area, such as that of fewer than three corners or of
///                none, has integrals of 0.
/// @param gamma   the axis along which the shadow is cast: 0, 1 or 2
/// @return the ten integrals, to rounding: the errors may grow with the number of corners, and that
///         of ∬ αⁱβʲ with the farthest corner's coordinate to the power i + j + 2
ProjectionIntegrals projection_integrals(const std::vector<Eigen::Vector3d>& corners, int gamma);

}  // namespace mirtich
