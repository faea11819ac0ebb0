#include "scenes/motions.hpp"

#include <memory>
#include <stdexcept>
#include <utility>

#include "scenes/contact_motion.hpp"
#include "scenes/contact_scene.hpp"
#include "scenes/fastest_force.hpp"
#include "scenes/joined_motion.hpp"
#include "support/printable.hpp"
#include "tumble/body/derived.hpp"
#include "tumble/contact/can_touch.hpp"
#include "tumble/core/rounding.hpp"
#include "tumble/core/step_budget.hpp"
#include "tumble/mass/principal_axes.hpp"
#include "tumble/simulate/first_event.hpp"
#include "tumble/simulate/simulate.hpp"

namespace tumble::scenes {
namespace {

Trajectory motion_of(const SceneBody& body, const SimulationTask& task) {
  const auto simulated = [&](const auto&... forces) {
    return body.held ? detail::simulate_turning(*body.held, body.start, task, forces...)
                     : simulate(body.body, body.start, task, forces...);
  };
  if (body.springs.empty()) return simulated(body.steady);
  const auto springs = [list = body.springs](double t, const RigidBody<>& b,
                                             const Derived<>& now) -> Wrench<> {
    Wrench<> sum;
    for (const SpringToWorld& spring : list) sum += spring(t, b, now);
    return sum;
  };
  return simulated(body.steady, springs);
}

/// A motion with another report.
class SameMotion final : public detail::AnyTrajectory<RigidBodyState<>> {
 public:
  explicit SameMotion(Trajectory motion) : motion_(std::move(motion)) {}

  RigidBodyState<> at(double t) const override { return motion_.at(t); }
  std::vector<double> times() const override { return motion_.times(); }

 private:
  Trajectory motion_;
};

/// What rounding makes of a start: a file gives ω, and the motion begins with L, rounded as a
/// whole. Of a slim body little of L lies along its axis, and makes it turn fast there. What it
/// makes of ω at once is in it, too.
double rounding_of_start(const SceneBody& body, double span) {
  constexpr double roundings = 8;
  const RigidBody<>& turning = body.held ? body.held->about_point() : body.body;
  const RigidBodyState<>& start = body.start;
  const Mat3& I = turning.I_body();
  if (start.L.isZero(0) || (start.q.vec().isZero(0) && I.isDiagonal(0))) return 0;
  const double fastest = start.L.norm() / principal_axes(I).moments.minCoeff();
  const double omega = derived(turning, start).omega.norm();
  return roundings * detail::unit_roundoff * fastest * (span + 1 / omega);
}

Trajectory with_report(const Trajectory& motion, const SimulationReport& report) {
  return {std::make_shared<const SameMotion>(motion), motion.t0(), motion.t1(), report};
}

/// Closed forms take the start as exact; runs begin beside it.
Trajectory with_rounded_start(const Trajectory& motion, double rounding) {
  SimulationReport report = motion.report();
  if (report.runs > 0) return motion;
  report.error_estimate += rounding;
  return with_report(motion, report);
}

/// What `f()` gives. What the library says names a body here, and its advice is one that a scene
/// can follow.
/// @param fastest fastest() → which force is too fast, if one is
/// @throws std::runtime_error that begins with `who`
template <class Fastest, class F>
auto in_words_of_scenes(const std::string& who, const Fastest& fastest, F&& f) -> decltype(f()) {
  try {
    return f();
  } catch (const std::exception& error) {
    const std::string force = fastest();
    if (!force.empty()) throw std::runtime_error(who + ": " + force);
    if (dynamic_cast<const detail::TooManySteps*>(&error) == nullptr)
      throw std::runtime_error(who + ": " + error.what());
    throw std::runtime_error(
        who +
        ": to follow this motion to the end takes too many steps. It turns or swings too often in "
        "that time, or a strong drag stops it almost at once. Give a shorter duration, or make "
        "what is so fast or so strong weaker");
  }
}

Trajectory named_motion_of(const SceneBody& body, const SimulationTask& task) {
  const double duration = task.t1 - task.t0;
  Trajectory motion = in_words_of_scenes(
      support::escaped(body.name), [&] { return fastest_force(body, duration); },
      [&] { return with_rounded_start(motion_of(body, task), rounding_of_start(body, duration)); });
  if (task.t1 != task.t0) return motion;
  SimulationReport report = motion.report();
  report.method = "none: the duration is 0";  // a scene file has no t0 and no t1
  return with_report(motion, report);
}

Motions move_each(const Scene& scene) {
  Motions motions{.start = scene.task.t0, .end = scene.task.t1};
  const std::vector<std::size_t> joined = joined_bodies(scene);
  const std::vector<Trajectory> together = in_words_of_scenes(
      "the bodies that springs join", [&] { return fastest_joined_force(scene); },
      [&] { return move_joined(scene, joined); });
  std::size_t next = 0;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const bool is_joined = next < joined.size() && joined[next] == i;
    motions.trajectories.push_back(is_joined ? together[next++]
                                             : named_motion_of(scene.bodies[i], scene.task));
  }
  if (!scene.stop) return motions;
  const StopWhen& stop = *scene.stop;
  const auto height = [&](double, const RigidBodyState<>& s) {
    return s.x[stop.coordinate] - stop.level;
  };
  if (const auto event = first_event(motions.trajectories[stop.body], height)) {
    motions.end = event->t;
    motions.stopped = true;
  }
  return motions;
}

}  // namespace

Motions move(const Scene& scene) {
  if (!scene.contact) return move_each(scene);
  const contact::ContactScene with_walls = contact_scene(scene);
  if (!can_touch(with_walls, scene.task.t1 - scene.task.t0)) return move_each(scene);
  return move_in_contact(scene, with_walls);
}

std::vector<double> record_times(const Scene& scene, const Motions& motions) {
  std::vector<double> times;
  for (int i = 0; scene.every > 0; ++i) {
    const double t = motions.start + i * scene.every;
    if (t >= motions.end - 1e-9 * scene.every) break;
    times.push_back(t);
  }
  times.push_back(motions.end);
  return times;
}

}  // namespace tumble::scenes
