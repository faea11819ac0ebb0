#pragma once
/// @file
/// What is measured: bodies that turn, and the methods, ours and others', that say where to. Plain
/// enough for a peer that is no C++20.

#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "project/bench/plain_types.hpp"
#include "project/bench/speed_against_error.hpp"

namespace tumble::bench {

/// How a body turns at one moment.
struct Spin {
  Quat q;      ///< body → world
  Vec3 omega;  ///< [rad/s], body coordinates
};

/// A body with its axes along its principal ones, and how it starts.
struct Body {
  Vec3 moments;  ///< [kg m²]
  Spin start;
};

/// A constant force at a point of the body.
struct Push {
  Vec3 force = Vec3::Zero();   ///< [N], world coordinates
  Vec3 p_body = Vec3::Zero();  ///< [m], body coordinates
};

/// Bodies, each about a fixed centre of its own, and what pushes each: of that only the torque is
/// left, p × F.
struct Scene {
  std::vector<Body> bodies;
  Push push = {};

  bool free() const { return push.force.isZero(0); }
};

/// One body, and the truth about its end.
struct Problem {
  std::string name, title;
  Scene scene;
  double duration;  ///< [s]
  Quat end;         ///< exact
  double
      condition;  ///< an error on the way, of q or relative of ω, has grown by so much at the end

  const Body& body() const { return scene.bodies.front(); }
};

/// One integration, prepared: what is not part of it has been done.
using Run = std::function<Quat()>;

/// A way from a problem's start to its end.
struct Method {
  std::string software, name;
  Knob knob;
  std::function<Run(const Problem&, double setting)> prepare;  ///< no run: not for this problem
  /// What ours promise of their best error, in units of condition · ε: that many roundings.
  double roundings = std::numeric_limits<double>::infinity();
};

/// Bodies that are moved on by steps of one length.
class Simulation {
 public:
  virtual ~Simulation() = default;
  virtual void restart() = 0;
  virtual void advance(int steps) = 0;
  virtual Spin spin(std::size_t body) const = 0;  ///< NaN if the simulation has broken down
};

/// A method of fixed steps, or an engine for games and robots, for any number of bodies.
struct Stepper {
  std::string software, name;
  std::function<std::unique_ptr<Simulation>(const Scene&, double h)> make;  ///< none: not for these
  double roundings = std::numeric_limits<double>::infinity();               ///< as of a Method
};

struct Contestants {
  std::vector<Method> methods;
  std::vector<Stepper> steppers;
};

/// The library's; one more is one more line there.
Contestants own_methods();
/// Those of other software that was found when this was configured: a loadable module each.
void add_peers(Contestants& contestants);

}  // namespace tumble::bench

/// What each of those modules defines.
extern "C" void tumble_add_peer(tumble::bench::Contestants& contestants);
