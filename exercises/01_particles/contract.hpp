#pragma once
/// @file
/// Chapter 1, particles: what you write, one function per file.
///
/// To a solver, particles are one column of numbers, and all that moves them is one function of the
/// time and of that column. Once you have written this function, you can use every solver there is.
/// All numbers are in SI units.
///
/// You may use the standard library, Eigen/Core and the functions of earlier exercises, which are
/// declared here. The judge supplies correct ones, even where yours don't pass yet. Other parts of
/// Eigen are not there: no cross(), inverse(), determinant() or decomposition.

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "not_implemented.hpp"

namespace particles {

/// A point with a mass.
struct Particle {
  double mass;        ///< [kg]
  Eigen::Vector3d x;  ///< position [m]
  Eigen::Vector3d v;  ///< velocity [m/s]
};

/// A damped spring between two particles, which are numbered from 0. No constant is negative.
struct Spring {
  int i, j;            ///< its ends, two different particles
  double stiffness;    ///< [N/m]
  double damping;      ///< [N s/m]
  double rest_length;  ///< [m]
};

/// The masses of the particles, and what acts on them.
struct System {
  std::vector<double> masses;  ///< [kg], positive, one per particle
  Eigen::Vector3d gravity;     ///< acceleration of free fall [m/s²]
  double linear_drag;          ///< β, zero or positive [kg/s]
  double quadratic_drag;       ///< γ, zero or positive [kg/m]
  std::vector<Spring> springs;
};

/// The right-hand side f of y' = f(t, y). On plain arrays you would write it as
///
///     void dydt(double t, const double y[], double ydot[]);
///
/// and put the result into ydot. Here you return it.
using Rhs = std::function<Eigen::VectorXd(double t, const Eigen::VectorXd& y)>;

// == 1.1 flatten: many particles, one state
/// Six numbers per particle, in the order of the particles: first its position, then its velocity.
/// Leave the masses out: they do not change.
/// @param particles any number of them, also none
/// @return y = (x₀, v₀, x₁, v₁, …), the numbers as they are, unrounded
Eigen::VectorXd flatten(const std::vector<Particle>& particles);

// == 1.2 dydt: what moves the particles
/// The rates of all positions and velocities. The forces on a particle add up. They are
/// - its weight;
/// - drag, against the velocity: `linear_drag` times the speed, plus `quadratic_drag` times the
///   square of the speed;
/// - the tension of each spring that ends at it, towards the other end: stiffness times how much
///   longer than at rest the spring is, plus damping times the rate at which it gets longer. A
///   negative tension pushes. Both ends feel it equally strongly. A spring whose ends are at the
///   same place has no direction: it does not pull, however its ends move.
///
/// @param system any number of particles and of springs, also none; several springs may end at one
///               particle, and join the same two
/// @param t      time [s]; none of these forces depends on it
/// @param y      positions [m] and velocities [m/s] as flatten() orders them. Two particles are at
///               the same place or at least 1e-100 m apart.
/// @return ẏ, in the same order
Eigen::VectorXd dydt(const System& system, double t, const Eigen::VectorXd& y);

// == 1.3 euler_step: follow the tangent
/// One step of Euler's method: follow the slope at the start for the whole step.
/// @param f right-hand side; evaluate it exactly once
/// @param t time at the start [s]
/// @param y state at the start, of any size, also empty
/// @param h step [s]: positive, zero, or negative to go back in time
/// @return the state at t + h
Eigen::VectorXd euler_step(const Rhs& f, double t, const Eigen::VectorXd& y, double h);

// == 1.4 midpoint_step: look halfway, then go
/// One step of the midpoint method: make half of an Euler step to look at the slope there, and
/// follow that slope for the whole step. The error after many steps falls as h².
/// @param f right-hand side; evaluate it exactly twice
/// @param t time at the start [s]
/// @param y state at the start, of any size, also empty
/// @param h step [s]: positive, zero, or negative to go back in time
/// @return the state at t + h
Eigen::VectorXd midpoint_step(const Rhs& f, double t, const Eigen::VectorXd& y, double h);

// == 1.5 rk4_step: four slopes for one step
/// One step of the classical Runge–Kutta method, RK4. Of its four slopes one is at the start, two
/// are halfway, and one is at the end. To look at each of the last three, go from the start y along
/// the slope before it. Average the four as Simpson's rule does. The error after many steps falls
/// as h⁴.
/// @param f right-hand side; evaluate it exactly four times
/// @param t time at the start [s]
/// @param y state at the start, of any size, also empty
/// @param h step [s]: positive, zero, or negative to go back in time
/// @return the state at t + h
Eigen::VectorXd rk4_step(const Rhs& f, double t, const Eigen::VectorXd& y, double h);

}  // namespace particles
