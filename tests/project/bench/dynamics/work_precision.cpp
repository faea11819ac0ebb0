#include "project/bench/dynamics/work_precision.hpp"

#include <cmath>

#include "tumble/quaternion/exp_log.hpp"

namespace tumble::bench {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

double coarsest(Knob knob, const Problem& problem) {
  if (knob == Knob::tolerance) return 1e-2;
  return std::ceil(problem.duration * problem.body().start.omega.norm());  // a radian a step
}

Entrant entrant(const Problem& problem, const Method& method) {
  const auto prepare = [&problem, &method](double setting) -> Attempt {
    const Run run = method.prepare(problem, setting);
    return {[run] { return run().w(); },
            [run, &problem] { return angle_between(run().normalized(), problem.end); }};
  };
  return {method.software, method.name,
          method.knob,     coarsest(method.knob, problem),
          prepare,         method.roundings * problem.condition * eps};
}

}  // namespace

Method as_method(const Stepper& stepper) {
  const auto prepare = [make = stepper.make](const Problem& problem, double steps) -> Run {
    const std::shared_ptr<Simulation> simulation = make(problem.scene, problem.duration / steps);
    if (!simulation) return {};
    return [simulation, count = static_cast<int>(steps)] {
      simulation->restart();
      simulation->advance(count);
      return simulation->spin(0).q;
    };
  };
  return {stepper.software, stepper.name, Knob::steps, prepare, stepper.roundings};
}

std::vector<Curve> work_precision(const Problem& problem, const std::vector<Method>& methods,
                                  const Budget& budget) {
  std::vector<Entrant> entrants;
  for (const Method& method : methods)
    if (method.prepare(problem, coarsest(method.knob, problem)))
      entrants.push_back(entrant(problem, method));
  return speed_against_error(problem.name, entrants, budget);
}

}  // namespace tumble::bench
