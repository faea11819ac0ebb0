// Other software, from step to step.
#include <cmath>

#include "project/bench/contact/problem.hpp"

namespace tumble::bench {

Entrant stepping(const Problem& problem, const Stepper& stepper) {
  const auto prepare = [&problem, &stepper](double setting) -> Attempt {
    const int steps = static_cast<int>(setting);
    const double h = problem.duration / steps;
    const std::shared_ptr<Simulation> simulation = stepper.make(problem.scene, h);
    return {[simulation, steps] {
              simulation->restart();
              simulation->advance(steps);
              return simulation->motion(0).x.z();
            },
            [simulation, steps, h, &problem] {
              simulation->restart();
              return problem.question.of_steps(*simulation, h, steps);
            }};
  };
  constexpr double pictures = 60;  // per second
  const double coarsest = std::ceil(pictures * problem.duration);
  return {stepper.software, stepper.name, Knob::steps, coarsest, prepare};
}

}  // namespace tumble::bench
