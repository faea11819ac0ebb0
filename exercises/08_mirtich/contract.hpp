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
/// The cross product a × b is `rotation_matrices::skew(a) * b`, with 3.2; or write its three
/// components out. Eigen's own `.cross()` is not among what an exercise has.
///
/// "To rounding" means: off by some roundings of a double, not more.

#include <Eigen/Core>
#include <vector>

#include "../06_point_sampling/contract.hpp"
#include "not_implemented.hpp"

namespace mirtich {

using point_sampling::MassProperties;

/// A body, given by the plane polygons that bound it.
struct Polyhedron {
  std::vector<Eigen::Vector3d> vertices;  ///< positions [m]
  std::vector<std::vector<int>> faces;    ///< each the numbers of its corners' vertices, from 0 on:
                                          ///< counter-clockwise, seen from outside the body
};

/// The plane n · x + w = 0 of a face: w is minus its distance from the origin, along n.
struct Plane {
  Eigen::Vector3d n;  ///< unit normal, to the side from which the face is seen; in x, y, z
  double w;           ///< [m]
};

/// ∬ f dα dβ over a shadow.
struct ProjectionIntegrals {
  double one;                 ///< of 1                  [m²]
  double a, b;                ///< of α, β               [m³]
  double aa, ab, bb;          ///< of α², αβ, β²         [m⁴]
  double aaa, aab, abb, bbb;  ///< of α³, α²β, αβ², β³   [m⁵]
};

/// ∬ f dA over a face in space, with its true area.
struct FaceIntegrals {
  double a, b, c;        ///< of α, β, γ            [m³]
  double aa, bb, cc;     ///< of α², β², γ²         [m⁴]
  double aaa, bbb, ccc;  ///< of α³, β³, γ³         [m⁵]
  double aab, bbc, cca;  ///< of α²β, β²γ, γ²α      [m⁵]
};

/// ∫ f dV over a body.
struct VolumeIntegrals {
  double one;                ///< of 1             [m³]
  Eigen::Vector3d r;         ///< of x, y, z       [m⁴]
  Eigen::Vector3d squares;   ///< of x², y², z²    [m⁵]
  Eigen::Vector3d products;  ///< of xy, yz, zx    [m⁵]
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

// == 8.2 face_integrals: from a face to its shadow
/// The corners of a face go round counter-clockwise, seen from the side to which its normal n
/// points. So its shadow along γ goes round counter-clockwise where n_γ is positive, and clockwise
/// where it is negative. The face's own area is positive in both cases.
/// @param shadow what 8.1 gives for the face's corners and this γ: an area with the sign of n_γ
/// @param plane  the face's plane. n_γ is not 0, and usually the largest of n's three numbers in
///               size, but any other will do.
/// @param gamma  the axis along which the shadow was cast: 0, 1 or 2
/// @return the twelve integrals, to rounding; all 0 where those of the shadow are. The errors may
///         grow with the distance of the farthest corner from the origin and with 1/n_γ, in the
///         powers in which both enter.
FaceIntegrals face_integrals(const ProjectionIntegrals& shadow, const Plane& plane, int gamma);

// == 8.3 volume_integrals: from a volume to its surface
/// The integrals over what the faces enclose, about the origin of the coordinates.
/// - Faces are plane to rounding and of any shape, as in 8.1: a face may have a dent at its first
///   corners, or its first three corners on one line.
/// - A face without area brings nothing: fewer than three corners, all in one point, or all on one
///   line. All others count, however small.
/// - The faces of a cavity are seen from within the cavity: it is taken off.
/// - A body inside out, whose faces all go round clockwise seen from outside, has the negatives of
///   all integrals. Without a face they are 0.
/// @param body closed: along every edge two faces meet. Between 1e-40 and 1e40 m large
/// @return the ten integrals, to rounding: the errors may grow with the number of corners, and for
///         an integrand of degree d with the farthest coordinate to the power d + 3
VolumeIntegrals volume_integrals(const Polyhedron& body);

// == 8.4 mass_properties: mass, centre of mass and inertia
/// - The body may be up to 1e8 m away from the origin: mass and inertia lose no digit by that, and
///   the centre no more than a place so far out has to.
/// - A body inside out has the negatives of its mass and its inertia, so that it can be told from a
///   good one, and its centre where it is.
/// - Where there is no volume at all, because there are no faces or all corners are in one point,
///   mass, centre and inertia are 0.
/// @param body    as in 8.3; every vertex belongs to a face, if there is a face
/// @param density [kg/m³], positive, the same all over the body
/// @return its mass properties, to rounding: the errors may grow with the number of corners and,
///         for a body with the diameter d, those of the mass with d³, those of the inertia with d⁵,
///         each times the density, and those of the centre with d⁴ over the volume
MassProperties mass_properties(const Polyhedron& body, double density);

}  // namespace mirtich
