#pragma once
/// @file
/// Chapter 4, quaternions: what is to be written, one function a file.
///
/// A quaternion is written (w, x, y, z), the scalar first: q[0] is w, q.tail<3>() is the vector
/// part. A unit quaternion is a rotation from body to world; q and −q are the same rotation.

#include <Eigen/Core>

#include "not_implemented.hpp"

namespace quaternions {

/// (w, x, y, z): the scalar first.
using Quaternion = Eigen::Vector4d;

// == 4.1 product: the product of two quaternions
/// @param a, b any quaternions, not only unit ones
/// @return a b, in this order: as rotations, b is applied first
Quaternion product(const Quaternion& a, const Quaternion& b);

}  // namespace quaternions
