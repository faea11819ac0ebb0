#pragma once
/// @file
/// Chapter 4, quaternions: what you write, one function per file.
///
/// We write a quaternion (w, x, y, z), the scalar first: q[0] is w, q.tail<3>() is the vector part.
/// A unit quaternion is a rotation from body to world; q and −q are the same rotation. Angles are
/// in radians. "Right to rounding" means: your result may be off by some roundings of a double, not
/// by more.
///
/// You may use the standard library, Eigen/Core and the functions of earlier exercises of this
/// chapter. The judge supplies correct ones, even where yours don't pass yet. Other parts of Eigen
/// are not there: no cross(), no Eigen::Quaternion, no AngleAxis.

#include <Eigen/Core>

#include "not_implemented.hpp"

namespace quaternions {

/// (w, x, y, z): the scalar first.
using Quaternion = Eigen::Vector4d;

// == 4.1 product: the product of two quaternions
/// @param a, b any quaternions, not only unit ones
/// @return a b, in this order: as rotations, b is applied first
Quaternion product(const Quaternion& a, const Quaternion& b);

// == 4.2 inverse: the quaternion that undoes another
/// @param q any quaternion but zero, |q| between 1e-100 and 1e100
/// @return q⁻¹, for which q q⁻¹ = q⁻¹ q = 1
Quaternion inverse(const Quaternion& q);

// == 4.3 rotate: a point turned by a quaternion
/// @param q any quaternion but zero, |q| between 1e-100 and 1e100. Only its rotation counts: a q
///          that has drifted from length 1 must not scale the point
/// @param p a point in body axes [m]; also the origin, or up to 1e151 m away from it
/// @return the same point in world axes [m], as far from the origin as before
Eigen::Vector3d rotate(const Quaternion& q, const Eigen::Vector3d& p);

// == 4.4 from_axis_angle: the turn about an axis by an angle
/// @param axis  of any length but zero, between 1e-100 and 1e100: only its direction counts
/// @param angle [rad], of any size and sign; a positive one turns counter-clockwise when the axis
///              points at you
/// @return the unit quaternion of this turn, body → world; of q and −q you may return either
Quaternion from_axis_angle(const Eigen::Vector3d& axis, double angle);

// == 4.5 to_matrix: the rotation matrix of a quaternion
/// @param q any quaternion but zero, |q| between 1e-100 and 1e100: only its rotation counts
/// @return R with R p = q p q⁻¹, body → world. It is orthonormal to rounding however far q has
///         drifted. For a tiny turn the entries off the diagonal are tiny, and right to all digits
Eigen::Matrix3d to_matrix(const Quaternion& q);

// == 4.6 from_matrix: the quaternion of a rotation matrix
/// @param R a rotation matrix, body → world, orthonormal to rounding
/// @return the unit quaternion of R; of q and −q you may return either. Right to rounding for every
///         rotation, also for half turns and close to them
Quaternion from_matrix(const Eigen::Matrix3d& R);

// == 4.7 slerp: the orientation a fraction of the way between two
/// @param a, b unit quaternions; b and −b are the same goal
/// @param t    0 gives a, 1 gives b, and outside [0, 1] the turn goes on at the same rate
/// @return the unit quaternion after the fraction t of the shorter turn from a to b, at constant
///         angular velocity; of q and −q you may return either. Right to rounding also where a and
///         b are equal or nearly so. Half a turn apart, both ways are equally short and either will
///         do
Quaternion slerp(const Quaternion& a, const Quaternion& b, double t);

// == 4.8 quaternion_dot: how fast a quaternion changes
/// @param q     orientation, body → world, of any length: it has drifted. Don't normalise it here
/// @param omega angular velocity in world axes [rad/s]
/// @return q̇ [1/s], linear in q and in ω; a rate, not a rotation
Quaternion quaternion_dot(const Quaternion& q, const Eigen::Vector3d& omega);

}  // namespace quaternions
