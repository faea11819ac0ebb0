/// @file
/// State the error: what simulate() chooses, says and keeps.

#include "common.hpp"
#include "parts.hpp"

namespace scene_chapter {

namespace {

/// What is asked of a scene with a known end.
Trajectory asked(const KnownTurning& scene, double tolerance) {
  const SimulationTask task{0, scene.duration, tolerance};
  return simulate(scene.body, scene.start, task, scene.forces);
}

Trajectory asked_of_mug(double tolerance) {
  return simulate(mug(), mug_start(), {0, 0.5, tolerance}, weight, spring, drag);
}

const RigidBodyState<>& true_mug() {
  static const RigidBodyState<> end = followed(hanging_mug(), mug_start(), 0.5);
  return end;
}

/// "DOP853", "closed form", "Taylor"
std::string short_name(const std::string& method) {
  if (method.starts_with("closed form")) return "closed form";
  if (method.starts_with("Taylor")) return "Taylor, " + method.substr(method.find("order"));
  return "DOP853";
}

void add_stated(Table& table, const std::string& name, double tolerance, const Trajectory& way,
                const Quat& truth) {
  const SimulationReport& report = way.report();
  table.add({name, number(tolerance), short_name(report.method), std::to_string(report.evaluations),
             error_above(report.error_estimate, 1e-14),
             error_above(angle_between(way.end().q, truth), 1e-12)});
}

}  // namespace

Table stated_table() {
  Table table({"scene", "asked [rad]", "method", "evaluations", "stated", "true"});
  for (const double tolerance : {1e-3, 1e-12})
    add_stated(table, "flipping, free, 100 s", tolerance, asked(flipping_body(), tolerance),
               flipping_body().end);
  for (const double tolerance : {1e-3, 1e-12})
    add_stated(table, "fast top, 10 s", tolerance, asked(fast_top(), tolerance), fast_top().end);
  for (const double tolerance : {1e-3, 1e-6, 1e-9, 1e-12})
    add_stated(table, "lopsided, 10 s", tolerance, asked(lopsided_body(), tolerance),
               lopsided_body().end);
  for (const double tolerance : {1e-3, 1e-6, 1e-9, 1e-12})
    add_stated(table, "mug, 0.5 s", tolerance, asked_of_mug(tolerance), true_mug().q);
  return table;
}

Table unreachable_table() {
  Table table({"scene", "asked [rad]", "reached", "says that it is off by"});
  const auto add = [&](const std::string& name, const Trajectory& way) {
    const SimulationReport& report = way.report();
    table.add({name, number(report.tolerance), report.reached() ? "yes" : "no",
               below(report.error_estimate) + " rad"});
  };
  add("flipping, free, 100 s", asked(flipping_body(), 1e-15));
  add("fast top, 10 s", asked(fast_top(), 1e-15));
  add("lopsided, 10 s", asked(lopsided_body(), 1e-15));
  add("mug, 0.5 s", asked_of_mug(1e-15));
  return table;
}

}  // namespace scene_chapter
