#pragma once
/// @file
/// One body with three equal moments, which is no ball, over one floor, for the library's
/// simulation of contacts. It needs no queue, no pairs and no elliptic functions: a page that
/// throws a die has no room for them.

#include <cstdint>
#include <limits>
#include <vector>

#include "tumble/contact/contact_simulation.hpp"

namespace contact_chapter {

using namespace tumble;

/// The flight of such a body: a parabola, and a steady turning.
class SteadyFlight {
 public:
  /// @param start at the time t0 [s]
  SteadyFlight(const RigidBody<>& body, const RigidBodyState<>& start, const Vec3& gravity,
               double t0)
      : mass_(body.mass()),
        L_(start.L),
        omega_(start.L / body.I_body()(0, 0)),
        centre_{start.x, start.P / body.mass(), gravity},
        rotation_(start.q, omega_),
        t0_(t0) {}

  Derived<> at(double t) const {
    return {centre_.at(t - t0_), to_matrix(rotation_.at(t - t0_)), velocity(t), omega_};
  }
  RigidBodyState<> state(double t) const {
    return {centre_.at(t - t0_), rotation_.at(t - t0_).normalized(), mass_ * velocity(t), L_};
  }
  bool is_still() const { return centre_.v.isZero(0) && centre_.a.isZero(0) && L_.isZero(0); }
  Vec3 acceleration() const { return centre_.a; }
  double most_spin() const { return omega_.norm(); }
  double most_angular_acceleration() const { return 0; }
  double begin() const { return t0_; }

 private:
  Vec3 velocity(double t) const { return centre_.v + (t - t0_) * centre_.a; }

  double mass_;
  Vec3 L_, omega_;
  collide::Parabola centre_;
  tumble::detail::UniformRotation rotation_;
  double t0_;
};

/// What tumble::contact::detail::ContactSimulation asks: which impact comes next.
class OneBodyEvents {
 public:
  /// @param scene of one body and one floor
  OneBodyEvents(const contact::ContactScene& scene, double tolerance)
      : scene_(scene),
        tolerance_(tolerance),
        flight_(scene.body(0).body, scene.body(0).start, scene.gravity, 0) {}

  int size() const { return 1; }
  std::int64_t queries() const { return queries_; }
  RigidBodyState<> state(int, double t) const { return flight_.state(t); }
  bool is_ball(int) const { return false; }
  double tolerance(int) const { return tolerance_; }
  double window() const { return std::numeric_limits<double>::infinity(); }
  void begin_window(double, double end) { end_ = end; }

  bool next() {
    if (all_rest()) return false;
    if (slides_) {
      event_ = {0, -1, -1, 0, 0, {true, stops_}};
      return stops_ <= end_;
    }
    event_ = {0,
              -1,
              0,
              0,
              0,
              collide::first_meeting(collide::Moving<SteadyFlight>{scene_.body(0).shape, flight_},
                                     scene_.wall(0), flight_.begin(), end_, tolerance_)};
    queries_ += event_.meeting.queries;
    return event_.meeting.found;
  }
  const contact::detail::ContactEvent& event() const { return event_; }

  void fly(int, const RigidBodyState<>& state, double t) {
    flight_ = SteadyFlight(scene_.body(0).body, state, scene_.gravity, t);
    slides_ = false;
  }
  void support(int, const RigidBodyState<>& state, double t, int, const Vec3& acceleration,
               double stops) {
    flight_ = SteadyFlight(scene_.body(0).body, state, acceleration, t);
    slides_ = true;
    stops_ = stops;
  }
  bool all_rest() const { return flight_.is_still(); }

 private:
  const contact::ContactScene& scene_;
  double tolerance_, end_ = 0, stops_ = 0;
  bool slides_ = false;  // or rests, on the floor
  SteadyFlight flight_;
  contact::detail::ContactEvent event_{};
  std::int64_t queries_ = 0;
};

}  // namespace contact_chapter
