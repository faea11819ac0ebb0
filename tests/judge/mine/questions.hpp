#pragma once
/// @file
/// What the judge asks the engine that is made of a student's functions. Both sides know these
/// types; the contracts' own cross the pipe beside them.

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace tumble::judge::mine {

/// The first number of every question to the engine.
enum class Topic { mass, run, top, choose, drift };

/// What takes the steps: 1.3, 1.4 or 1.5 on 9.4, or the whole of 9.5.
enum class Method { euler, midpoint, rk4, simulate };

/// A body and what pushes it: its weight, and at one of its points a constant force, and a spring
/// without a length of its own to a point of the world.
struct Setting {
  double mass = 1;                                        ///< [kg]
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Identity();  ///< body coordinates [kg m²]
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();      ///< [m/s²]
  double stiffness = 0;                                   ///< [N/m]; 0: there is no spring
  Eigen::Vector3d p_body = Eigen::Vector3d::Zero();       ///< the point of the body [m]
  Eigen::Vector3d anchor = Eigen::Vector3d::Zero();       ///< where the spring's other end is [m]
  Eigen::Vector3d pull = Eigen::Vector3d::Zero();         ///< the constant force [N]
};

/// x, q as (w, x, y, z), P, L.
using Numbers = Eigen::Matrix<double, 13, 1>;

struct RunQuestion {
  Setting setting;
  Numbers start;
  double duration = 0;  ///< [s]
  Method method = Method::rk4;
  int steps = 1;    ///< a multiple of `samples`
  int repeats = 1;  ///< how often all of it is done, for the clock
  int samples = 1;  ///< how many states are wanted beside the start
};

struct RunAnswer {
  int evaluations = 0;          ///< of the wrench, in one run
  std::vector<Numbers> states;  ///< the start and the samples, the last one at the end
};

/// A die that falls onto a table without friction. The table's top is at z = 0, and the centre is
/// far enough from its sides.
struct DieQuestion {
  double mass = 0;       ///< [kg]
  double edge = 0;       ///< [m]
  double gravity = 0;    ///< downwards [m/s²], positive
  double e = 0;          ///< coefficient of restitution
  double tolerance = 0;  ///< at which distance it touches [m]
  double hop = 0;        ///< with which speed at least a corner leaves if it came as fast [m/s]: so
                         ///< that contact which would last is a train of hops
  Numbers start;         ///< above the table
  double duration = 0;   ///< [s]
  int max_impacts = 0;   ///< after so many it is over
};

struct DieImpact {
  double t = 0;   ///< [s]
  Numbers after;  ///< the state right after it
};

struct DieAnswer {
  std::int64_t queries = 0;  ///< of the distance
  std::vector<DieImpact> impacts;
};

}  // namespace tumble::judge::mine
