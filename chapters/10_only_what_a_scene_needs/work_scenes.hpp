#pragma once
/// @file
/// The scenes of figure 10.10, and what each method needs for them.

#include <algorithm>
#include <optional>
#include <vector>

#include "10_only_what_a_scene_needs/work_curves.hpp"
#include "tumble/body/model.hpp"
#include "tumble/steady/lagrange_top.hpp"

namespace scene_chapter::work_figure {

/// To somewhat below the diagram: also for its last line there is a run that is good enough.
constexpr WorkRange range{1e-11, 0.1, 4e4};

struct Scene {
  Model model;
  std::optional<double> promised;  ///< by its closed form, if there is one [rad]
  std::vector<WorkCurve> curves;   ///< by steps; the last one is what the library takes
};

inline std::optional<double> promised_by_closed_form(const KnownTurning& known) {
  const steady::SteadyTorque torque(known.body, known.forces);
  if (torque.is_free()) {
    const Vec3 omega = derived(known.body, known.start).omega;
    return 1e-14 * std::max(1., omega.norm() * known.duration);
  }
  const auto top = steady::LagrangeTop::from(torque, known.start.q, known.start.L);
  if (!top) return std::nullopt;
  return top->error_bound(known.duration);
}

inline Scene scene_of(const KnownTurning& known) {
  Scene made{model_of_moments(known.body).model, promised_by_closed_form(known), {}};
  made.curves.push_back(by_fixed_steps(known, of_method<Rk4>(known, "RK4", 4), range));
  made.curves.push_back(by_tolerances<Dop853>(known, "DOP853", range));
  if (known.forces.at_point.empty()) return made;
  const Steps splitting = of_splitting<geometric::BlanesMoan4>(known, "splitting, order 4");
  made.curves.push_back(by_fixed_steps(known, splitting, range));
  made.curves.push_back(by_taylor(known, range));
  return made;
}

inline KnownTurning known_scene(std::size_t i) {
  if (i == 0) return free_turning({1, 1, 1}, {1, 2, 3}, 10);
  if (i == 1) return free_turning({1, 1, 0.5}, {1, 2, 3}, 10);
  return i == 2 ? flipping_body() : i == 3 ? fast_top() : lopsided_body();
}

}  // namespace scene_chapter::work_figure
