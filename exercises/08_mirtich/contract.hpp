#pragma once
/// @file
/// Chapter 8, Mirtich's method: what you write, one function per file.
///
/// The integrals over a body become sums over its faces, those over a face become integrals over
/// the face's shadow in a coordinate plane, and those over the shadow become sums over its edges.
///
/// γ is the axis along which we cast the shadow: 0 for x, 1 for y, 2 for z. α and β are the two
/// other axes, in a cycle: α = γ + 1 and β = γ + 2, modulo 3. So (α, β, γ) is (x, y, z), (y, z, x)
/// or (z, x, y), and if you look down from the tip of the γ axis, you see α go to the right and β
/// go up. The shadow of a point has its coordinates α and β; we drop its γ.
///
/// You may use the standard library, Eigen/Core and the functions of earlier exercises. The judge
/// supplies correct ones, even where yours don't pass yet. Other parts of Eigen are not there, so
/// no `.cross()`: for a × b call `rotation_matrices::skew(a) * b`, your 3.2, or write the three
/// components out. What chapter 3 declares is included here already.
///
/// "To rounding" means: off by some roundings of a double, not more.

#include <Eigen/Core>
#include <vector>

#include "../06_point_sampling/contract.hpp"
#include "not_implemented.hpp"

namespace mirtich {

/// As in chapter 6: `mass` [kg], `centre`, which is the centre of mass [m], and `inertia` about it
/// [kg m²], products with the minus sign.
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
/// The integrals over the shadow of a polygon: as they are if the shadow's corners go round
/// counter-clockwise, α to the right and β up, and all with a minus if they go round clockwise.
/// @param corners the polygon's corners in space [m], in order; the last one is joined to the
///                first. The polygon may have any shape, also with dents, but does not cross
///                itself. A corner may lie in the middle of an edge, or appear twice in a row, the
///                first one also at the end. A shadow without area has integrals of 0, and so have
///                fewer than three corners.
/// @param gamma   the axis along which you cast the shadow: 0, 1 or 2
/// @return the ten integrals, to rounding: the errors may grow with the number of corners, and that
///         of ∬ αⁱβʲ with the farthest corner's coordinate to the power i + j + 2
ProjectionIntegrals projection_integrals(const std::vector<Eigen::Vector3d>& corners, int gamma);

// == 8.2 face_integrals: from a face to its shadow
/// The corners of a face go round counter-clockwise, seen from the side to which its normal n
/// points. So its shadow along γ goes round counter-clockwise if n_γ is positive, and clockwise if
/// it is negative. The face's own area is positive in both cases.
/// @param shadow what 8.1 gives for the face's corners and this γ: an area with the sign of n_γ
/// @param plane  the face's plane. n_γ is not 0, and usually the largest of n's three numbers in
///               size, but any other will do.
/// @param gamma  the axis along which the shadow was cast: 0, 1 or 2
/// @return the twelve integrals, to rounding; all 0 if those of the shadow are. The errors may
///         grow with the distance of the farthest corner from the origin and with 1/n_γ, in the
///         powers in which both enter.
FaceIntegrals face_integrals(const ProjectionIntegrals& shadow, const Plane& plane, int gamma);

// == 8.3 volume_integrals: from a volume to its surface
/// The integrals over what the faces enclose, about the origin of the coordinates.
/// - Faces are plane to rounding and of any shape, as in 8.1: a face may have a dent at its first
///   corners, or its first three corners on one line.
/// - A face without area contributes nothing: fewer than three corners, all in one point, or all on
///   one line. All others count, however small.
/// - The faces of a cavity go round counter-clockwise seen from within the cavity. So the sum over
///   all faces subtracts the cavity, and you need no special case.
/// - A body inside out, whose faces all go round clockwise seen from outside, has the negatives of
///   all integrals. Without a face they are 0.
/// @param body closed: along every edge two faces meet, and they go along it in opposite
///             directions. Between 1e-40 and 1e40 m large
/// @return the ten integrals, to rounding: the errors may grow with the number of corners, and for
///         an integrand of degree d with the farthest coordinate to the power d + 3
VolumeIntegrals volume_integrals(const Polyhedron& body);

// == 8.4 mass_properties: mass, centre of mass and inertia
/// - The body may be up to 1e8 m away from the origin. Mass and inertia must lose no digit by that,
///   and the centre no more than any place so far out does.
/// - A body inside out has the negatives of its mass and its inertia, so that you can tell it from
///   a good one. Its centre is where it is.
/// - If 8.3 gives a volume of 0, as for a body without faces or with all corners in one point, then
///   mass, centre and inertia are all 0: don't divide by the volume.
/// @param body    as in 8.3; if there is a face, every vertex belongs to one
/// @param density [kg/m³], positive, the same all over the body
/// @return its mass properties, to rounding: the errors may grow with the number of corners and,
///         for a body with the diameter d, those of the mass with d³, those of the inertia with d⁵,
///         each times the density, and those of the centre with d⁴ over the volume
MassProperties mass_properties(const Polyhedron& body, double density);

}  // namespace mirtich
