#pragma once
/// @file
/// Random scenes of one body: what simulate() is asked, and what it answers is compared with.

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "support/random.hpp"
#include "tumble/body/forces.hpp"
#include "tumble/body/state.hpp"
#include "tumble/mass/principal_axes.hpp"

namespace tumble::test {

/// A push that comes and goes: exp(−((t − centre)/width)²) of a force and of a torque.
struct Pulse {
  double centre, width;  ///< [s]
  Vec3 force, torque;    ///< [N], [N m], world
};

/// A body, how it starts, what pushes it, for how long, and how exactly that is asked.
struct MotionScene {
  std::string body_kind;  ///< "needle", "plate", …
  double mass;            ///< [kg]
  Mat3 I_body;            ///< [kg m²]
  RigidBodyState<> start;
  double t0, t1;  ///< [s]
  double tolerance;
  SteadyForces steady = {};
  std::vector<SpringToWorld> springs = {};
  std::vector<Pulse> pulses = {};
  bool hidden = false;  ///< whether the steady forces are handed over as forces of any kind

  bool any_force() const { return hidden || !springs.empty() || !pulses.empty(); }
  bool turned() const { return !I_body.isDiagonal(0); }
};

/// Makes scenes out of a seed.
class SceneMaker {
 public:
  explicit SceneMaker(std::uint64_t seed) : rng_(seed) {}

  MotionScene scene() {
    const double span = power(0, 3), mass = power(-3, 3), length = power(-2, 2);
    MotionScene s{};
    s.mass = mass;
    moments_ = mass * length * length * shape(s.body_kind);
    s.t0 = rng_.uniform(0, 1) < 0.1 ? power(0, 9) : 0;
    s.t1 = s.t0 + span;
    span_ = s.t1 - s.t0;
    s.tolerance = power(-12, -4);
    const bool turned = rng_.uniform(0, 1) < 0.5;
    frame_ = turned ? to_matrix(rng_.rotation()) : Mat3(Mat3::Identity());
    const Mat3 I = frame_ * moments_.asDiagonal() * frame_.transpose();
    s.I_body = turned ? Mat3((I + I.transpose()) / 2) : I;
    start(s, length);
    forces(s, length);
    return s;
  }

 private:
  double power(double low, double high) { return std::pow(10, rng_.uniform(low, high)); }
  bool chance(double p) { return rng_.uniform(0, 1) < p; }

  /// Principal moments of a body of mass 1 and length 1.
  Vec3 shape(std::string& kind) {
    const double choice = rng_.uniform(0, 1), a = rng_.uniform(0.05, 1), b = rng_.uniform(0.05, 1),
                 c = rng_.uniform(0.05, 1);
    if (choice < 0.3) return kind = "any", Vec3(b + c, a + c, a + b);
    if (choice < 0.45) return kind = "top", Vec3(a + b, a + b, 2 * a);
    if (choice < 0.6) {
      const double off = power(-14, -2);
      return kind = "near-top", Vec3(a + b, (a + b) * (1 + off), 2 * a);
    }
    if (choice < 0.7) return kind = "plate", Vec3(a, b, a + b);
    if (choice < 0.78) return kind = "ball", Vec3(a, a, a);
    if (choice < 0.85) return kind = "near-ball", Vec3(a, a * (1 + power(-12, -3)), a);
    const double thin = power(-7, -1);
    return kind = "needle", Vec3(thin, 1 + thin * rng_.uniform(-0.9, 0.9), 1);
  }

  /// How far the body reaches along its principal axes [m], more or less.
  Vec3 extents(double mass) const {
    const double half = moments_.sum() / 2;
    return ((Vec3::Constant(half) - moments_) / mass).cwiseMax(0).cwiseSqrt();
  }

  void start(MotionScene& s, double length) {
    const double radians = power(-0.5, 3);
    rate_ = radians / span_;
    Vec3 omega = rng_.direction();
    if (chance(0.3)) {  // nearly, or exactly, about an axis
      omega *= chance(0.3) ? 0 : power(-9, -1);
      omega[static_cast<int>(rng_.uniform(0, 3))] += 1;
    }
    s.start.q = rng_.rotation();
    s.start.x = chance(0.2) ? Vec3(Vec3::Zero()) : Vec3(length * power(-2, 2) * rng_.vector());
    s.start.P = chance(0.3) ? Vec3(Vec3::Zero())
                            : Vec3(s.mass * length / span_ * power(-1, 3) * rng_.vector());
    s.start.L = s.start.q * (frame_ * moments_.cwiseProduct(rate_ * omega));
    if (chance(0.1)) s.start.L.setZero();
  }

  /// A point of the body.
  Vec3 point(const MotionScene& s) { return frame_ * extents(s.mass).cwiseProduct(rng_.vector()); }

  void forces(MotionScene& s, double length) {
    const double kinds = rng_.uniform(0, 1);
    if (kinds < 0.12) return;  // free
    const Vec3 weight = chance(0.5) ? Vec3(s.mass * Vec3(0, 0, -9.80665)) : Vec3(Vec3::Zero());
    s.steady.force = weight;
    if (chance(0.6)) pull(s, length);
    if (chance(0.3)) drag(s);
    s.hidden = chance(0.3);
    if (kinds < 0.4) return;
    if (kinds < 0.75)
      for (int i = 0; i < 1 + chance(0.3); ++i) spring(s, length);
    if (kinds > 0.65)
      for (int i = 0; i < 1 + chance(0.3); ++i) pulse(s, length);
  }

  void pull(MotionScene& s, double length) {
    const Vec3 force = s.mass * length * rate_ * rate_ * power(-3, 1) * rng_.vector();
    const bool on_axis = s.body_kind == "top" && chance(0.7);
    const Vec3 p = on_axis ? Vec3(frame_.col(2) * length * rng_.uniform()) : point(s);
    s.steady.force += force;
    s.steady.at_point.push_back({force, p});
  }

  void drag(MotionScene& s) {
    s.steady.linear_drag = s.mass / span_ * power(-1, 1);
    s.steady.angular_drag = moments_.minCoeff() / span_ * power(-1, 1);
  }

  void spring(MotionScene& s, double length) {
    const double rate = power(0, 2.5) / span_;
    const Vec3 p = chance(0.35) ? Vec3(Vec3::Zero()) : point(s);
    const Vec3 anchor = s.start.x + length * power(-1, 1) * rng_.vector();
    const double rest = chance(0.5) ? 0 : length * rng_.uniform(0, 1);
    s.springs.push_back({p, anchor, s.mass * rate * rate, rest});
  }

  void pulse(MotionScene& s, double length) {
    const double width = span_ * power(-3.5, -1);
    const double torque = moments_.minCoeff() * power(-0.5, 1) / span_ / width;
    const double force = s.mass * length * power(-0.5, 1) / span_ / width;
    s.pulses.push_back({rng_.uniform(s.t0 + width, s.t1 - width), width,
                        chance(0.5) ? Vec3(force * rng_.vector()) : Vec3(Vec3::Zero()),
                        torque * rng_.vector()});
  }

  support::Random rng_;
  Vec3 moments_ = Vec3::Zero();
  Mat3 frame_ = Mat3::Identity();
  double span_ = 1, rate_ = 1;
};

/// The scene of a number: the same everywhere.
inline MotionScene motion_scene(std::uint64_t seed) { return SceneMaker(seed).scene(); }

}  // namespace tumble::test
