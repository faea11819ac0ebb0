// expect: threw
// The first state is read, also where there is none.
#include <algorithm>
#include <cmath>

#include "contract.hpp"

namespace only_what_a_scene_needs {

namespace {

double energy(const Body& body, const State& state) {
  const rigid_body::Derived now = rigid_body::derived(body, state);
  // E = ½ P·v + ½ L·ω
  return (state.P.dot(now.v) + state.L.dot(now.omega)) / 2;
}

}  // namespace

EnergyDrift energy_drift(const Body& body, const std::vector<State>& states, double h) {
  const double first = energy(body, states.at(0));
  if (first == 0) return {0, 0};  // at rest, for ever

  double largest = 0, above = 0, below = 0;
  const double middle = (static_cast<double>(states.size()) - 1) / 2;
  double n = 0;
  for (const State& state : states) {
    // eₙ = (Eₙ − E₀)/E₀
    const double e = (energy(body, state) - first) / first;
    largest = std::max(largest, std::abs(e));
    // slope = Σ (n − n̄) eₙ / (h Σ (n − n̄)²)
    above += (n - middle) * e;
    below += (n - middle) * (n - middle);
    ++n;
  }
  return {largest, below > 0 ? above / below / h : 0};
}

}  // namespace only_what_a_scene_needs
