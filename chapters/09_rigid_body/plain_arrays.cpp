/// @file
/// The same body on plain arrays, for a solver that knows nothing of bodies.

#include "common.hpp"
#include "objects/hanging_mug.hpp"
#include "parts.hpp"

namespace rigid_body_chapter {

namespace {

/// The mug on its spring, in the form of the lectures.
void dydt(double t, const double y[], double ydot[]) {
  static const auto motion = hanging_mug();
  const PackedState<double> rate = motion(t, Eigen::Map<const PackedState<double>>(y));
  for (int i = 0; i < 13; ++i) ydot[i] = rate[i];
}

/// How often counted() has been evaluated.
int evaluations = 0;

void counted(double t, const double y[], double ydot[]) {
  ++evaluations;
  dydt(t, y, ydot);
}

using Dydt = void (*)(double t, const double y[], double ydot[]);

/// The mug after t seconds, by so many steps of RK4.
std::vector<double> mug_after(double t, int steps, Dydt f) {
  const PackedState<double> start = pack(mug_start());
  std::vector<double> y(start.begin(), start.end());
  const double h = t / steps;
  for (int i = 0; i < steps; ++i) ode(y.data(), 13, h, f, i * h);
  return y;
}

}  // namespace

Table arrays_table() {
  Table table({"the call", "evaluations", "orientation off"});
  constexpr double t = 0.5;
  const RigidBodyState<> exact = followed(hanging_mug(), mug_start(), t);
  const auto add = [&](const std::string& call, const std::vector<double>& end) {
    const PackedState<double> y = Eigen::Map<const PackedState<double>>(end.data());
    table.add({call, std::to_string(evaluations),
               error_number(turned_apart(unpack<double>(y), exact)) + " rad"});
    evaluations = 0;
  };
  evaluations = 0;
  const PackedState<double> start = pack(mug_start());
  const std::vector<double> y0(start.begin(), start.end());
  add("120 × ode(Y, 13, h, dydt)", mug_after(t, 120, counted));
  std::vector<double> end(13);
  ode(start.data(), end.data(), 13, 0.0, t, counted);
  add("ode(y0, y1, 13, t0, t1, dydt)", end);
  for (const double tolerance : {1e-3, 1e-6, 1e-9, 1e-12})
    add("ode(y0, t0, t1, dydt, " + number(tolerance) + ")",
        ode(y0, 0.0, t, counted, {tolerance, tolerance}));
  return table;
}

}  // namespace rigid_body_chapter
