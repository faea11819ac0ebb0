#include "judge/mine/invariants.hpp"

#include <algorithm>
#include <cmath>

#include "judge/mine/measure.hpp"
#include "judge/protocol/finding.hpp"
#include "tumble/ode/midpoint.hpp"
#include "tumble/quaternion.hpp"

namespace tumble::judge::mine {

namespace {

Invariants invariants_of(const ProblemResult& result, const std::vector<Numbers>& states) {
  const MassProperties body = result.body();
  const double E0 = result.problem.energy(states.front(), body);
  const RigidBodyState<> start = unpack<double>(states.front());
  Invariants laws;
  for (const Numbers& y : states) {
    const auto worse = [](double& largest, double x) {
      if (!(x <= largest)) largest = x;  // not a number counts too
    };
    worse(laws.energy, std::abs(result.problem.energy(y, body) / E0 - 1));
    worse(laws.length, std::abs(y.segment<4>(3).norm() - 1));
    if (!result.problem.pull) worse(laws.momentum, (y.tail<3>() - start.L).norm() / start.L.norm());
  }
  return laws;
}

/// How q turns in a few short steps.
Turning turning_of(const OwnEngine& engine, const ProblemResult& result, Method method) {
  constexpr double moment = 1e-3;  // [s]
  RunQuestion question = result.question(method, samples);
  question.duration = moment;
  const Numbers y = engine.run(question).answer.states.back();
  const RigidBodyState<>& start = result.problem.start;
  const Quat turned = Quat(y[3], y[4], y[5], y[6]) * start.q.conjugate();
  const Vec3 measured = log_quaternion<double>(rotation::normalize(turned)) / moment;
  return {derived(result.problem.body, start).omega, measured, to_matrix(start.q)};
}

only_what_a_scene_needs::EnergyDrift right_drift(const ProblemResult& result,
                                                 const std::vector<Numbers>& states, double h) {
  const double E0 = result.problem.energy(states.front(), result.body());
  only_what_a_scene_needs::EnergyDrift drift{0, 0};
  double above = 0, below = 0, n = -(static_cast<double>(states.size()) - 1) / 2;
  for (const Numbers& y : states) {
    const double e = result.problem.energy(y, result.body()) / E0 - 1;
    drift.largest = std::max(drift.largest, std::abs(e));
    above += n * e;
    below += n * n;
    ++n;
  }
  drift.trend = above / below / h;
  return drift;
}

}  // namespace

void look_at_invariants(const OwnEngine& engine, ProblemResult& result) {
  for (const Method method : {Method::rk4, Method::midpoint, Method::euler})
    for (const OwnCurve& own : result.own) {
      if (own.method != method || own.states.empty() || result.laws) continue;
      result.laws = invariants_of(result, own.states);
      try {
        result.turning = turning_of(engine, result, method);
      } catch (const NoAnswer&) {
        // Long runs have come back: what is wrong with a short one, the specs say.
      }
    }
}

DriftResult drift_of(const OwnEngine& engine, const ProblemResult& result) {
  constexpr int steps = 128;
  DriftResult drift;
  const PackedState<double> start = pack(result.problem.start);
  std::vector<Numbers> states{start};
  const double h = result.problem.duration / steps;
  const RigidBodyRhs motion(result.problem.body);
  for (int i = 0; i < steps; ++i)
    states.push_back(runge_kutta::Midpoint::step(motion, i * h, states.back(), h));
  try {
    drift.right = right_drift(result, states, h);
    drift.own = engine.drift(result.setting(), states, h);
  } catch (const NoAnswer& why) {
    drift.failure = text_of(why);
  }
  return drift;
}

}  // namespace tumble::judge::mine
