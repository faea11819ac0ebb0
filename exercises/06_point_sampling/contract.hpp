#pragma once
/// @file
/// Chapter 6, point sampling: what you write, one function per file.
///
/// An inertia tensor says how hard it is to turn a body: L = I ω. Its products, the numbers off the
/// diagonal, carry the minus sign: I_xy = −∫ x y dm. Where we say nothing else, it is about the
/// centre of mass. "To rounding" means: off by some roundings of a double, not more. "To rounding
/// of the places" means: as if each coordinate were off by some roundings of the largest one.
///
/// You may use the standard library, Eigen/Core and the functions of earlier exercises, such as
/// those of chapter 5 and `rotation_matrices::skew(a) * b` for a × b. The judge supplies correct
/// ones, even where yours don't pass yet. Other parts of Eigen are not there: no cross(),
/// inverse(), determinant() or decomposition.

#include <Eigen/Core>
#include <array>
#include <functional>
#include <vector>

#include "../05_momentum/contract.hpp"
#include "not_implemented.hpp"

namespace point_sampling {

/// From chapter 5: a `mass` [kg] in the point `position` of the world [m].
using momentum::PointMass;

/// Tells for a point of the world [m] whether it is inside a body.
using Inside = std::function<bool(const Eigen::Vector3d& point)>;

/// The surface of a body, made of triangles that share vertices.
struct Mesh {
  std::vector<Eigen::Vector3d> vertices;      ///< positions [m]
  std::vector<std::array<int, 3>> triangles;  ///< three numbers of vertices each, from 0 on:
                                              ///< counter-clockwise, seen from outside the body
};

/// All that the motion of a rigid body needs to know about its shape and material.
struct MassProperties {
  double mass;              ///< [kg]
  Eigen::Vector3d centre;   ///< centre of mass [m]
  Eigen::Matrix3d inertia;  ///< about the centre of mass [kg m²], products with the minus sign
};

// == 6.1 inertia_of_points: the discrete inertia sum
/// @param points masses in points of the world: none, one or many, each 0 or between 1e-100 and
///               1e100 kg
/// @param about  the point about which you want the inertia [m]; not always the centre of mass
/// @return the inertia tensor in world axes [kg m²], to rounding; zero if there are no points.
///         Points and `about` may lie together 1e8 m away from the origin: you must lose no digit
///         by that. Errors may grow with the number of points.
Eigen::Matrix3d inertia_of_points(const std::vector<PointMass>& points,
                                  const Eigen::Vector3d& about);

// == 6.2 inside_mesh: is a point inside?
/// @param mesh  of any shape: with notches, holes and cavities, or of several parts, side by side
///              or in one another's cavities. It is closed: each edge belongs to two triangles,
///              which run through it in opposite directions. Parts don't overlap. A mesh without
///              triangles has no inside.
/// @param point a place [m], away from the surface by 1/1000 of the mesh's largest extent or more.
///              A line through it may meet edges and vertices, exactly or nearly, or run along a
///              triangle or an edge. On lines along x, y and z the judge tries that on purpose.
/// @return whether the point is inside the body; a point in a hole or in a cavity is not
bool inside_mesh(const Mesh& mesh, const Eigen::Vector3d& point);

// == 6.3 sample_mass_properties: a body by counting points
/// Cut the box into n × n × n equal cells along the axes. If the middle of a cell is inside the
/// body, put the mass of a full cell into that point; otherwise put nothing there. Give the mass
/// properties of these point masses.
/// @param inside    ask it once for the middle of each cell: n³ times in all, in any order
/// @param low, high two opposite corners of the box, with the smallest and with the largest
///                  coordinates [m]; its edges may be of three different lengths, none is zero
/// @param n         number of cells along each edge, 1 or more
/// @param density   of the body [kg/m³], positive
/// @return the sum of the masses, their centre, and their inertia about that centre; all zero if
///         no middle is inside. To rounding of the places: errors may grow with n³ and with the
///         distance of the box from the origin, but not with the square of that distance.
MassProperties sample_mass_properties(const Inside& inside, const Eigen::Vector3d& low,
                                      const Eigen::Vector3d& high, int n, double density);

// == 6.4 parallel_axis: the same body about another point
/// @param I      inertia about the point `from` [kg m²]
/// @param mass   of the body [kg]
/// @param centre its centre of mass [m]
/// @param from   the point that I is about [m]; only sometimes the centre of mass
/// @param to     the point about which you want it [m]; it may be the centre of mass
/// @return the inertia about `to` [kg m²], to rounding: errors may grow with the mass and with the
///         squares of the distances of both points from the centre. All three may lie together
///         1e8 m away from the origin: you must lose no digit by that.
Eigen::Matrix3d parallel_axis(const Eigen::Matrix3d& I, double mass, const Eigen::Vector3d& centre,
                              const Eigen::Vector3d& from, const Eigen::Vector3d& to);

// == 6.5 rotate_inertia: the tensor of a body that is turned
/// @param R      orientation, body → world: a rotation to rounding
/// @param I_body inertia in body axes [kg m²], symmetric, but not always diagonal
/// @return the inertia about the same point in world axes [kg m²], to rounding
Eigen::Matrix3d rotate_inertia(const Eigen::Matrix3d& R, const Eigen::Matrix3d& I_body);

}  // namespace point_sampling
