#pragma once
/// @file
/// What is measured: bodies that hit each other, floors and walls, and the engines that move them.
/// Plain enough for a peer that is no C++20.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "project/bench/plain_types.hpp"

namespace tumble::bench {

/// Where a body is, and how it moves.
struct Motion {
  Vec3 x = Vec3::Zero();      ///< [m]
  Vec3 v = Vec3::Zero();      ///< [m/s]
  Quat q = Quat::Identity();  ///< body → world
  Vec3 omega = Vec3::Zero();  ///< [rad/s], world coordinates
};

enum class Form { ball, box };

/// A homogeneous ball or box; its centre is the origin of body coordinates.
struct Body {
  Form form;
  Vec3 size;  ///< diameters, or full edges [m]
  double mass;
  Vec3 moments;  ///< [kg m²]
  Motion start;

  double radius() const { return size.x() / 2; }
  /// Of a box, i = 0 … 7 [m], body coordinates.
  Vec3 corner(int i) const {
    const Vec3 signs(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    return signs.cwiseProduct(size) / 2;
  }
  /// Of the ball around the centre that holds it [m].
  double reach() const { return form == Form::ball ? radius() : size.norm() / 2; }
};

/// What is below a plane, such as a floor.
struct Wall {
  Vec3 point;   ///< on the plane [m]
  Vec3 normal;  ///< unit, out of it
};

/// Bodies, floors and walls. Where `planar` is set, all of it happens in the plane of x and z.
struct Scene {
  std::vector<Body> bodies;
  std::vector<Wall> walls;
  Vec3 gravity = Vec3::Zero();  ///< [m/s²]
  double e = 1;                 ///< restitution of every contact
  double mu = 0;                ///< friction of every contact
  bool planar = false;
};

/// An engine that moves the bodies of a scene on by steps of one length.
class Simulation {
 public:
  virtual ~Simulation() = default;
  virtual void restart() = 0;
  virtual void advance(int steps) = 0;
  virtual Motion motion(std::size_t body) const = 0;
};

/// A simulation that is built anew at each start, so that nothing is left of the last run.
template <class World>
class Fresh : public Simulation {
 public:
  explicit Fresh(std::function<std::unique_ptr<World>()> make) : make_(std::move(make)) {}
  void restart() override {
    world_.reset();
    world_ = make_();
  }
  void advance(int steps) override { world_->advance(steps); }
  Motion motion(std::size_t body) const override { return world_->motion(body); }

 private:
  std::function<std::unique_ptr<World>()> make_;
  std::unique_ptr<World> world_;
};

/// A way to make such engines.
struct Stepper {
  std::string software, name;
  std::function<std::unique_ptr<Simulation>(const Scene&, double h)> make;  ///< none: not for it
};

/// Those of other software that was found when this was configured: a loadable module each.
void add_peers(std::vector<Stepper>& steppers);

}  // namespace tumble::bench

/// What each of those modules defines.
extern "C" void tumble_add_peer(std::vector<tumble::bench::Stepper>& steppers);
