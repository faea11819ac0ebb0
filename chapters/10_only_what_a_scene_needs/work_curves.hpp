#pragma once
/// @file
/// Error against evaluations of the forces, of one method in one scene after the other.

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "10_only_what_a_scene_needs/by_series.hpp"
#include "10_only_what_a_scene_needs/rivals.hpp"
#include "tumble/ode/integrate_adaptive.hpp"

namespace scene_chapter {

/// What a run cost, and how wrong its end was.
struct Work {
  double evaluations, error;  ///< [rad]
};

/// The runs of one method, rough ones first.
struct WorkCurve {
  std::string name;
  std::vector<Work> runs;

  /// The least work that has an error; infinity if there is none.
  double work_for(double error) const {
    double least = std::numeric_limits<double>::infinity();
    for (const Work& run : runs)
      if (run.error <= error) least = std::min(least, run.evaluations);
    return least;
  }
};

/// Which runs are made, and kept.
struct WorkRange {
  double least_error, most_error;  ///< [rad]
  double most_evaluations;

  void keep(WorkCurve& curve, const Work& run) const {
    if (run.error >= least_error && run.error <= most_error) curve.runs.push_back(run);
  }
};

inline double end_error(const KnownTurning& scene, const Quat& q) {
  return angle_between(q, scene.end);
}

inline WorkCurve by_fixed_steps(const KnownTurning& scene, const Steps& method,
                                const WorkRange& range) {
  WorkCurve curve{method.name, {}};
  for (double steps = 20; steps * method.evaluations < range.most_evaluations; steps *= 1.5) {
    const int count = static_cast<int>(steps);
    const double h = scene.duration / count;
    RigidBodyState<> state = scene.start;
    for (int i = 0; i < count; ++i) state = method.step(i * h, state, h);
    const Work run{static_cast<double>(count * method.evaluations), end_error(scene, state.q)};
    range.keep(curve, run);
    if (run.error < range.least_error) break;
  }
  return curve;
}

template <class Method>
WorkCurve by_tolerances(const KnownTurning& scene, const std::string& name,
                        const WorkRange& range) {
  WorkCurve curve{name, {}};
  const HeldRhs motion(scene.body, scene.forces);
  for (int i = 4; i <= 26; ++i) {
    const double tolerance = std::pow(10, -0.5 * i);
    const auto solution = integrate_adaptive<Method>(motion, pack(scene.start), 0.0, scene.duration,
                                                     {tolerance, tolerance});
    const Work run{static_cast<double>(solution.evaluations),
                   end_error(scene, unpack<double>(solution.y).q)};
    range.keep(curve, run);
    if (run.error < range.least_error) break;
  }
  return curve;
}

/// Each term of a series counts as an evaluation.
inline WorkCurve by_taylor(const KnownTurning& scene, const WorkRange& range) {
  WorkCurve curve{"Taylor, terms", {}};
  for (int i = 3; i <= 28; ++i) {
    int order = 0, steps = 0;
    const Quat end = by_series(scene, std::pow(10, -0.5 * i), order, steps);
    range.keep(curve, {static_cast<double>(order * steps), end_error(scene, end)});
  }
  return curve;
}

}  // namespace scene_chapter
