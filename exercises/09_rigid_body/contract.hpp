#pragma once
/// @file
/// Chapter 9, the rigid body: what you write, one function per file.
///
/// Here the chapters meet. You pack the state of a body into one column of numbers as in chapter 1.
/// Its orientation is a quaternion as in chapter 4, its momenta and what pushes it are those of
/// chapter 5, and the solver of 1.5 moves it.
///
/// You may use the standard library, Eigen/Core and the functions of earlier exercises, such as
/// those of chapters 1, 4 and 5, which are included here. The judge supplies correct ones, even
/// where yours don't pass yet. You may want `particles::rk4_step` (1.5), `quaternions::to_matrix`
/// (4.5) and `quaternion_dot` (4.8), and `momentum::angular_velocity` (5.5). Other parts of Eigen
/// are not there, so no `.cross()`: for a × b call `rotation_matrices::skew(a) * b`.
///
/// x, P, L, v, ω, forces and torques are in world axes. R and q map body → world, and we write q as
/// (w, x, y, z). A name with `_body` is in body axes, where it stays the same while the body moves.
/// "To rounding" means: your result may be off by some roundings of a double, not by more.

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "../01_particles/contract.hpp"
#include "../04_quaternions/contract.hpp"
#include "../05_momentum/contract.hpp"
#include "not_implemented.hpp"

namespace rigid_body {

using momentum::Wrench;         // of 5.4: force [N] and torque [N m], in world axes
using quaternions::Quaternion;  // of chapter 4: a column of four numbers, (w, x, y, z)

/// What stays the same while a body moves.
struct Body {
  double mass;                 ///< [kg], positive
  Eigen::Matrix3d I_body;      ///< inertia tensor about the centre of mass [kg m²]: symmetric, and
                               ///< diagonal only if the body's axes are its principal axes
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

/// You give it a time t [s] and a state. It gives you what pushes the body then and there: the sum
/// of all forces, and the sum of their torques about the centre of mass.
using WrenchAt = std::function<Wrench(double t, const State& state)>;

// == 9.1 pack: a state becomes thirteen numbers
/// Copy the numbers as they are. Don't round, don't normalise, don't change a sign.
/// @param state any state; its q need not have length 1
/// @return y = (x, q, P, L), in this order
PackedState pack(const State& state);

// == 9.2 unpack: thirteen numbers become a state
/// A solver evaluates slopes in states that it only tries out, where q does not have length 1.
/// Don't repair that here: if you pack the result, you get y again, number for number.
/// @param y what pack() gives, or what a solver has made of it
/// @return the state, with its numbers as they are in y
State unpack(const PackedState& y);

// == 9.3 derived: what follows from a state
/// @param body  a speck of dust, a planet, or anything between
/// @param state its q is any quaternion but zero, with |q| between 1e-100 and 1e100. Take only its
///              rotation: however far q has drifted, your R is a rotation to rounding
/// @return R, v and ω, to rounding; the error of ω may grow with the largest number of I_body_inv
///         times |L|
Derived derived(const Body& body, const State& state);

// == 9.4 dydt: what moves a rigid body
/// The rates of x, q, P and L, in the order of 9.1. On plain arrays you would write this function
/// as
///
///     void dydt(double t, const double y[], double ydot[]);
///
/// Here you are given the body and what pushes it as well, and you return the result.
/// @param body   what moves
/// @param wrench what pushes it. Evaluate it exactly once, at the time t, in the state that you
///               unpack from y
/// @param t      time [s]
/// @param y      the state, packed. Its q is any quaternion but zero, with |q| between 1e-100 and
///               1e100, because a solver tries states out. Take ω from the rotation that q stands
///               for, and the rate of q from q itself: a longer q has a longer rate. Repair nothing
/// @return ẏ, to rounding; the error of ω may grow with the largest number of I_body_inv times |L|
PackedState dydt(const Body& body, const WrenchAt& wrench, double t, const PackedState& y);

// == 9.5 simulate: a body in motion
/// Move the packed state by equal steps of the Runge–Kutta method of 1.5, with 9.4 as the
/// right-hand side. After each step, and only then, divide q by its length, and touch no other
/// number. The repaired state is the one that you return, and from which the next step starts.
/// @param body   what moves
/// @param wrench what pushes it. Evaluate it exactly four times per step, at the times and in the
///               states of 1.5
/// @param start  the state at t0; its q has length 1 to rounding
/// @param t0, t1 the first and the last time [s]; if t1 is less than t0, time runs backwards
/// @param steps  how many steps of h = (t1 − t0)/steps; if it is 0, return only the start
/// @return steps + 1 states, at t0, t0 + h, t0 + 2h, … t1; the first is the start as it is
std::vector<State> simulate(const Body& body, const WrenchAt& wrench, const State& start, double t0,
                            double t1, int steps);

}  // namespace rigid_body
