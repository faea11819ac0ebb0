#pragma once
/// @file
/// Chapter 5, momentum: what you write, one function per file.
///
/// A rigid body has its centre of mass at x in the world [m]. Body coordinates have their origin
/// there. R takes body axes to world axes: its columns are the body's axes. R is a rotation to
/// rounding. A name with `_body` is in body coordinates, where it stays the same while the body
/// moves. Everything else is in world axes.
///
/// You may use the standard library, Eigen/Core and the functions of earlier exercises. The judge
/// supplies correct ones, even where yours don't pass yet. Other parts of Eigen are not there, so
/// no `.cross()`: for a × b call `rotation_matrices::skew(a) * b`, from 3.2, which is included
/// here, or write the three components out.
///
/// "To rounding" means: your result may be off by some roundings of a double, not by more.

#include <Eigen/Core>
#include <vector>

#include "../03_rotation_matrices/contract.hpp"
#include "not_implemented.hpp"

namespace momentum {

/// A mass [kg] in one point of the world [m].
struct PointMass {
  double mass;
  Eigen::Vector3d position;
};

/// A force in world axes [N], and the point of the body that it acts on, in body coordinates [m].
struct ForceAtBodyPoint {
  Eigen::Vector3d force;
  Eigen::Vector3d p_body;
};

/// A force [N] and a torque about the centre of mass [N m], in world axes.
struct Wrench {
  Eigen::Vector3d force;
  Eigen::Vector3d torque;
};

// == 5.1 centre_of_mass: the point where masses balance
/// @param points one mass or more, each 0 or between 1e-100 and 1e100 kg, but not all of them 0;
///               up to 1e100 m away from the origin
/// @return their centre of mass [m], to rounding of the places: your error may grow with the number
///         of points and with the distance of the farthest one from the origin
Eigen::Vector3d centre_of_mass(const std::vector<PointMass>& points);

// == 5.2 point_velocity: how fast a point of a body moves
/// @param x      where the centre of mass is [m]; you can do without it
/// @param R      orientation, body → world
/// @param v      velocity of the centre of mass [m/s]
/// @param omega  angular velocity, in world axes [rad/s]
/// @param p_body the point, in body coordinates [m]
/// @return the velocity of that point in world axes [m/s], to rounding. Don't lose any digit
///         for a body that is 1e8 m away from the origin
Eigen::Vector3d point_velocity(const Eigen::Vector3d& x, const Eigen::Matrix3d& R,
                               const Eigen::Vector3d& v, const Eigen::Vector3d& omega,
                               const Eigen::Vector3d& p_body);

// == 5.3 torque: how strongly a force turns a body
/// @param force [N]
/// @param p     the point that it acts on, in the world [m]
/// @param x     the centre of mass [m]
/// @return the torque about the centre of mass [N m], to rounding. Don't lose any digit
///         where p and x are together 1e8 m away from the origin
Eigen::Vector3d torque(const Eigen::Vector3d& force, const Eigen::Vector3d& p,
                       const Eigen::Vector3d& x);

// == 5.4 net_wrench: all forces on a body, added up
/// Add the weight yourself. It acts at the centre of mass, and it is not among the forces of the
/// list.
/// @param mass   of the body [kg]
/// @param x      where the centre of mass is [m]; you can do without it
/// @param R      orientation, body → world
/// @param g      acceleration of free fall [m/s²], in any direction, zero in orbit
/// @param forces all other forces: none, one or many
/// @return the sum of all forces, and the sum of their torques about the centre of mass, to
///         rounding; your error may grow with the number of forces and with the distance of the
///         body from the origin
Wrench net_wrench(double mass, const Eigen::Vector3d& x, const Eigen::Matrix3d& R,
                  const Eigen::Vector3d& g, const std::vector<ForceAtBodyPoint>& forces);

// == 5.5 angular_velocity: from L to ω
/// @param R          orientation, body → world
/// @param I_body_inv the inverse of the inertia tensor, in body coordinates [1/(kg m²)]: symmetric,
///                   but not always diagonal
/// @param L          angular momentum about the centre of mass, in world axes [kg m²/s]
/// @return the angular velocity ω in world axes [rad/s], to rounding
Eigen::Vector3d angular_velocity(const Eigen::Matrix3d& R, const Eigen::Matrix3d& I_body_inv,
                                 const Eigen::Vector3d& L);

}  // namespace momentum
