#pragma once
/// @file
/// What simulate() says of its error, and what is true: on random scenes.

#include <algorithm>
#include <chrono>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "project/harness/extended_trajectory.hpp"
#include "tumble/quaternion/exp_log.hpp"
#include "tumble/simulate/simulate.hpp"

namespace tumble::test {

/// The answer for one scene.
struct Answer {
  MotionScene scene;
  double asked = 0, stated = 0, truth = 0;  ///< errors
  bool reached = false;
  double reference_error = 0;
  double seconds = 0;        ///< of simulate()
  std::string refused = {};  ///< the message, if there was one
  std::string method = {};

  double per_asked() const { return truth / asked; }
  double per_stated() const { return truth / stated; }
};

inline Trajectory simulated(const MotionScene& s) {
  const RigidBody<> body(s.mass, s.I_body);
  const SimulationTask task{.t0 = s.t0, .t1 = s.t1, .tolerance = s.tolerance};
  if (!s.any_force()) return simulate(body, s.start, task, s.steady);
  const auto any = [&s](double t, const RigidBody<>& b, const Derived<>& now) -> Wrench<> {
    Wrench<> sum = s.steady(t, b, now);
    for (const SpringToWorld& spring : s.springs) sum += spring(t, b, now);
    for (const Pulse& pulse : s.pulses) {
      const double from = (t - pulse.centre) / pulse.width, share = std::exp(-from * from);
      sum += {share * pulse.force, share * pulse.torque};
    }
    return sum;
  };
  return simulate(body, s.start, task, any);
}

/// The true motion of a scene at moments of it.
struct Truth {
  std::vector<LongState> states;
  LongVec sizes;  ///< of x, P and L: the largest, or what a thousandth of a turn makes of them
};

/// Moments at which motions are compared, as parts of the span.
inline double moment(int i, int count) { return (i + 1) / static_cast<double>(count); }
inline constexpr int moments = 13;

inline std::optional<Truth> truth_of(const MotionScene& s, int shift = 0) {
  ExtendedTrajectory motion(s, shift);
  Truth truth;
  const Long span = static_cast<Long>(s.t1) - static_cast<Long>(s.t0);
  for (int i = 0; i < moments; ++i) {
    const double t = s.t0 + moment(i, moments) * (s.t1 - s.t0);
    if (!motion.advance_to(i + 1 == moments ? span
                                            : static_cast<Long>(t) - static_cast<Long>(s.t0)))
      return {};
    truth.states.push_back(motion.state());
  }
  const double inertia = s.I_body.trace() / 3, length = std::sqrt(inertia / s.mass);
  const double time = s.t1 - s.t0;
  truth.sizes =
      motion.sizes().cwiseMax(1e-3L * LongVec(length, s.mass * length / time, inertia / time));
  return truth;
}

/// The largest of the errors of orientation, x, P and L.
inline double error_between(const LongState& a, const LongState& b, const LongVec& sizes) {
  const Long angle = angle_between(a.q, b.q);
  const LongVec off((a.x - b.x).norm(), (a.P - b.P).norm(), (a.L - b.L).norm());
  const Long largest = std::max(angle, off.cwiseQuotient(sizes).maxCoeff());
  return largest == largest && angle == angle ? static_cast<double>(largest) : INFINITY;
}

inline LongState lengthened(const RigidBodyState<>& s) {
  const Quaternion<Long> q(s.q.w(), s.q.x(), s.q.y(), s.q.z());
  return {s.x.cast<Long>(), q.normalized(), s.P.cast<Long>(), s.L.cast<Long>()};
}

/// Asks simulate(), and looks how right it was. Nothing if the truth is not known well enough.
inline std::optional<Answer> answer_for(const MotionScene& scene) {
  Answer answer{.scene = scene, .asked = scene.tolerance};
  const auto begin = std::chrono::steady_clock::now();
  const auto stop = [&] {
    answer.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  std::optional<Trajectory> found;
  try {
    found = simulated(scene);
    stop();
  } catch (const std::runtime_error& error) {
    stop();
    answer.refused = error.what();
    return answer;
  }
  const auto truth = truth_of(scene), other = truth_of(scene, 3);
  if (!truth || !other) return {};
  answer.stated = found->report().error_estimate;
  answer.reached = found->report().reached();
  answer.method = found->report().method;
  for (int i = 0; i < moments; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double t =
        i + 1 == moments ? scene.t1 : scene.t0 + moment(i, moments) * (scene.t1 - scene.t0);
    const LongState& right = truth->states[k];
    answer.truth =
        std::max(answer.truth, error_between(lengthened(found->at(t)), right, truth->sizes));
    answer.reference_error =
        std::max(answer.reference_error, error_between(other->states[k], right, truth->sizes));
  }
  // Where the truth is not known to a tenth of what is judged by it, nothing is judged.
  if (!(answer.reference_error <= 0.1 * std::max(answer.truth, answer.stated))) return {};
  return answer;
}

}  // namespace tumble::test
