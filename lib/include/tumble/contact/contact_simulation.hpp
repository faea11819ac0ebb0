#pragma once
/// @file
/// A run of bodies that hit each other: takes the next impact, changes momenta, and asks who stays
/// in touch.

#include "tumble/contact/hops.hpp"
#include "tumble/contact/rest.hpp"
#include "tumble/contact/run_recorder.hpp"
#include "tumble/contact/slide.hpp"
#include "tumble/contact/thresholds.hpp"

namespace tumble::contact::detail {

/// One run.
/// @tparam Events finds the next impact: ContactEvents, or what does the same for less
template <class Events>
class ContactSimulation {
 public:
  ContactSimulation(const ContactScene& scene, const ContactSettings& settings)
      : scene_(scene),
        settings_(settings),
        thresholds_(scene, settings),
        events_(scene, settings.tolerance),
        recorder_(scene),
        landings_(scene.bodies.size()) {}

  ContactRun run() {
    while (run_.t < settings_.until && run_.ending == Ending::time) {
      const double end = std::min(settings_.until, run_.t + events_.window());
      events_.begin_window(run_.t, end);
      while (run_.ending == Ending::time && events_.next()) handle(events_.event());
      if (run_.ending == Ending::time) run_.t = end;
    }
    run_.queries = events_.queries();
    for (int i = 0; i < events_.size(); ++i) recorder_.end(i, events_.state(i, run_.t));
    return std::move(run_);
  }

 private:
  Landings& landings(int i) { return landings_[static_cast<std::size_t>(i)]; }
  Colliding colliding(int i, double t) const { return {scene_.body(i).body, events_.state(i, t)}; }

  void handle(const ContactEvent& event) {
    run_.t = event.t();
    if (event.is_end_of_slide())
      stop(event.body);
    else
      impact(event);
    if (++handled_ >= settings_.max_impacts && run_.ending == Ending::time)
      run_.ending = Ending::too_many_events;
  }

  void impact(const ContactEvent& event) {
    Colliding a = colliding(event.body, event.t());
    std::optional<Colliding> b;
    if (event.other >= 0) b.emplace(colliding(event.other, event.t()));
    Colliding* second = b ? &*b : nullptr;
    const Vec3 normal = -event.meeting.distance.normal;
    const auto& points = event.meeting.points;
    const double coming = -least_parting(a, second, points, normal);
    const double lowest = lowest_hop(event.body, normal);
    if (coming > 2 * lowest) landings(event.body).skids = false;
    if (b) landings(event.other).skids = false;
    const bool raised = may_hop(event, normal) && lowest > scene_.e * coming;
    const double e = raised ? std::min(1., lowest / coming) : scene_.e;
    for (const PointImpulse& impulse : collide_at_points(a, second, points, {normal, e, scene_.mu}))
      recorder_.impact(event, impulse, normal, a.state.x);
    count(event.body, a.state, coming, event.wall >= 0);
    if (b) {
      count(event.other, b->state, coming, false);
      fly_on(event.other, b->state, false);
    }
    const double parting = raised ? 0 : least_parting(a, second, points, normal);
    if (settles(event, a, {normal, coming, parting, landings(event.body).fastest})) return;
    const bool lifted = may_hop(event, normal) && lift_to_hop(a, points, normal, lowest);
    fly_on(event.body, a.state, raised || lifted);
    // It neither hops nor lies; or between several others it is hit ever faster.
    const bool is_endless = landings(event.body).are_endless(scene_.e, raised) ||
                            landings(event.body).stay_close(scene_.e) ||
                            (b && landings(event.other).stay_close(scene_.e));
    if (is_endless && run_.ending == Ending::time) recorder_.end_undecided(event.body);
  }

  /// Off a wall bounces die away to rest, a slide or hops; with e = 1, if friction slows them.
  void count(int i, const RigidBodyState<>& state, double coming, bool on_wall) {
    recorder_.rest_since(i) = std::numeric_limits<double>::infinity();
    if (!on_wall || scene_.e == 1)
      landings(i).count_close(coming <= (on_wall ? slow(i) : fall_in_touch(i)));
    landings(i).count(coming, lowest_hop(i, -scene_.gravity.normalized()),
                      kinetic_energy(scene_.body(i).body, state));
  }

  void fly_on(int i, const RigidBodyState<>& state, bool is_hop) {
    recorder_.go_on(i, {run_.t, state, -1, Vec3::Zero(), is_hop});
    events_.fly(i, state, run_.t);
  }

  double pull(const Vec3& normal) const { return thresholds_.pull(normal); }
  double lowest_hop(int i, const Vec3& normal) const { return thresholds_.lowest_hop(i, normal); }
  double fall_in_touch(int i) const { return thresholds_.fall(events_.tolerance(i)); }
  double slow(int i) const { return 1e-3 * fall_in_touch(i); }
  Stillness stillness(int i) { return thresholds_.stillness(i, events_.tolerance(i), landings(i)); }

  /// Whether this body's contact with this wall is a train of hops where it lasts.
  bool may_hop(const ContactEvent& event, const Vec3& normal) {
    return event.wall >= 0 && pull(normal) > 0 && scene_.e < 1 &&
           (!events_.is_ball(event.body) || landings(event.body).skids);
  }

  /// After an impact: whether the first body is carried from now on, or nobody can tell.
  bool settles(const ContactEvent& event, const Colliding& a, const Aftermath& after) {
    const Vec3& normal = after.normal;
    if (event.wall >= 0 && pull(normal) > 0)
      return events_.is_ball(event.body) ? ball_settles(event, a, after)
                                         : lies_on(event, a, normal, after.parting);
    // What falls so slowly has not fallen farther than bodies touch: one lies on the other.
    if (!stays(after) && (event.wall >= 0 || after.coming > slow(event.body))) return false;
    fly_on(event.body, a.state, false);
    recorder_.end_undecided(event.body);
    return true;
  }

  /// Lets a body that has come down on a face slide or rest there.
  /// @param parting the speed of what bounces are left, which are over at once [m/s]
  bool lies_on(const ContactEvent& event, const Colliding& a, const Vec3& normal, double parting) {
    const collide::Convex& shape = scene_.body(event.body).shape;
    const Stillness still = stillness(event.body);
    if (const auto slide = slide_of(a, shape, normal, scene_.gravity, scene_.mu, still)) {
      support(event, a, slide->state, slide->acceleration, run_.t + slide->stops);
      return true;
    }
    if (!is_at_rest(a, shape, normal, scene_.gravity, scene_.mu, still)) return false;
    rest(event, a, run_.t + time_to_rest(parting, pull(normal), scene_.e));
    return true;
  }

  /// A slide has come to its end: friction holds the body, or it slides back.
  void stop(int i) {
    Colliding a = colliding(i, run_.t);
    a.state.P = Vec3::Zero();
    const int wall = recorder_.flight(i).on_wall;
    if (!lies_on({i, -1, wall, 0, 0, {}}, a, scene_.wall(wall).normal, 0))
      fly_on(i, a.state, false);
  }

  /// A ball that slides hops, too: in each hop friction slows its slip, until it rolls.
  bool ball_settles(const ContactEvent& event, const Colliding& a, const Aftermath& after) {
    const Vec3& normal = after.normal;
    bool& skids = landings(event.body).skids;
    // Bounces of a millionth of the tolerance are over before the next look for meetings.
    const double lowest = hop_speed(pull(normal), events_.tolerance(event.body));
    const bool faded = scene_.e < 1 && (has_faded(after) || after.parting <= 1e-3 * lowest);
    const bool stood = after.first <= lowest;  // and fell by less than places have digits for
    if (!skids && !faded && !stood) return false;
    const collide::Convex& shape = scene_.body(event.body).shape;
    const bool rests =
        is_at_rest(a, shape, normal, scene_.gravity, scene_.mu, stillness(event.body));
    skids = !rests && !rolls_on(a, shape.radius(), normal, scene_.gravity, scene_.mu);
    if (skids) return false;
    if (rests)
      rest(event, a, run_.t + time_to_rest(after.parting, pull(normal), scene_.e));
    else
      support(event, a, along_ground(a.state, normal));
    return true;
  }

  void rest(const ContactEvent& event, const Colliding& a, double since) {
    RigidBodyState<> still = a.state;
    still.P = still.L = Vec3::Zero();
    support(event, a, still);
    recorder_.rest_since(event.body) = std::min(since, settings_.until);
    if (events_.all_rest()) run_.ending = Ending::all_at_rest;
  }

  /// The floor carries the body from now on.
  void support(const ContactEvent& event, const Colliding& a, const RigidBodyState<>& state,
               const Vec3& acceleration = Vec3::Zero(),
               double stops = std::numeric_limits<double>::infinity()) {
    recorder_.forget(a, state);
    landings(event.body) = {.close = landings(event.body).close};
    recorder_.go_on(event.body, {run_.t, state, event.wall, acceleration});
    events_.support(event.body, state, run_.t, event.wall, acceleration, stops);
  }

  const ContactScene& scene_;
  ContactSettings settings_;
  Thresholds thresholds_;
  Events events_;
  RunRecorder recorder_;
  ContactRun& run_ = recorder_.run();
  std::vector<Landings> landings_;
  int handled_ = 0;
};

}  // namespace tumble::contact::detail
