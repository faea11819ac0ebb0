#pragma once
/// @file
/// A run of bodies that hit each other: takes the next impact, changes momenta, and asks who stays
/// in touch.

#include "tumble/contact/contact_events.hpp"
#include "tumble/contact/hops.hpp"
#include "tumble/contact/rest.hpp"

namespace tumble::contact::detail {

/// One run.
/// @tparam Events finds the next impact: ContactEvents, or what does the same for less
template <class Events>
class ContactSimulation {
 public:
  ContactSimulation(const ContactScene& scene, const ContactSettings& settings)
      : scene_(scene), settings_(settings), events_(scene, settings.tolerance) {
    for (int i = 0; i < events_.size(); ++i) {
      run_.flights.push_back({{0, scene.body(i).start, -1}});
      run_.rest_since.push_back(std::numeric_limits<double>::infinity());
      landings_.push_back({});
    }
    run_.energy.start = energy_at(0);
  }

  ContactRun run() {
    while (run_.t < settings_.until && run_.ending == Ending::time) {
      const double end = std::min(settings_.until, run_.t + events_.window());
      events_.begin_window(run_.t, end);
      while (run_.ending == Ending::time && events_.next()) handle(events_.event());
      if (run_.ending == Ending::time) run_.t = end;
    }
    run_.queries = events_.queries();
    run_.energy.end = energy_at(run_.t);
    return std::move(run_);
  }

 private:
  Landings& landings(int i) { return landings_[static_cast<std::size_t>(i)]; }
  FlightStart& flight(int i) { return run_.flights[static_cast<std::size_t>(i)].back(); }
  double& rest_since(int i) { return run_.rest_since[static_cast<std::size_t>(i)]; }

  double energy_at(double t) const {
    double sum = 0;
    for (int i = 0; i < events_.size(); ++i)
      sum += energy_in(scene_.gravity, scene_.body(i).body, events_.state(i, t));
    return sum;
  }

  Colliding colliding(int i, double t) const { return {scene_.body(i).body, events_.state(i, t)}; }

  void handle(const ContactEvent& event) {
    run_.t = event.t();
    Colliding a = colliding(event.body, event.t());
    std::optional<Colliding> b;
    if (event.other >= 0) b.emplace(colliding(event.other, event.t()));
    Colliding* second = b ? &*b : nullptr;
    const Vec3 normal = -event.meeting.distance.normal;
    const auto& points = event.meeting.points;
    const double coming = -least_parting(a, second, points, normal);
    if (coming > 2 * lowest_hop(event.body, normal)) landings(event.body).skids = false;
    if (b) landings(event.other).skids = false;
    const auto impulses = collide_at_points(
        a, second, points, {normal, restitution(event, normal, coming), scene_.mu});
    for (const PointImpulse& impulse : impulses) record(event, impulse, normal, a.state.x);
    const bool is_hop =
        hops(event, normal) && lift_to_hop(a, points, normal, lowest_hop(event.body, normal));
    const double parting = least_parting(a, second, points, normal);
    fly_on(event.body, a.state, coming);
    flight(event.body).is_hop = is_hop;
    if (b) fly_on(event.other, b->state, coming);
    settle(event, a, {normal, coming, parting});
    // Between several others its impacts can follow each other ever faster.
    if (run_.ending == Ending::time && landings(event.body).are_endless(scene_.e))
      end_undecided(event.body);
    if (++handled_ >= settings_.max_impacts && run_.ending == Ending::time)
      run_.ending = Ending::too_many_events;
  }

  void record(const ContactEvent& event, const PointImpulse& impulse, const Vec3& normal,
              const Vec3& x) {
    const ImpactResult& result = impulse.result;
    run_.impacts.push_back({event.t(), event.body, event.other, event.wall, x + impulse.arm, normal,
                            result.impulse, result.energy, result.slip, result.jammed});
    run_.energy.impacts += result.energy;
  }

  void fly_on(int i, const RigidBodyState<>& state, double coming) {
    rest_since(i) = std::numeric_limits<double>::infinity();
    landings(i).count(coming, lowest_hop(i, -scene_.gravity.normalized()),
                      kinetic_energy(scene_.body(i).body, state));
    run_.flights[static_cast<std::size_t>(i)].push_back({run_.t, state, -1});
    events_.fly(i, state, run_.t);
  }

  bool is_ball(int i) const { return events_.is_ball(i); }
  double pull(const Vec3& normal) const { return -normal.dot(scene_.gravity); }

  /// The speed of the lowest hops of a body.
  double lowest_hop(int i, const Vec3& normal) const {
    return hop_speed(std::max(0., pull(normal)), settings_.hop * scene_.body(i).shape.reach());
  }
  /// What is at rest has energy for some hops, and along the ground the speed of rounding, or one
  /// with which it comes no farther than bodies touch. On a line of what is round nothing tips: its
  /// neighbours are nearly as low.
  bool comes_to_rest(int i, const Colliding& a, const Vec3& normal, const Aftermath& after) {
    const double speed = std::max(1e-9 * after.first, events_.tolerance(i) / settings_.until);
    return is_at_rest(a, scene_.body(i).shape, normal, scene_.gravity, scene_.mu,
                      {10 * settings_.hop, speed, landings(i).have_ended() ? 2e-3 : 1e-4});
  }

  /// Whether this body's contact with this wall is a train of hops where it lasts.
  bool hops(const ContactEvent& event, const Vec3& normal) {
    return event.wall >= 0 && pull(normal) > 0 && scene_.e < 1 &&
           (!is_ball(event.body) || landings(event.body).skids);
  }

  /// That of the scene, or as much more as a hop takes.
  double restitution(const ContactEvent& event, const Vec3& normal, double coming) {
    if (!hops(event, normal)) return scene_.e;
    return std::max(scene_.e, std::min(1., lowest_hop(event.body, normal) / coming));
  }

  /// After an impact: whether the first body goes on in touch.
  void settle(const ContactEvent& event, const Colliding& a, const Speeds& speeds) {
    const Aftermath after{speeds.coming, speeds.parting, landings(event.body).fastest};
    if (event.wall < 0 || !(pull(speeds.normal) > 0)) {
      if (stays(after)) end_undecided(event.body);
    } else if (is_ball(event.body)) {
      settle_ball(event, a, speeds.normal, after);
    } else if (comes_to_rest(event.body, a, speeds.normal, after)) {
      rest(event, a, run_.t + time_to_rest(after, pull(speeds.normal), scene_.e));
    } else if (landings(event.body).have_ended()) {
      end_undecided(event.body);
    }
  }

  void settle_ball(const ContactEvent& event, const Colliding& a, const Vec3& normal,
                   const Aftermath& after) {
    // Bounces of a millionth of the tolerance are over before the next look for meetings.
    const double lowest = hop_speed(pull(normal), events_.tolerance(event.body));
    const bool faded = scene_.e < 1 && (has_faded(after) || after.parting <= 1e-3 * lowest);
    const bool stood = after.first <= lowest;  // and fell by less than places have digits for
    if (!landings(event.body).skids && !faded && !stood) return;
    if (comes_to_rest(event.body, a, normal, after))
      rest(event, a, run_.t + time_to_rest(after, pull(normal), scene_.e));
    else if (rolls_on(a, scene_.body(event.body).shape.radius(), normal, scene_.gravity, scene_.mu))
      roll(event, a, normal);
    else
      skid(event, a, normal);
  }

  /// A ball that slides on hops, too: in each hop friction slows its slip, until it rolls.
  void skid(const ContactEvent& event, Colliding ball, const Vec3& normal) {
    if (landings(event.body).skids) return;
    landings(event.body).skids = true;
    FlightStart& now = flight(event.body);
    now.is_hop = lift_to_hop(ball, event.meeting.points, normal, lowest_hop(event.body, normal));
    now.state = ball.state;
    events_.fly(event.body, ball.state, run_.t);
  }

  void end_undecided(int i) {
    run_.ending = Ending::lasting_contact;
    run_.undecided = i;
  }

  void rest(const ContactEvent& event, const Colliding& a, double since) {
    RigidBodyState<> still = a.state;
    still.P = still.L = Vec3::Zero();
    rest_since(event.body) = since;
    support(event, a, still);
    if (events_.all_rest()) run_.ending = Ending::all_at_rest;
  }

  void roll(const ContactEvent& event, const Colliding& a, const Vec3& normal) {
    RigidBodyState<> rolling = a.state;
    rolling.P -= normal.dot(rolling.P) * normal;
    support(event, a, rolling);
  }

  /// The floor carries the body from now on.
  void support(const ContactEvent& event, const Colliding& a, const RigidBodyState<>& state) {
    run_.energy.settled += kinetic_energy(a.body, state) - kinetic_energy(a.body, a.state);
    landings(event.body) = {};
    flight(event.body) = {run_.t, state, event.wall};
    events_.support(event.body, state, run_.t, event.wall);
  }

  const ContactScene& scene_;
  ContactSettings settings_;
  Events events_;
  ContactRun run_;
  std::vector<Landings> landings_;
  int handled_ = 0;
};

}  // namespace tumble::contact::detail
