#pragma once
/// @file
/// Chapter 10, only what a scene needs: what you write, one function per file.
///
/// You compute nothing that you don't need: no orientation for a particle, no tensor for a ball, no
/// step where nothing pushes. And you watch what you compute: a free body keeps its energy, so an
/// energy that doesn't stay tells you what your method is worth.
///
/// Conventions, bodies and states are those of chapter 9. "To rounding" means: off by a few
/// roundings of a double, not more.
///
/// You may use the standard library, Eigen/Core and the functions of earlier exercises, such as
/// those of chapters 4, 5 and 9. The judge supplies correct ones, even where yours don't pass yet.
/// You may want `quaternions::product` (4.1), `rotate` (4.3) and `from_axis_angle` (4.4), and
/// `rigid_body::derived` (9.3), which gives v and ω. Other parts of Eigen are not there, so no
/// `.cross()`: for a × b call `rotation_matrices::skew(a) * b`.

#include <Eigen/Core>
#include <vector>

#include "../09_rigid_body/contract.hpp"
#include "not_implemented.hpp"

namespace only_what_a_scene_needs {

using quaternions::Quaternion;
using rigid_body::Body;
using rigid_body::State;

/// What you have to know of a body, from the least to the most.
enum class Model {
  particle = 0,       ///< its mass: where it is matters, how it is turned does not
  ball = 1,           ///< one moment of inertia for all axes
  symmetric_top = 2,  ///< one moment about an axis of symmetry, another perpendicular to it
  full_body = 3,      ///< three moments
};

/// What happens to a body, and what you want to know of it. No force of the scene depends on how
/// fast the body spins. (The air's force on a ball with top-spin does.)
struct Scene {
  Eigen::Vector3d moments;            ///< principal moments of inertia, in any order [kg m²]:
                                      ///< positive, between 1e-110 and 1e110
  double omega;                       ///< the largest |ω| that occurs [rad/s], 0 or more
  double duration;                    ///< how long you follow it [s], 0 or more; omega · duration
                                      ///< is at most 1e10
  bool orientation_is_asked;          ///< you want to know how it is turned
  bool force_depends_on_orientation;  ///< such as the force on a sail
  bool torque_acts;                   ///< of any kind, also that of a top's weight
};

/// The least that will do.
struct Choice {
  Model model;
  bool steps;  ///< do you have to integrate its turning step by step?
};

/// How the energy of a motion has strayed from what it was at first.
struct EnergyDrift {
  double largest;  ///< by how much at most, as a fraction of the first energy
  double trend;    ///< by how much per second on average, as such a fraction too [1/s]
};

// == 10.1 choose_model: the least that will do
/// - Orientation counts if you want to know it, and also if a force depends on it: then it decides
///   where the body flies. Otherwise a particle will do, torque or no torque.
/// - Two moments count as equal if their difference makes the orientation wrong by no more than the
///   tolerance. The body turns by the angle omega · duration. Multiply this angle by the difference
///   of the two moments, divided by the larger one: the product may be up to the tolerance.
/// - If orientation counts, the body is a ball if every two of its moments count as equal, a
///   symmetric top if only some two do, and a full body if no two do.
/// - Steps are needed where orientation counts and a torque acts. Without a torque you know every
///   body's turning in closed form: that of a ball and of a top with sines, that of a full body
///   with elliptic functions.
///
/// The rule for equal moments is an estimate. It doesn't hold for a body that spins perpendicular
/// to an axis of near-symmetry, where the error grows with the square of the angle. The scene
/// doesn't say about which axis its body spins, so use the rule for all of them.
/// @param scene     what happens
/// @param tolerance by how much the orientation may be wrong at the end [rad]: 0 or more
/// @return the model that needs the least, and whether it needs steps
Choice choose_model(const Scene& scene, double tolerance);

// == 10.2 free_symmetric_top: any time at once
/// A body with two equal moments that nothing pushes. You know its orientation at any time without
/// a single step: there are two turns, each at a rate that stays the same.
/// @param A  moment of inertia about every axis perpendicular to that of symmetry [kg m²]
/// @param C  moment of inertia about the axis of symmetry, which is the body's z axis [kg m²]. Both
///           are between 1e-60 and 1e60. C is at most 2 A, since no body has more, and may be a
///           millionth of A, nearly A, or A.
/// @param q0 orientation at time 0, of length 1 to rounding
/// @param L  angular momentum in world axes [kg m²/s]: zero, or |L| is between 1e-60 and 1e60
/// @param t  time [s], negative for what was before; of any length for which a double can hold the
///           angle below
/// @return q at time t, of length 1 to rounding; q or −q, as you like. Its error may be some
///         roundings, multiplied by the angle |t| |L| (1/A + 1/C) where that is more than 1.
Quaternion free_symmetric_top(double A, double C, const Quaternion& q0, const Eigen::Vector3d& L,
                              double t);

// == 10.3 energy_drift: does the energy swing, or does it run away?
/// The energy is kinetic, of the centre's motion and of the turning about it. A good method lets it
/// swing between fixed bounds: then `largest` stays, however long you look on, and `trend` goes
/// to zero. A bad one lets it run away: then `trend` stays, and `largest` grows.
///
/// With eᵢ = (Eᵢ − E₀)/E₀, for the state with the number i at the time i h,
/// - `largest` is the largest size of all eᵢ;
/// - `trend` is the slope of the straight line that fits the points (i h, eᵢ) best: with the
///   smallest sum of squares of vertical distances. The line need not go through any of them.
///
/// Of a single state the trend is 0; of none, and of a body that is at rest in all of them, both
/// are 0.
/// @param body   what moves
/// @param states its states, one after the other; the first has an energy, or none has. Their
///               quaternions need not have length 1: only the rotation counts
/// @param h      time from each state to the next [s]: not zero, negative where the states lead
///               back in time
/// @return both, to rounding of the energies: the errors of E may grow with the largest number of
///         `I_body_inv` times |L|²
EnergyDrift energy_drift(const Body& body, const std::vector<State>& states, double h);

}  // namespace only_what_a_scene_needs
