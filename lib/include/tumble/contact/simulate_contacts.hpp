#pragma once
/// @file
/// Bodies that fly and hit each other, floors and walls: from impact to impact, each flight in
/// closed form, each impact at its own time.
///
/// Source of the scheme: Mirtich, "Impulse-based Dynamic Simulation of Rigid Body Systems", PhD
/// thesis, Berkeley (1996), §2.

#include "tumble/contact/contact_events.hpp"
#include "tumble/contact/rest.hpp"

namespace tumble::contact {

/// @addtogroup contact
/// @{

/// How long, and how exactly.
struct ContactSettings {
  double until;               ///< from t = 0 on [s]
  double tolerance = 1e-11;   ///< at which distance bodies touch [m]
  int most_impacts = 100000;  ///< after so many contacts the run ends, and says so
};

/// @}

}  // namespace tumble::contact

namespace tumble::contact::detail {

/// One run.
class ContactSimulation {
 public:
  ContactSimulation(const ContactScene& scene, const ContactSettings& settings)
      : scene_(scene), settings_(settings), events_(scene, settings.tolerance) {
    for (int i = 0; i < events_.size(); ++i) {
      run_.flights.push_back({{0, scene.body(i).start, false}});
      run_.rest_since.push_back(std::numeric_limits<double>::infinity());
      first_speed_.push_back(0);
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
  /// Of the points of a contact, along its normal.
  struct Speeds {
    Vec3 normal;
    double coming;   ///< the fastest before the impulses [m/s]
    double parting;  ///< the slowest after them [m/s]
  };

  double& first_speed(int i) { return first_speed_[static_cast<std::size_t>(i)]; }
  double& rest_since(int i) { return run_.rest_since[static_cast<std::size_t>(i)]; }

  double energy_at(double t) const {
    double sum = 0;
    for (int i = 0; i < events_.size(); ++i) {
      const RigidBodyState<> state = events_.state(i, t);
      const RigidBody<>& body = scene_.body(i).body;
      sum += kinetic_energy(body, state) - body.mass() * scene_.gravity.dot(state.x);
    }
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
    const auto impulses = collide_at_points(a, second, points, {normal, scene_.e, scene_.mu});
    for (const PointImpulse& impulse : impulses) record(event, impulse, normal, a.state.x);
    const double parting = least_parting(a, second, points, normal);
    fly_on(event.body, a.state, coming);
    if (b) fly_on(event.other, b->state, coming);
    settle(event, a, {normal, coming, parting});
    if (++handled_ >= settings_.most_impacts && run_.ending == Ending::time)
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
    first_speed(i) = std::max(first_speed(i), coming);
    run_.flights[static_cast<std::size_t>(i)].push_back({run_.t, state, false});
    events_.fly(i, state, run_.t);
  }

  /// After an impact: whether the bodies stay in touch, and whether the first one is at rest.
  void settle(const ContactEvent& event, const Colliding& a, const Speeds& speeds) {
    const collide::Convex& shape = scene_.body(event.body).shape;
    Aftermath after{speeds.coming,
                    speeds.parting,
                    first_speed(event.body),
                    0,
                    scene_.e,
                    events_.tolerance(event.body)};
    if (event.wall >= 0) after.pull = -speeds.normal.dot(scene_.gravity);
    if (!stays(after, shape.points().size() == 1)) return;
    if (event.wall >= 0 && is_at_rest(a, shape, speeds.normal, scene_.gravity, scene_.mu))
      return rest(event.body, a, run_.t + time_to_rest(after));
    run_.ending = Ending::lasting_contact;
    run_.undecided = event.body;
  }

  void rest(int i, const Colliding& a, double since) {
    RigidBodyState<> still = a.state;
    run_.energy.settled -= kinetic_energy(a.body, a.state);
    still.P = still.L = Vec3::Zero();
    rest_since(i) = since;
    first_speed(i) = 0;
    run_.flights[static_cast<std::size_t>(i)].back() = {run_.t, still, true};
    events_.rest(i, still, run_.t);
    if (events_.all_rest()) run_.ending = Ending::all_at_rest;
  }

  const ContactScene& scene_;
  ContactSettings settings_;
  ContactEvents events_;
  ContactRun run_;
  std::vector<double> first_speed_;
  int handled_ = 0;
};

}  // namespace tumble::contact::detail

namespace tumble::contact {

/// @addtogroup contact
/// @{

/// All impacts of the bodies from t = 0 on, in the order of time.
///
/// Between impacts no error grows: flights are closed forms. Each impact is found to the tolerance.
/// But each also makes the error that there was larger (of a ball that meets another one, by about
/// the flight over the radius): after some dozens, places of bodies that hit each other mean
/// nothing.
/// @throws std::invalid_argument for a scene that is none (see ContactScene::require_valid()), or
///         settings that are none
inline ContactRun simulate_contacts(const ContactScene& scene, const ContactSettings& settings) {
  require(settings.until >= 0 && std::isfinite(settings.until),
          "contacts: until = ", settings.until, " s is not finite and ≥ 0");
  require(settings.tolerance > 0, "contacts: the tolerance ", settings.tolerance,
          " m is not positive");
  require(settings.most_impacts > 0, "contacts: at most ", settings.most_impacts, " impacts");
  scene.require_valid(settings.tolerance);
  return detail::ContactSimulation(scene, settings).run();
}

/// @}

}  // namespace tumble::contact
