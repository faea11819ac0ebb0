#pragma once
/// @file
/// End states of three hard motions, to more digits than a double has: from Taylor series of
/// (q, ω_body) in 60-digit arithmetic, order 66 for the first two, 50 for the third; with a second
/// order (44) and other steps they agree to 4e-50 rad, the third to 2e-59.

#include <cmath>

#include "tumble/body/derived.hpp"
#include "tumble/body/forces.hpp"

namespace tumble::reference {

/// A body that turns about its centre, how it starts, and where it is at the end.
struct Motion {
  Mat3 I_body;
  Quat q0;
  Vec3 omega_body0;  ///< [rad/s]
  double duration;   ///< [s]
  Quat q_end;
  Vec3 L_end;           ///< world
  Vec3 omega_body_end;  ///< [rad/s]
};

/// The separatrix problem: free, started 5e-4 rad from a steady spin about the middle axis. Its
/// condition number is 2.7e6: one rounding error at the start is 1e-10 rad at the end.
inline const Motion free_body{
    Vec3(1, 2, 3).asDiagonal(),
    Quat(1, 0, 0, 0),
    Vec3(1e-3, 2, 1e-3),
    100,
    Quat(-0.07178909921262347579368173045620797, 0.49189772662808386053205562354631112,
         0.041722294314205268571177558719647928, 0.86668460349167494386853056572186419),
    Vec3(0.0010000000000000000208166817117216851, 4, 0.0030000000000000000624500451351650554),
    Vec3(-0.33149311565703614024692255394546538, -1.9723370184306714626563909023290407,
         0.19138938181711380100586928740319163)};

/// The Lagrange top about its pivot, tilted by ½ rad and spinning at 40 rad/s, under TopTorque.
inline const Motion top{
    Vec3(1, 1, 0.5).asDiagonal(),
    Quat(std::cos(0.25), std::sin(0.25), 0, 0),
    Vec3(0.25, 0, 40),
    10,
    Quat(0.60632751143978143576466507438214405, -0.24316993627928016479424993722183917,
         -0.069505036537402223783092452868375001, -0.75392597836731088355152998544703982),
    Vec3(5.3230411533709642203968731421797745, 7.9826279310185569798775119411118425,
         17.551651237807453941779908963893403),
    Vec3(0.10694872778998892406508747255627335, -0.3257897309777054612566485519059962, 40)};

/// A heavy body about a fixed point, of which no closed form is known: three moments, and its
/// centre of mass on none of the axes. Under heavy_force, of which the fixed point leaves the
/// torque.
inline const Motion heavy{
    Vec3(1, 2, 3).asDiagonal(),
    Quat(std::cos(0.25), std::sin(0.25), 0, 0),
    Vec3(0.3, -2, 5),
    10,
    Quat(-0.076589873022445239373649974156550316, 0.36502392592671638741881166857785391,
         0.17171180500162739922513344950131489, 0.91181499267918153187240027555953602),
    Vec3(8.1109590020104752590195109158264836, 6.4961851671458045085856819777741125,
         11.246036273938778315924925395875578),
    Vec3(1.8345973480598501998349531130568175, -0.49724669105737417581130157144245199,
         5.0564221542323828684159781865740663)};

/// What pushes heavy.
inline const ForceAtBodyPoint heavy_force{{0, 0, -5}, {0.6, 0, 0.8}};

/// The torque of the top's weight about its pivot: 5 N m × (axis × down).
struct TopTorque {
  template <class T>
  Wrench<T> operator()(T, const RigidBody<T>&, const Derived<T>& now) const {
    const Vector3<T> down(T(0), T(0), T(-1));
    return {Vector3<T>::Zero(), T(5) * Vector3<T>(now.R.col(2)).cross(down)};
  }
};

/// How a motion starts, as a state of the body.
inline RigidBodyState<double> start(const Motion& motion) {
  return {Vec3::Zero(), motion.q0, Vec3::Zero(),
          motion.q0 * Vec3(motion.I_body * motion.omega_body0)};
}

}  // namespace tumble::reference
