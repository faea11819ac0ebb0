#pragma once
/// @file
/// Chapter 3, rotation matrices: what you write, one function per file.
///
/// R maps body → world: its columns are the body's axes x, y, z in world coordinates. A matrix that
/// a solver has moved is not quite a rotation any more; you repair it in the last two exercises.
///
/// The condition number of a matrix M is its largest stretch over its smallest one: the largest of
/// the lengths |M v| for all v of length 1, divided by the smallest of them. A rounding is the eps
/// of a double, 2.2e-16.
///
/// You may use the standard library, Eigen/Core and the functions of earlier exercises. The judge
/// supplies correct ones, even where yours don't pass yet. Other parts of Eigen are not there: no
/// cross(), inverse(), determinant() or decomposition, no rotations.

#include <Eigen/Core>
#include <array>

#include "not_implemented.hpp"

namespace rotation_matrices {

// == 3.1 euler_angles_to_matrix: three turns make an orientation
/// R = R_i(α) R_j(β) R_k(γ). You turn about the *rotating* axes: by α about axis i, then by β about
/// axis j where the first turn has left it, then by γ about axis k where the first two have left
/// it. A positive angle follows the right hand: about x from y to z, about y from z to x, about z
/// from x to y.
/// @param angles (α, β, γ) [rad], in the order of the turns. They may be negative, zero, tiny, or
///               more than a full turn
/// @param axes   (i, j, k), with 0 for x, 1 for y, 2 for z: any of the twelve sequences in which no
///               axis follows itself, such as (2, 1, 0) or (2, 0, 2)
/// @return R, body → world
Eigen::Matrix3d euler_angles_to_matrix(const Eigen::Vector3d& angles,
                                       const std::array<int, 3>& axes);

// == 3.2 skew: the cross product as a matrix
/// @param a any vector: it may be zero, tiny or huge
/// @return the 3×3 matrix with skew(a) b = a × b for every b. Its numbers are those of a, unrounded
Eigen::Matrix3d skew(const Eigen::Vector3d& a);

// == 3.3 rotation_dot: how an orientation changes
/// @param R     orientation, body → world. It may have drifted. Take it as it is: each of its
///              columns moves like an arrow that is painted on the body
/// @param omega angular velocity in *world* axes [rad/s]; it may be zero, tiny or huge
/// @return Ṙ [1/s]
Eigen::Matrix3d rotation_dot(const Eigen::Matrix3d& R, const Eigen::Vector3d& omega);

// == 3.4 gram_schmidt: a rotation again, column by column
/// Take the columns in the order x, y, z. The first keeps its direction. The second stays in the
/// plane of the first two, on the side where it was.
/// @param M a matrix with a positive determinant. Its columns may be as short as 1e-50 or as long
///          as 1e50, and almost parallel. Each number of your answer may be off by some thirty
///          roundings times the condition number of M with its columns scaled to length 1, and no
///          more
/// @return the rotation: perpendicular columns of length 1, right-handed
Eigen::Matrix3d gram_schmidt(const Eigen::Matrix3d& M);

// == 3.5 nearest_rotation: the rotation that changes a matrix least
/// @param M a matrix with a positive determinant. It may be a rotation that has drifted, or far
///          from any rotation: ten times too long in one direction, flattened to a tenth, sheared
///          by 2 (a column (0, 1, 0) becomes (2, 1, 0)), or as a whole 1000 times too large or too
///          small
/// @return the rotation R with the smallest ‖R − M‖, the root of the sum of the squares of all nine
///         differences. Each of its numbers may be off by some sixty roundings times the square of
///         M's condition number
Eigen::Matrix3d nearest_rotation(const Eigen::Matrix3d& M);

}  // namespace rotation_matrices
