#pragma once
/// @file
/// Chapter 9, the rigid body: what is to be written, one function a file.
///
/// Here the chapters meet. The state of a body is packed into one column of numbers as in chapter
/// 1, its orientation is a quaternion as in chapter 4, its momenta and what pushes it are those of
/// chapter 5, and the solver of 1.5 moves it. The functions of those chapters may be called.
///
/// x, P, L, v, ω, forces and torques are in world axes; R and q map body → world, and q is written
/// (w, x, y, z). A name with `_body` is in body coordinates, where it stays the same while the body
/// moves. "To rounding" means: off by some roundings of a double, not more.

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "../01_particles/contract.hpp"
#include "../04_quaternions/contract.hpp"
#include "../05_momentum/contract.hpp"
#include "not_implemented.hpp"

namespace rigid_body {

using momentum::Wrench;
using quaternions::Quaternion;

/// What stays the same while a body moves.
struct Body {
  double mass;                 ///< [kg], positive
  Eigen::Matrix3d I_body;      ///< inertia tensor about the centre of mass [kg m²]: symmetric, but
                               ///< not always diagonal
  Eigen::Matrix3d I_body_inv;  ///< its inverse [1/(kg m²)]
};

/// What changes: thirteen numbers.
struct State {
  Eigen::Vector3d x;  ///< centre of mass [m]
  Quaternion q;       ///< orientation
  Eigen::Vector3d P;  ///< linear momentum [kg m/s]
  Eigen::Vector3d L;  ///< angular momentum about the centre of mass [kg m²/s]
};

/// The same thirteen numbers as a solver sees them.
using PackedState = Eigen::Matrix<double, 13, 1>;

// == 9.1 pack: a state becomes thirteen numbers
/// @param state any; q need not have length 1
/// @return y = (x, q, P, L), in this order, the numbers as they are, unrounded
PackedState pack(const State& state);

// == 9.2 unpack: thirteen numbers become a state
/// A solver asks for derivatives in states that it only tries, where q does not have length 1. That
/// is not repaired here: what pack() makes of the result is y again, number for number.
/// @param y what pack() gives, or what a solver has made of it
/// @return the state, its numbers as they are in y, unrounded
State unpack(const PackedState& y);

}  // namespace rigid_body
