#pragma once
/// @file
/// What is written down of a run: flights, impacts, and where the energy goes.

#include <limits>

#include "tumble/contact/contact_events.hpp"
#include "tumble/contact/several_points.hpp"

namespace tumble::contact::detail {

/// One run, as far as it has come.
class RunRecorder {
 public:
  explicit RunRecorder(const ContactScene& scene) : scene_(scene) {
    for (const ContactBody& body : scene.bodies) {
      run_.flights.push_back({{0, body.start, -1}});
      run_.rest_since.push_back(std::numeric_limits<double>::infinity());
      run_.energy.start += energy_in(scene.gravity, body.body, body.start);
    }
  }

  ContactRun& run() { return run_; }
  FlightStart& flight(int i) { return run_.flights[static_cast<std::size_t>(i)].back(); }
  double& rest_since(int i) { return run_.rest_since[static_cast<std::size_t>(i)]; }

  /// A body goes on otherwise from now on; what began at this time is forgotten.
  void go_on(int i, const FlightStart& next) {
    count_sliding(i, next.state.x);
    auto& legs = run_.flights[static_cast<std::size_t>(i)];
    if (legs.back().t == next.t)
      legs.back() = next;
    else
      legs.push_back(next);
  }

  /// @param x where the first body is [m]
  void impact(const ContactEvent& event, const PointImpulse& impulse, const Vec3& normal,
              const Vec3& x) {
    const ImpactResult& result = impulse.result;
    run_.impacts.push_back({event.t(), event.body, event.other, event.wall, x + impulse.arm, normal,
                            result.impulse, result.energy, result.slip, result.jammed});
    run_.energy.impacts += result.energy;
  }

  /// Energy that is forgotten when a body is said to rest, roll or slide.
  void forget(const Colliding& before, const RigidBodyState<>& after) {
    run_.energy.settled +=
        kinetic_energy(before.body, after) - kinetic_energy(before.body, before.state);
  }

  /// The end of the run, for a body that is now in this state.
  void end(int i, const RigidBodyState<>& now) {
    count_sliding(i, now.x);
    run_.energy.end += energy_in(scene_.gravity, scene_.body(i).body, now);
  }

  /// Ends the run undecided.
  void end_undecided(int i) {
    run_.ending = Ending::lasting_contact;
    run_.undecided = i;
  }

 private:
  /// The work of the floor on its way to x.
  void count_sliding(int i, const Vec3& x) {
    const FlightStart& last = flight(i);
    if (last.on_wall < 0) return;
    const Vec3 force = scene_.body(i).body.mass() * (last.acceleration - scene_.gravity);
    run_.energy.sliding += force.dot(x - last.state.x);
  }

  const ContactScene& scene_;
  ContactRun run_;
};

}  // namespace tumble::contact::detail
