#include "project/bench/dynamics/long_run.hpp"

#include <algorithm>
#include <iostream>

namespace tumble::bench {
namespace {

/// What a free body keeps.
struct Invariants {
  double energy;  ///< [J]
  Vec3 L;         ///< world [kg m²/s]
};

Invariants invariants(const Body& body, const Spin& spin) {
  const Vec3 L_body = body.moments.cwiseProduct(spin.omega);
  return {L_body.dot(spin.omega) / 2, spin.q.normalized() * L_body};
}

struct Drift {
  double energy = 0, L = 0;  ///< largest relative errors
  int blown_up = 0;          ///< the step at which it did, 0 if it did not
};

/// A hundred times the energy that there is: it will not come back.
constexpr double blow_up = 100;

Drift drift(const Scene& scene, Simulation& simulation, int steps) {
  const Body& body = scene.bodies.front();
  const Invariants start = invariants(body, body.start);
  Drift drift;
  simulation.restart();
  for (int i = 1; i <= steps; ++i) {
    simulation.advance(1);
    const Invariants now = invariants(body, simulation.spin(0));
    const double energy = std::abs(now.energy / start.energy - 1);
    if (!(energy < blow_up)) {
      drift.blown_up = i;
      return drift;
    }
    drift.energy = std::max(drift.energy, energy);
    drift.L = std::max(drift.L, (now.L - start.L).norm() / start.L.norm());
  }
  return drift;
}

/// What all of ours promise for a million steps, those of order 4 too.
bool kept(const Drift& drift, double h) {
  const double most = h > 0.01 ? 2e-6 : 2e-9;
  return drift.blown_up == 0 && drift.energy <= most && drift.L <= most;
}

void add_cells(std::vector<std::string>& row, const Drift& drift) {
  if (drift.blown_up) {
    row.insert(row.end(), {"blows up at step", std::to_string(drift.blown_up)});
  } else {
    row.insert(row.end(), {support::error_number(drift.energy), support::error_number(drift.L)});
  }
}

}  // namespace

LongRun long_run(const Problem& free, const std::vector<Stepper>& steppers, int steps) {
  LongRun all{support::Table({"method", "1/60 s: energy", "L", "1/240 s: energy", "L"}), {}};
  for (const Stepper& stepper : steppers) {
    std::vector<std::string> row = {stepper.software + ", " + stepper.name};
    std::cerr << "tumble: long: " << row.front() << '\n';
    for (const double h : {1.0 / 60, 1.0 / 240})
      if (const auto simulation = stepper.make(free.scene, h)) {
        const Drift found = drift(free.scene, *simulation, steps);
        add_cells(row, found);
        if (stepper.software == "tumble" && !kept(found, h))
          all.broken += "; " + stepper.name + " in steps of " + support::number(h);
      }
    if (row.size() == 5) all.table.add(row);
  }
  return all;
}

}  // namespace tumble::bench
