#include "project/bench/contact/crowd.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>

#include "project/bench/contact/bodies.hpp"
#include "project/bench/contact/problem.hpp"
#include "project/bench/least_times.hpp"
#include "support/random.hpp"
#include "support/stopwatch.hpp"

namespace tumble::bench {
namespace {

constexpr double ball_radius = 0.05, speed = 1;
constexpr double h = 0.1 * ball_radius / speed;  // [s], of those that take steps

/// On a lattice, each moved by as much as keeps them apart.
Scene balls_in_room(int count) {
  const double volume = 4. / 3 * std::acos(-1.) * std::pow(ball_radius, 3);
  const double size = std::cbrt(count * volume / 0.15);
  const int side = static_cast<int>(std::ceil(std::cbrt(count) - 1e-9));
  const double spacing = size / side, jitter = 0.45 * (spacing - 2 * ball_radius);
  support::Random random(11);
  Scene scene;
  scene.walls = room(Vec3::Constant(size));
  for (int i = 0; i < count; ++i) {
    const Vec3 place(i % side, i / side % side, i / side / side);
    const Vec3 x = spacing * (place + Vec3::Constant(0.5)) - Vec3::Constant(size / 2);
    scene.bodies.push_back(
        ball(ball_radius, 1, x + random.vector(jitter), speed * random.direction()));
  }
  return scene;
}

/// A crowd, simulated by ours as far as it takes for so many collisions.
struct Ours {
  contact::ContactScene scene;
  contact::ContactSettings settings;
  contact::ContactRun run;

  double per_second() const { return static_cast<double>(run.impacts.size()) / run.t; }
};

Ours ours(const Scene& scene) {
  const int bodies = static_cast<int>(scene.bodies.size());
  Ours made{contact_scene(scene), {.until = 1e3, .max_impacts = std::max(2000, 5 * bodies)}, {}};
  made.run = simulate_contacts(made.scene, made.settings);
  return made;
}

/// By how much the two that overlap most do [m].
double overlap(const Ours& all) {
  std::vector<collide::Bounds> bounds;
  std::vector<Vec3> places;
  for (int i = 0; i < static_cast<int>(all.scene.bodies.size()); ++i) {
    places.push_back(all.run.state(all.scene, i, all.run.t).x);
    bounds.push_back(
        {places.back() - Vec3::Constant(ball_radius), places.back() + Vec3::Constant(ball_radius)});
  }
  double most = 0;
  for (const auto& [i, j] : collide::overlapping_pairs(bounds)) {
    const Vec3 apart = places[static_cast<std::size_t>(i)] - places[static_cast<std::size_t>(j)];
    most = std::max(most, 2 * ball_radius - apart.norm());
  }
  return most;
}

std::string broken_promises(const Ours& all) {
  const auto impacts = static_cast<double>(all.run.impacts.size());
  const auto name = [&] { return "; " + std::to_string(all.scene.bodies.size()) + " balls: "; };
  std::string broken;
  if (all.run.ending != contact::Ending::too_many_events) broken += name() + "the run ended early";
  if (overlap(all) > 2 * all.settings.tolerance)
    broken += name() + "they overlap by " + support::error_number(overlap(all)) + " m";
  // Some tens of roundings of the energy of two balls in each impact.
  const double strays = std::abs(all.run.energy.end / all.run.energy.start - 1);
  const double allowed = 100 * std::numeric_limits<double>::epsilon() * impacts;
  if (strays > allowed)
    broken += name() + "their energy strays by " + support::error_number(strays);
  return broken;
}

/// What is timed, and how to say it.
struct Row {
  std::string name;
  std::function<double()> run;
  double body_steps;  ///< of one run; of ours none
  double collisions;  ///< of one run
  double seconds = 0;
};

Row own_row(const Ours& all) {
  return {"tumble, all in order",
          [&all] { return simulate_contacts(all.scene, all.settings).energy.end; }, 0,
          static_cast<double>(all.run.impacts.size())};
}

/// As many steps as fit, at least one.
Row row(const Stepper& stepper, const std::shared_ptr<Simulation>& simulation, const Ours& all,
        const Budget& budget) {
  simulation->restart();
  simulation->advance(3);
  const double once = support::shortest_run(0, [&] { simulation->advance(3); }) / 3;
  const int steps = std::clamp(static_cast<int>(budget.longest_of_others / once / 2), 1, 200);
  const auto bodies = static_cast<double>(all.scene.bodies.size());
  return {stepper.software + ", " + stepper.name,
          [simulation, steps] {
            simulation->advance(steps);
            return simulation->motion(0).x.z();
          },
          bodies * steps, all.per_second() * steps * h};
}

std::vector<Row> rows(const Scene& scene, const Ours& all, const std::vector<Stepper>& steppers,
                      const Budget& budget) {
  std::vector<Row> made = {own_row(all)};
  for (const Stepper& stepper : steppers) {
    std::cerr << "tumble: crowd of " << scene.bodies.size() << ": " << stepper.software << '\n';
    if (const std::shared_ptr<Simulation> simulation = stepper.make(scene, h))
      made.push_back(row(stepper, simulation, all, budget));
  }
  std::vector<Timed> timed;
  constexpr int times = 3;
  for (const Row& r : made)
    timed.push_back({r.run, std::min(times, budget.repetitions), budget.seconds, Clock::thread});
  const std::vector<double> seconds = least_times(timed);
  for (std::size_t i = 0; i < made.size(); ++i) made[i].seconds = seconds[i];
  return made;
}

std::string growth_text(const std::vector<int>& sizes, const std::vector<double>& costs) {
  const double grown = costs.back() / costs.front();
  const double logs = std::log2(sizes.back()) / std::log2(sizes.front());
  return "A collision among " + std::to_string(sizes.back()) + " costs " +
         support::number(grown, 2) + " times what it costs among " + std::to_string(sizes.front()) +
         "; log n has grown by " + support::number(logs, 2) + '\n';
}

}  // namespace

Crowd crowd(const std::vector<int>& sizes, const std::vector<Stepper>& steppers,
            const Budget& budget) {
  Crowd made{support::Table({"balls", "method", "µs per collision", "µs per body and step",
                             "× with " + std::to_string(sizes.front())}),
             {},
             {}};
  std::map<std::string, double> first;
  std::vector<double> own_costs;
  for (const int size : sizes) {
    const Scene scene = balls_in_room(size);
    const Ours all = ours(scene);
    made.broken += broken_promises(all);
    for (const Row& r : rows(scene, all, steppers, budget)) {
      const double cost = r.body_steps > 0 ? r.seconds / r.body_steps : r.seconds / r.collisions;
      first.emplace(r.name, cost);
      if (r.body_steps == 0) own_costs.push_back(cost);
      made.table.add({std::to_string(size), r.name, support::number(1e6 * r.seconds / r.collisions),
                      r.body_steps > 0 ? support::number(1e6 * cost) : "–",
                      support::number(cost / first.at(r.name), 2)});
    }
  }
  made.growth = growth_text(sizes, own_costs);
  return made;
}

}  // namespace tumble::bench
