#include "scenes/contact_motion.hpp"

#include <algorithm>
#include <cmath>

#include "scenes/contact_scene.hpp"
#include "support/table.hpp"
#include "tumble/contact/simulate_contacts.hpp"

namespace tumble::scenes {
namespace {

using contact::Ending;
using contact::FlightStart;

/// Part of the reach: hops this high are not told from standing. Of a mug that is 10 µm.
constexpr double hop = 1e-4;

/// One coordinate of a centre on one leg: h + v s + a s²/2 above the level for 0 ≤ s ≤ length.
struct Leg {
  double h, v, a, length;

  double at(double s) const { return h + s * (v + s / 2 * a); }
  /// The first s > 0 at which the sign changes. What starts at 0 counts from where it leaves 0.
  std::optional<double> crossing() const {
    const double turn = a != 0 ? std::clamp(-v / a, 0., length) : length;
    for (const auto& [from, to] : {std::pair{0., turn}, std::pair{turn, length}}) {
      const double before = at(from), after = at(to);
      if (before != 0 && to > from && (after == 0 || std::signbit(before) != std::signbit(after)))
        return root(from, to);
    }
    return {};
  }

 private:
  /// Of the two roots, the one between: without the difference of two numbers that nearly cancel.
  double root(double from, double to) const {
    const double q = -(v + std::copysign(std::sqrt(std::fmax(0, v * v - 2 * a * h)), v));
    const double first = q != 0 ? 2 * h / q : from, second = a != 0 ? q / a : first;
    const double middle = (from + to) / 2;
    const bool is_first = std::abs(first - middle) <= std::abs(second - middle);
    return std::clamp(is_first ? first : second, from, to);
  }
};

/// When the coordinate first passes the level, from the start of the run on.
std::optional<double> first_crossing(const Contacts& contacts, const StopWhen& stop) {
  const auto& legs = contacts.run.flights[stop.body];
  const double mass = contacts.scene.bodies[stop.body].body.mass();
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const FlightStart& now = legs[i];
    const double until = i + 1 < legs.size() ? legs[i + 1].t : contacts.run.t;
    const Leg leg{now.state.x[stop.coordinate] - stop.level, now.state.P[stop.coordinate] / mass,
                  (now.on_wall < 0 ? contacts.scene.gravity : now.acceleration)[stop.coordinate],
                  until - now.t};
    if (const auto s = leg.crossing()) return now.t + *s;
  }
  return {};
}

/// On a floor that carries it.
std::string how_it_goes_on(const SceneBody& body, const FlightStart& leg) {
  const bool is_ball = body.shape->convex.points().size() == 1;
  const Derived<> now = derived(body.body, leg.state);
  const double turns = now.omega.norm() * body.shape->convex.reach();
  if (turns > 0 && now.v.norm() <= 1e-9 * turns) return "spinning in place";
  return is_ball && turns > 0 ? "rolling" : "sliding";
}

}  // namespace

Motions move_in_contact(const Scene& scene, const contact::ContactScene& with_walls) {
  const double duration = scene.task.t1 - scene.task.t0;
  Contacts contacts{
      with_walls, {.until = duration, .tolerance = contact_tolerance(scene), .hop = hop}, {}};
  contacts.run = simulate_contacts(with_walls, contacts.settings);
  const auto stop = scene.stop ? first_crossing(contacts, *scene.stop) : std::nullopt;
  if (stop) {  // what came after it is not asked for
    contacts.settings.until = *stop;
    contacts.run = simulate_contacts(with_walls, contacts.settings);
  }
  const double end = complete(contacts) ? contacts.settings.until : contacts.run.t;
  return {.contacts = std::move(contacts),
          .start = scene.task.t0,
          .end = scene.task.t0 + end,
          .stopped = stop.has_value()};
}

bool complete(const Contacts& contacts) {
  return contacts.run.ending == Ending::time || contacts.run.ending == Ending::all_at_rest;
}

std::string how_it_ended(const Scene& scene, const Motions& motions, std::size_t body) {
  const contact::ContactRun& run = motions.contacts->run;
  const FlightStart& last = run.flights[body].back();
  const auto since = [&](double t) {
    return " since t = " + support::number(motions.start + t, 9) + " s";
  };
  if (std::isfinite(run.rest_since[body])) return "at rest" + since(run.rest_since[body]);
  if (last.on_wall >= 0)
    return how_it_goes_on(scene.bodies[body], last) + " on the " +
           scene.contact->walls[static_cast<std::size_t>(last.on_wall)].name + since(last.t);
  if (run.undecided == static_cast<int>(body)) return "in contact that lasts, undecided";
  return last.is_hop ? "in contact that lasts, in hops" : "in flight";
}

const std::string& hit_name(const Scene& scene, const contact::ImpactEvent& impact) {
  return impact.other >= 0 ? scene.bodies[static_cast<std::size_t>(impact.other)].name
                           : scene.contact->walls[static_cast<std::size_t>(impact.wall)].name;
}

}  // namespace tumble::scenes
