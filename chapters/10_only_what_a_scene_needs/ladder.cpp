/// @file
/// The ladder of models: which rung a body needs, and what it costs.

#include "common.hpp"
#include "named_bodies.hpp"
#include "parts.hpp"
#include "support/stopwatch.hpp"
#include "tumble/mass/solids/ball.hpp"
#include "tumble/mass/solids/box.hpp"
#include "tumble/mass/solids/cylinder.hpp"

namespace scene_chapter {

// ── What bodies are ──

namespace {

std::vector<Named> things() {
  return {{"tennis ball", ball()},
          {"die", die()},
          {"coin", coin()},
          {"pencil", pencil()},
          {"gear wheel", gear()},
          {"mug", weighed_finely(mug_object)},
          {"T-handle", weighed_finely(handle_object)},
          {"wing nut", fine_nut()},
          {"tennis racket", racket()}};
}

}  // namespace

Table chosen_table() {
  Table table({"body", "moments, largest = 1", "two differ by", "model", "if 2 % is nothing"});
  for (const auto& [name, body] : things()) {
    const Vec3 m = principal_axes(body.I_body()).moments;
    const auto part = [&](int i) { return number(m[i] / m[2], 3); };
    const double asymmetry = nearest_symmetric_top(body).asymmetry;
    table.add({name, part(0) + " : " + part(1) + " : 1",
               asymmetry > 0 && asymmetry < 1e-12 ? "rounding" : number(asymmetry, 2),
               name_of(model_of_moments(body).model), name_of(model_of_moments(body, 0.02).model)});
  }
  return table;
}

Table why_table() {
  Table table({"body", "model", "why"});
  for (const auto& [name, body] :
       {Named{"die", die()}, Named{"coin", coin()}, Named{"mug", mug()}}) {
    const ModelChoice choice = model_of_moments(body);
    table.add({name, name_of(choice.model), choice.why});
  }
  return table;
}

// ── The same answer, for less ──

namespace {

/// What simulate() chooses for a scene, and what the full body needs for the same.
template <class... Forces>
void add_rung(Table& table, const std::string& name, const RigidBody<>& body,
              const RigidBodyState<>& start, const SimulationTask& task, const Forces&... forces) {
  const Trajectory way = simulate(body, start, task, forces...);
  const auto full = integrate_adaptive<Dop853>(RigidBodyRhs(body, forces...), pack(start), task.t0,
                                               task.t1, {1e-10, 1e-10});
  const RigidBodyState<> end = unpack<double>(full.y), here = way.end();
  const double apart =
      task.wanted == Wanted::path_only ? (end.x - here.x).norm() : angle_between(end.q, here.q);
  const SimulationReport& report = way.report();
  table.add({name, name_of(report.model), std::to_string(report.evaluations),
             std::to_string(full.evaluations),
             error_above(apart, 1e-7) + (task.wanted == Wanted::path_only ? " m" : " rad")});
}

/// Thrown up and away, spinning about none of its axes.
RigidBodyState<> thrown(const RigidBody<>& body) {
  return state_of_motion<double>(body, Vec3::Zero(), Quat::Identity(), {3, 0, 12}, {9, 20, 14});
}

}  // namespace

Table ladder_table() {
  Table table({"scene, 2 s", "model", "evaluations", "by DOP853", "apart"});
  const BodyDrag air{0.003, 0};
  const SimulationTask path{0, 2, 1e-7, Wanted::path_only}, all{0, 2, 1e-7};
  add_rung(table, "ball in the air, only its path", ball(), thrown(ball()), path, weight, air);
  add_rung(table, "racket, only its path", racket(), thrown(racket()), path, weight);
  add_rung(table, "die", die(), thrown(die()), all, weight);
  add_rung(table, "gear wheel", gear(), thrown(gear()), all, weight);
  add_rung(table, "racket", racket(), thrown(racket()), all, weight);
  const KnownTurning& top = fast_top();
  add_rung(table, "fast top on its pivot", top.body, top.start, all, top.forces);
  const KnownTurning& odd = lopsided_body();
  add_rung(table, "lopsided body on its pivot", odd.body, odd.start, all, odd.forces);
  add_rung(table, "mug on its spring", mug(), mug_start(), all, weight, spring, drag);
  return table;
}

// ── What a rung costs ──

namespace {

/// Adds rows with times and their ratio to the first one's.
Table times_of(const std::string& heading, const support::Stopwatch& stopwatch) {
  Table table({heading, "time", "as a ratio"});
  const std::vector<support::Timing> timings = stopwatch.timings();
  for (const support::Timing& each : timings)
    table.add({each.name, support::duration(each.seconds),
               support::times(each.seconds / timings[0].seconds)});
  return table;
}

}  // namespace

Table rungs_table() {
  static double t = 7;
  static const steady::SteadyPath path(ball(), thrown(ball()), weight.steady(ball()));
  static const FreeTrajectory round(die(), thrown(die())), top(gear(), thrown(gear())),
      full(racket(), thrown(racket()));
  static const RigidBodyRhs motion(racket(), weight);
  static PackedState<double> y = pack(thrown(racket()));
  support::Stopwatch stopwatch;
  const auto add = [&](const std::string& name, auto&& action) {
    stopwatch.add(name, [action] {
      support::keep(t);
      support::keep(y);
      support::keep(action());
    });
  };
  add("particle: its place at some time", [] { return path.x(t); });
  add("ball: orientation too", [] { return round.at(t); });
  add("symmetric top", [] { return top.at(t); });
  add("full body", [] { return full.at(t); });
  add("full body, set up and asked once",
      [] { return FreeTrajectory(racket(), thrown(racket())).at(t); });
  add("full body, one step of RK4", [] { return runge_kutta::rk4_step(motion, 0, y, 0.01); });
  return times_of("what is asked", stopwatch);
}

// ── Forces that are not there ──

namespace {

/// A falling body as one would write it if there were no other forces in the world.
struct OnlyFalling {
  RigidBody<> body;

  PackedState<double> operator()(double, const PackedState<double>& y) const {
    const RigidBodyState<> state = unpack<double>(y);
    const Derived<> now = derived(body, state);
    return pack<double>({now.v, rotation::quaternion_dot(state.q, now.omega),
                         body.mass() * weight.g, Vec3::Zero()});
  }
};

}  // namespace

Table absent_table() {
  static PackedState<double> y = pack(thrown(racket()));
  static const OnlyFalling by_hand{racket()};
  static const RigidBodyRhs falling(racket(), weight);
  static const RigidBodyRhs with_zero(racket(), weight, BodyDrag{0, 0});
  static const RigidBodyRhs with_two_zeros(racket(), weight, BodyDrag{0, 0},
                                           SpringToWorld{Vec3::Zero(), {0, 0, 9}, 0, 1});
  support::Stopwatch stopwatch;
  const auto add = [&](const std::string& name, const auto& motion) {
    stopwatch.add(name, [&motion] {
      support::keep(y);
      support::keep(runge_kutta::rk4_step(motion, 0, y, 0.01));
    });
  };
  add("weight alone, written by hand", by_hand);
  add("weight", falling);
  add("weight, drag of 0", with_zero);
  add("weight, drag of 0, spring of 0 N/m", with_two_zeros);
  return times_of("a step of RK4 with", stopwatch);
}

}  // namespace scene_chapter
