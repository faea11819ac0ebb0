// The library's own: simulate_contacts(), told the tolerance at which bodies touch.
#include "project/bench/contact/problem.hpp"

namespace tumble::bench {
namespace {

contact::ContactBody contact_body(const Body& b, std::size_t i) {
  const auto& [x, v, q, omega] = b.start;
  const RigidBody<> body(b.mass, b.moments.asDiagonal());
  const collide::Convex shape =
      b.form == Form::ball ? collide::Convex::ball(b.radius()) : collide::Convex::box(b.size);
  return {"body " + std::to_string(i), body, shape, state_of_motion<double>(body, x, q, v, omega)};
}

Motion motion_of(const RigidBody<>& body, const RigidBodyState<>& state) {
  const Derived<> now = derived(body, state);
  return {state.x, now.v, state.q, now.omega};
}

}  // namespace

contact::ContactScene contact_scene(const Scene& scene) {
  contact::ContactScene made;
  for (const Body& b : scene.bodies) made.bodies.push_back(contact_body(b, made.bodies.size()));
  for (const Wall& wall : scene.walls) made.walls.push_back({wall.point, wall.normal});
  made.gravity = scene.gravity;
  made.e = scene.e;
  made.mu = scene.mu;
  return made;
}

Question at_end(const Scene& scene, double duration, const EndError& error) {
  const auto of_steps = [error, count = scene.bodies.size()](Simulation& simulation, double,
                                                             int steps) {
    simulation.advance(steps);
    std::vector<Motion> all;
    for (std::size_t i = 0; i < count; ++i) all.push_back(simulation.motion(i));
    return error(all);
  };
  const auto of_run = [error, duration](const contact::ContactScene& bodies,
                                        const contact::ContactRun& run) {
    std::vector<Motion> all;
    for (int i = 0; i < static_cast<int>(bodies.bodies.size()); ++i)
      all.push_back(motion_of(bodies.body(i).body, run.state(bodies, i, duration)));
    return error(all);
  };
  return {of_steps, of_run};
}

Entrant own_method(const Problem& problem) {
  const auto prepare = [&problem](double tolerance) -> Attempt {
    const auto scene = std::make_shared<contact::ContactScene>(contact_scene(problem.scene));
    const auto run = [scene, tolerance, until = problem.duration] {
      return simulate_contacts(*scene, {.until = until, .tolerance = tolerance});
    };
    return {[run] { return run().energy.end; },
            [run, scene, &problem] { return problem.question.of_run(*scene, run()); }};
  };
  constexpr double coarsest = 1e-9;  // a coarser one saves next to nothing
  return {"tumble", "simulate_contacts", Knob::tolerance, coarsest, prepare, problem.promised};
}

}  // namespace tumble::bench
