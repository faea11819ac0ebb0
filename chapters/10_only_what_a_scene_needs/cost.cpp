/// @file
/// Error against evaluations of the forces: every method on one figure.

#include "by_series.hpp"
#include "common.hpp"
#include "parts.hpp"
#include "rivals.hpp"

namespace scene_chapter {

namespace {

double end_error(const KnownTurning& scene, const Quat& q) { return angle_between(q, scene.end); }

constexpr double smallest_drawn = 3e-12, largest_drawn = 0.1;  // [rad]

void add_point(support::Series& series, double work, double error) {
  if (!(error >= smallest_drawn && error <= largest_drawn)) return;
  series.x.push_back(work);
  series.y.push_back(error);
}

support::Series by_fixed_steps(const KnownTurning& scene, const Steps& method) {
  support::Series series{method.name, {}, {}};
  for (double steps = 20; steps * method.evaluations < 6e4; steps *= 1.5) {
    const int count = static_cast<int>(steps);
    const double h = scene.duration / count;
    RigidBodyState<> state = scene.start;
    for (int i = 0; i < count; ++i) state = method.step(i * h, state, h);
    const double error = end_error(scene, state.q);
    add_point(series, count * method.evaluations, error);
    if (error < smallest_drawn) break;
  }
  return series;
}

template <class Method>
support::Series by_tolerances(const KnownTurning& scene, const std::string& name) {
  support::Series series{name, {}, {}};
  const HeldRhs motion(scene.body, scene.forces);
  for (int i = 4; i <= 26; ++i) {
    const double tolerance = std::pow(10, -0.5 * i);
    const auto solution = integrate_adaptive<Method>(motion, pack(scene.start), 0.0, scene.duration,
                                                     {tolerance, tolerance});
    add_point(series, solution.evaluations, end_error(scene, unpack<double>(solution.y).q));
  }
  return series;
}

support::Series by_taylor(const KnownTurning& scene) {
  support::Series series{"Taylor, terms", {}, {}};
  for (int i = 3; i <= 28; ++i) {
    int order = 0, steps = 0;
    const Quat end = by_series(scene, std::pow(10, -0.5 * i), order, steps);
    add_point(series, order * steps, end_error(scene, end));
  }
  return series;
}

/// One question, drawn at the error that the closed form says it stays below.
support::Series by_closed_form(const KnownTurning& scene) {
  const steady::SteadyTorque torque(scene.body, scene.forces);
  const auto top = steady::LagrangeTop::from(torque, scene.start.q, scene.start.L);
  return {"closed form, asked once", {1}, {top->error_bound(scene.duration)}, support::Look::dots};
}

/// The least of a curve's work that has an error.
std::string work_for(const support::Series& series, double error) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < series.x.size(); ++i)
    if (series.y[i] <= error) least = std::min(least, series.x[i]);
  return std::isinf(least) ? "–" : number(least, 6);
}

}  // namespace

std::string work_figure() {
  support::Plot plot{"ten seconds of a fast top",
                     {"evaluations of the forces", support::Scale::log},
                     {"orientation off by [rad]", support::Scale::log},
                     {}};
  const KnownTurning& scene = fast_top();
  const std::vector<Steps> all = rivals(scene);
  // Orders 2, 4 and 8: with all methods of the table the curves would hide each other.
  plot.series = {by_fixed_steps(scene, all[0]), by_tolerances<Dop853>(scene, "DOP853, adaptive"),
                 by_fixed_steps(scene, all[3]), by_fixed_steps(scene, all[4]),
                 by_fixed_steps(scene, all[6]), by_taylor(scene),
                 by_closed_form(scene)};
  return support::to_svg(plot);
}

Table work_table() {
  Table table({"method", "1e-3 rad", "1e-6 rad", "1e-9 rad", "1e-11 rad"});
  const auto add = [&](const support::Series& series) {
    table.add({series.name, work_for(series, 1e-3), work_for(series, 1e-6), work_for(series, 1e-9),
               work_for(series, 1e-11)});
  };
  const KnownTurning& scene = lopsided_body();
  const std::vector<Steps> all = rivals(scene);
  add(by_fixed_steps(scene, all[0]));
  add(by_tolerances<DormandPrince54>(scene, "DP 5(4), adaptive"));
  add(by_tolerances<Dop853>(scene, "DOP853, adaptive"));
  for (std::size_t i = 3; i <= 6; ++i) add(by_fixed_steps(scene, all[i]));
  add(by_taylor(scene));
  return table;
}

}  // namespace scene_chapter
