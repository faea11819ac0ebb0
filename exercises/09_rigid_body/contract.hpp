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

/// What follows from a state.
struct Derived {
  Eigen::Matrix3d R;      ///< orientation as a matrix
  Eigen::Vector3d v;      ///< velocity of the centre of mass [m/s]
  Eigen::Vector3d omega;  ///< angular velocity [rad/s]
};

/// What pushes a body at the time t [s], when it is in this state: the sum of all forces, and of
/// their torques about the centre of mass.
using WrenchAt = std::function<Wrench(double t, const State& state)>;

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

// == 9.3 derived: what follows from a state
/// @param body  may be a speck of dust or a planet
/// @param state q is any quaternion but zero, |q| between 1e-100 and 1e100: of q only its rotation
///              counts, so that R is a rotation to rounding however far q has drifted
/// @return R, v and ω, to rounding; the errors of ω may grow with the largest number of I_body_inv
///         times |L|
Derived derived(const Body& body, const State& state);

// == 9.4 dydt: what moves a rigid body
/// The rates of x, q, P and L, in the order of 9.1. On plain arrays this function is written
///
///     void dydt(double t, const double y[], double ydot[]);
///
/// Here the body and what pushes it are given too, and the result is returned.
/// @param body   what moves
/// @param wrench what pushes it; evaluated exactly once, at the time t and in the state that is
///               packed in y, as it is
/// @param t      time [s]
/// @param y      the state, packed. Its q is any quaternion but zero, |q| between 1e-100 and 1e100:
///               a solver asks in states that it only tries. ω is that of the rotation which q
///               stands for; the rate of q is that of q itself, longer for a longer q. Nothing is
///               repaired here.
/// @return ẏ, to rounding; the errors of ω may grow with the largest number of I_body_inv times |L|
PackedState dydt(const Body& body, const WrenchAt& wrench, double t, const PackedState& y);

// == 9.5 simulate: a body in motion
/// The packed state is moved by equal steps of the Runge–Kutta method of 1.5, with 9.4 for the
/// right-hand side. After each step, and only then, q is divided by its length; no other number is
/// touched. That is the state which is returned, and from which the next step starts.
/// @param body   what moves
/// @param wrench what pushes it; evaluated exactly four times a step, at the times and in the
///               states that 1.5 demands
/// @param start  the state at t0; its q has length 1 to rounding
/// @param t0, t1 the first and the last time [s]; where t1 is less than t0, time runs backwards
/// @param steps  how many steps of h = (t1 − t0)/steps; 0: then only the start is returned
/// @return steps + 1 states, at t0, t0 + h, t0 + 2h, … t1; the first is the start as it is
std::vector<State> simulate(const Body& body, const WrenchAt& wrench, const State& start, double t0,
                            double t1, int steps);

}  // namespace rigid_body
