#pragma once
/// @file
/// Chapter 3, rotation matrices: what is to be written, one function a file.
///
/// R maps body → world: its columns are the body's axes x, y, z in world coordinates. A matrix that
/// an integrator has carried along is a rotation no more; the last two units repair it.

#include <Eigen/Core>
#include <array>

#include "not_implemented.hpp"

namespace rotation_matrices {

// == 3.1 euler_angles_to_matrix: three turns make an orientation
/// R = R_i(α) R_j(β) R_k(γ), turns about the *rotating* axes: by α about axis i, then by β about
/// axis j as the first turn has left it, then by γ about axis k as the two before have left it.
/// A positive angle turns by the right hand: about x from y to z, about y from z to x, about z from
/// x to y.
/// @param angles (α, β, γ) [rad], in the order of the turns: of any sign, zero, tiny, or beyond a
///               full turn
/// @param axes   (i, j, k), 0 for x, 1 for y, 2 for z: any of the twelve sequences where no axis
///               follows itself, such as (2, 1, 0) or (2, 0, 2)
/// @return R, body → world
Eigen::Matrix3d euler_angles_to_matrix(const Eigen::Vector3d& angles,
                                       const std::array<int, 3>& axes);

// == 3.2 skew: the cross product as a matrix
/// @param a any vector: zero, tiny and huge ones too
/// @return the 3×3 matrix with skew(a) b = a × b for every b; its numbers are those of a, unrounded
Eigen::Matrix3d skew(const Eigen::Vector3d& a);

// == 3.3 rotation_dot: how an orientation changes
/// @param R     orientation, body → world. It may have drifted: it is taken as it is, and each of
///              its columns moves like an arrow that is fixed to the body.
/// @param omega angular velocity in *world* axes [rad/s]; zero, tiny and huge ones too
/// @return Ṙ [1/s]
Eigen::Matrix3d rotation_dot(const Eigen::Matrix3d& R, const Eigen::Vector3d& omega);

// == 3.4 gram_schmidt: a rotation again, column by column
/// The columns are taken in the order x, y, z. The first keeps its direction, the second stays in
/// the plane of the first two, on the side where it was.
/// @param M a matrix with a positive determinant. Its columns may be as short as 1e-50, as long as
///          1e50, and almost parallel: then the errors may be as large as the rounding of a double
///          times the condition number of M with its columns scaled to length 1, and no larger.
/// @return the rotation: orthogonal unit columns, right-handed
Eigen::Matrix3d gram_schmidt(const Eigen::Matrix3d& M);

// == 3.5 nearest_rotation: the rotation that changes a matrix least
/// @param M a matrix with a positive determinant: a rotation that has drifted, or one far from any
///          rotation, such as ten times too long in one direction, flattened to a tenth, sheared by
///          twice its size, or as a whole 1000 times too large or too small
/// @return the rotation R with the smallest ‖R − M‖, the root of the sum of the squares of all nine
///         differences. Exact to rounding times the square of M's condition number.
Eigen::Matrix3d nearest_rotation(const Eigen::Matrix3d& M);

}  // namespace rotation_matrices
