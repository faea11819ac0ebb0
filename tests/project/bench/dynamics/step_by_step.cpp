#include "project/bench/dynamics/step_by_step.hpp"

#include "project/bench/dynamics/as_rigid_body.hpp"
#include "project/bench/dynamics/problems.hpp"
#include "project/bench/least_times.hpp"
#include "tumble/ensemble/advance.hpp"

namespace tumble::bench {
namespace {

constexpr double h = 1. / 240;

Ensemble ensemble_of(const Scene& scene) {
  std::vector<RigidBody<>> bodies;
  std::vector<RigidBodyState<>> states;
  for (const Body& body : scene.bodies) {
    bodies.push_back(rigid_body(body));
    states.push_back(start_of(body));
  }
  return {bodies, states};
}

Timed calls(Ensemble& bodies, int steps, const Budget& budget) {
  return {
      [&bodies, steps] {
        require(advance(bodies, {h, steps}, Weight{}).count == 0, "step by step: bodies were lost");
        return bodies.state(0).q.w();
      },
      budget.repetitions, budget.seconds};
}

}  // namespace

support::Table step_by_step(std::size_t most, const Budget& budget) {
  constexpr int hundred = 100;
  support::Table table({"bodies", "ns per body and step", "a hundred steps a call", "ratio"});
  for (std::size_t n = 1000; n <= most; n *= 10) {
    Ensemble bodies = ensemble_of(crowd(static_cast<int>(n)));
    const std::vector<double> seconds =
        least_times({calls(bodies, 1, budget), calls(bodies, hundred, budget)});
    const double one = seconds[0] / static_cast<double>(n),
                 many = seconds[1] / static_cast<double>(n) / hundred;
    table.add({std::to_string(n), support::number(one * 1e9, 3), support::number(many * 1e9, 3),
               support::number(one / many, 3)});
  }
  return table;
}

}  // namespace tumble::bench
