// Error against cost of each ODE method, on the body that turns over.
#include <functional>
#include <limits>

#include "support/plot.hpp"
#include "support/stopwatch.hpp"
#include "tour/tour.hpp"
#include "tumble/ode.hpp"
#include "tumble/quaternion.hpp"

namespace tumble::tour {
namespace {

constexpr Spin start_spin{6.283185307179586,
                          0.01};  // one turn a second, nearly about the middle axis
constexpr double duration = 3;    // [s]

/// One run of a solver.
struct Sample {
  double evaluations, seconds, error;
};

struct Curve {
  std::string name;
  int order;
  std::vector<Sample> samples;
};

/// The problem that all methods are given, and its answer.
struct Problem {
  RigidBodyRhs<double> motion;
  PackedState<double> start;
  Quat exact;

  double error(const PackedState<double>& y) const {
    return angle_between(rotation::normalize(unpack<double>(y).q), exact);
  }
};

/// The answer: the best method, in long double where that is more than double, at
/// the tightest tolerance.
Problem make_problem(const RigidBody<>& body, const MassProperties& properties) {
  const PackedState<double> start = pack(spinning(body, start_spin));
  const RigidBody<long double> precise(properties);
  const double tolerance =
      std::max(1e-18, 4 * static_cast<double>(std::numeric_limits<long double>::epsilon()));
  const PackedState<long double> end =
      integrate_adaptive<Dop853>(RigidBodyRhs(precise),
                                 PackedState<long double>(start.cast<long double>()), 0.0L,
                                 static_cast<long double>(duration), {tolerance, tolerance})
          .y;
  return {RigidBodyRhs(body), start, unpack<double>(PackedState<double>(end.cast<double>())).q};
}

/// A method run once counted and then timed; `solve(rhs)` gives the end state.
template <class Solve>
Sample sample(const Problem& problem, Solve&& solve) {
  int evaluations = 0;
  const PackedState<double> y = solve([&](double t, const PackedState<double>& state) {
    ++evaluations;
    return problem.motion(t, state);
  });
  const double seconds =
      support::shortest_run(0.005, [&] { support::keep(solve(problem.motion)); });
  return {static_cast<double>(evaluations), seconds, problem.error(y)};
}

template <class Method>
Curve fixed_steps(const std::string& name, const Problem& problem, int fewest, int most) {
  progress("work and precision of " + name);
  Curve curve{name, Method::order, {}};
  for (int steps = fewest; steps <= most; steps *= 2)
    curve.samples.push_back(sample(problem, [&](auto&& f) {
      return integrate_fixed<Method>(f, problem.start, 0.0, duration, steps);
    }));
  return curve;
}

template <class Method>
Curve adaptive_steps(const std::string& name, const Problem& problem, int finest) {
  progress("work and precision of " + name);
  Curve curve{name, Method::order, {}};
  for (int digits = 2; digits <= finest; ++digits) {
    const double tolerance = std::pow(10.0, -digits);
    curve.samples.push_back(sample(problem, [&](auto&& f) {
      return integrate_adaptive<Method>(f, problem.start, 0.0, duration, {tolerance, tolerance}).y;
    }));
  }
  return curve;
}

/// The fewest evaluations with which the error was reached, or a dash.
std::string evaluations_to_reach(const Curve& curve, double error) {
  double fewest = std::numeric_limits<double>::infinity();
  for (const Sample& s : curve.samples)
    if (s.error <= error) fewest = std::min(fewest, s.evaluations);
  return std::isfinite(fewest) ? std::to_string(std::lround(fewest)) : "–";
}

std::string time_to_reach(const Curve& curve, double error) {
  double least = std::numeric_limits<double>::infinity();
  for (const Sample& s : curve.samples)
    if (s.error <= error) least = std::min(least, s.seconds);
  return std::isfinite(least) ? support::duration(least) : "–";
}

double best_error(const Curve& curve) {
  double best = std::numeric_limits<double>::infinity();
  for (const Sample& s : curve.samples) best = std::min(best, s.error);
  return best;
}

support::Plot plot_of(const std::vector<Curve>& curves, const std::string& label,
                      const std::function<double(const Sample&)>& cost) {
  support::Plot plot{"solvers on the tumbling body",
                     {label, support::Scale::log},
                     {"orientation error at the end [rad]", support::Scale::log},
                     {}};
  for (const Curve& curve : curves) {
    support::Series series{curve.name, {}, {}};
    for (const Sample& s : curve.samples) {
      series.x.push_back(cost(s));
      series.y.push_back(s.error);
    }
    plot.series.push_back(series);
  }
  return plot;
}

support::Table samples_table(const std::vector<Curve>& curves) {
  support::Table table({"method", "evaluations", "seconds", "orientation error [rad]"});
  for (const Curve& curve : curves)
    for (const Sample& s : curve.samples)
      table.add({curve.name, support::number(s.evaluations, 9), support::number(s.seconds, 4),
                 support::number(s.error, 4)});
  return table;
}

}  // namespace

void show_solvers(const Subject& subject, Output& output) {
  const RigidBody<> body(subject.exact);
  progress("reference solution");
  const Problem problem = make_problem(body, subject.exact);
  const std::vector<Curve> curves{
      fixed_steps<runge_kutta::Euler>("Euler", problem, 128, 1 << 17),
      fixed_steps<runge_kutta::Midpoint>("midpoint", problem, 64, 1 << 16),
      fixed_steps<Rk4>("RK4", problem, 32, 1 << 15),
      adaptive_steps<DormandPrince54>("Dormand–Prince 5(4)", problem, 14),
      adaptive_steps<Dop853>("Dormand–Prince 8(5,3)", problem, 15),
      fixed_steps<runge_kutta::BackwardEuler>("backward Euler", problem, 128, 1 << 13),
      adaptive_steps<Radau5>("Radau IIA 5 (implicit)", problem, 12)};

  support::Table table(
      {"method", "order", "evaluations to 1e-3", "1e-6", "1e-9", "time to 1e-6", "best error"});
  for (const Curve& c : curves)
    table.add({c.name, std::to_string(c.order), evaluations_to_reach(c, 1e-3),
               evaluations_to_reach(c, 1e-6), evaluations_to_reach(c, 1e-9), time_to_reach(c, 1e-6),
               support::error_number(best_error(c))});
  output.show("Solvers: what you pay for an error of the orientation [rad] after 3 s of tumbling",
              table, "solvers");
  output.write("solvers_samples.csv", samples_table(curves).csv());
  output.write("solvers.svg",
               support::to_svg(plot_of(curves, "evaluations of dydt",
                                       [](const Sample& s) { return s.evaluations; })));
  output.write(
      "solvers_time.svg",
      support::to_svg(plot_of(curves, "time [s]", [](const Sample& s) { return s.seconds; })));
}

}  // namespace tumble::tour
