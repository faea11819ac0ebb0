#pragma once
/// @file
/// Chapter 11, when bodies meet: what you write, one function per file.
///
/// Between two contacts a flight has a formula. So you find *when* bodies touch, and change their
/// momenta there by an impulse that never creates energy.
///
/// Places, velocities, forces and impulses are in world axes. A normal n has length 1 to rounding.
/// Bodies and states are those of chapter 9: a `Body` has `mass`, `I_body` and `I_body_inv`, a
/// `State` has `x`, `q`, `P` and `L`. A `Box` is that of chapter 7, with `centre`, `R` and `size`.
/// You may call your functions of all earlier chapters, and use all of Eigen/Core. The judge
/// supplies correct ones, even where yours don't pass yet. `.cross()` is not in it: for a × b call
/// `rotation_matrices::skew(a) * b`. "To rounding" means: off by some roundings of a double, not by
/// more.

#include <Eigen/Core>
#include <functional>
#include <utility>
#include <vector>

#include "../07_bounding_boxes/contract.hpp"
#include "../09_rigid_body/contract.hpp"
#include "not_implemented.hpp"

namespace when_bodies_meet {

using bounding_boxes::Box;
using rigid_body::Body;
using rigid_body::State;

/// A box along the axes of the world that contains a body: all points with low ≤ (x, y, z) ≤ high,
/// borders included.
struct Bounds {
  Eigen::Vector3d low, high;  ///< [m]
};

/// The numbers of two bodies, the smaller one first.
struct Pair {
  int first, second;
};

/// Tells whether the bodies with these two numbers really meet. That is expensive.
using Meet = std::function<bool(int first, int second)>;

/// Two parallel planes between two boxes, or the least that two boxes overlap.
struct Separation {
  double gap;              ///< from plane to plane [m]; negative where the boxes overlap
  Eigen::Vector3d normal;  ///< of the planes, length 1, from the first box to the second
};

/// Gives the gap [m] between two bodies at the time t, negative where they overlap. That is
/// expensive.
using GapAt = std::function<double(double t)>;

/// When two bodies first touch.
struct FirstContact {
  bool found;  ///< whether they touch at all
  double t;    ///< when [s]; 0 if they don't
};

/// What a contact in a plane does.
struct PlanarImpulse {
  Eigen::Vector2d impulse;  ///< along the surface, and along the normal [N s]
  bool jammed;              ///< Painlevé's paradox: friction presses faster than it can part them
};

/// A ball, the floor that it falls on, and what pulls it down.
struct BallAndFloor {
  double mass, radius;  ///< of the ball, which is solid and even [kg], [m]
  double height;        ///< z of the floor [m]
  double gravity;       ///< downwards [m/s²], positive
  double e;             ///< coefficient of restitution, 0 … 1
  double mu;            ///< coefficient of friction, 0 or more
};

/// How a ball moves at one moment.
struct BallState {
  double t;               ///< [s]
  Eigen::Vector3d x;      ///< its centre [m]
  Eigen::Vector3d v;      ///< [m/s]
  Eigen::Vector3d omega;  ///< angular velocity [rad/s]
};

/// The states right after each contact, and how it ends.
struct Bounces {
  std::vector<BallState> after;  ///< one for each contact, in the order of time
  bool at_rest;                  ///< whether the ball bounces no more
  double rest_time;              ///< since when [s]; 0 if it still bounces
};

// == 11.1 overlapping_pairs: who can meet at all
/// Two bodies can only meet where their bounds overlap, along x, y *and* z. Touching counts.
/// Sort the bounds along an axis and sweep. One axis of your choice is enough: n bodies that are
/// spread along it cost n log n, not n². The judge sees your pairs, not your way to them.
/// Ask `meet` for each pair whose bounds overlap, exactly once, with the smaller number first, and
/// for no other pair.
/// @param bounds of the bodies 0, 1, 2 …; a bound may be a point, and two may be equal
/// @param meet   tells whether two bodies really meet
/// @return the pairs that meet, sorted by the first number, then by the second
std::vector<Pair> overlapping_pairs(const std::vector<Bounds>& bounds, const Meet& meet);

// == 11.2 separation: a plane between two boxes
/// Look along 15 directions: the three edges of A, the three of B, and the nine products of an edge
/// of A with one of B. Along each direction both boxes are intervals, with a gap between them, or
/// an overlap, which is a negative gap. Give the largest gap of all directions. If it is positive,
/// the boxes are apart, and a plane with this normal between them proves it. If it is negative, it
/// is the least that you must move one of them to free it.
/// @param a, b boxes anywhere, with edges of 1e-6 to 1e6 m; their centres may be at one place. Each
///             edge of A makes an angle of at least 0.01 rad with each edge of B, or is parallel to
///             it up to rounding (1e-13 rad): leave out the product of parallel edges
/// @return the largest gap, to rounding of the places (you must lose no digit if both boxes are
///         1e8 m away from the origin), and its direction, from A to B. If several directions have
///         the largest gap, give any of them; if a plane with this normal holds both centres,
///         either direction of the normal is right
Separation separation(const Box& a, const Box& b);

// == 11.3 first_contact: the time at which two bodies touch
/// Conservative advancement: two bodies that are d apart and come together with `speed` at most
/// can't touch before the time d/speed from now. So go there, and look again.
/// @param gap       between them; the largest change per second is `speed`. Each evaluation is
///                  expensive: don't evaluate it twice at the same time, and at most twice as often
///                  as jumps of d/speed need, which may be thousands of times
/// @param speed     bound on |d gap/dt| [m/s], positive
/// @param t0, t1    from when to when you look [s], t0 ≤ t1
/// @param tolerance a gap that is not larger counts as touching [m]: positive, and at least ten
///                  times the change of the gap when t is rounded
/// @return the first of the times that you looked at where gap(t) ≤ tolerance; `found` is false if
///         there is none up to t1. Between t0 and the answer the gap is nowhere below 0, however
///         fast they are. A gap ≤ tolerance at t0 is a contact at t0
FirstContact first_contact(const GapAt& gap, double speed, double t0, double t1, double tolerance);

// == 11.4 contact_matrix: how a point responds to an impulse
/// An impulse j at a point of the body changes the velocity there by K j.
/// @param body  what is hit. A mass of infinity with an `I_body_inv` of zero is a wall: its K is 0
/// @param state where it is and how it is turned, with |q| = 1 to rounding
/// @param point where it is hit, in the world [m]
/// @return K [1/kg], symmetric to the last bit, to rounding. State and point may lie together 1e8 m
///         away from the origin: you must lose no digit by that
Eigen::Matrix3d contact_matrix(const Body& body, const State& state, const Eigen::Vector3d& point);

// == 11.5 collide: an impact without friction
/// The impulse along the normal after which u·n is −e times what it was. Bodies that part, or that
/// neither part nor come together, get none.
/// @param K how easily both points give way, added [1/kg]: symmetric, positive definite
/// @param u velocity of the first body's point less that of the second one's [m/s]
/// @param n normal, out of the second body: u·n < 0 means that they come together
/// @param e coefficient of restitution, 0 … 1
/// @return the impulse on the first body [N s]; the second one gets its negative. To rounding
Eigen::Vector3d collide(const Eigen::Matrix3d& K, const Eigen::Vector3d& u,
                        const Eigen::Vector3d& n, double e);

// == 11.6 collide_with_friction: an impact that never creates energy
/// All in one plane: the first number is along the surface, the second one along the normal. While
/// the normal impulse p grows from 0, the velocity follows u(p) = u + K j(p). Friction adds ∓μ per
/// unit of p, against the slip u_t *as it is then*. When the slip comes to an end, it stays at rest
/// if a friction of size ≤ μ can hold it there. Otherwise it goes on in the direction in which the
/// normal impulse drives it, against friction μ. A contact without slip at its start begins with
/// the same question.
///
/// The contact ends by Stronge's law. Up to the moment when u_n = 0 the normal impulse takes the
/// work W = −∫ u_n dp, and from then on it gives back e² W. Then the contact is over. In a plane
/// there is exactly one such moment: u_n may fall at first, but once it grows, it grows to the end.
/// @param K  how easily both points give way, added [1/kg]: symmetric, positive definite
/// @param u  velocity of the first body's point less that of the second one's [m/s]; u_n ≥ 0 gets
///           no impulse, and is not jammed
/// @param e  coefficient of restitution, 0 … 1
/// @param mu coefficient of friction, 0 or more
/// @return the impulse on the first body, to rounding. `jammed` says that the slip with which the
///         contact begins doesn't let u_n grow: K_nn ∓ μ K_nt ≤ 0. In this case, too, the impulse
///         must be right
PlanarImpulse collide_with_friction(const Eigen::Matrix2d& K, const Eigen::Vector2d& u, double e,
                                    double mu);

// == 11.7 bounce: from contact to contact
/// A ball over a floor. In flight it falls and spins on without any force but its weight: each
/// contact is the root of a quadratic. At a contact use 11.6 in the plane of the normal and the
/// slip. There z is exactly height + radius, and v_z afterwards is e times the speed of the
/// landing.
///
/// With e < 1 it bounces infinitely often in a finite time. If v_z after a contact is at most a
/// billionth (1e-9) of the speed of the first landing, list this contact and no more. Then
/// `rest_time` is the time of this contact and of the flights that are left, each e times as long
/// as the one before.
/// @param scene the ball and the floor
/// @param start the ball above the floor, or just on it. If it is on it, and v_z < 0, it lands at
///              once; if v_z = 0, it is at rest since `start.t`
/// @param t1    contacts after this time [s], which is `start.t` or later, don't count. If the
///              `rest_time` would be later, the ball is not at rest, and `rest_time` is 0
/// @return all contacts, to rounding: errors may grow with the number of contacts
Bounces bounce(const BallAndFloor& scene, const BallState& start, double t1);

}  // namespace when_bodies_meet
