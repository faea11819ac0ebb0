// expect: wrong | named never normalised
// q is normalised in a copy.
#include "contract.hpp"

namespace rigid_body {

std::vector<State> simulate(const Body& body, const WrenchAt& wrench, const State& start, double t0,
                            double t1, int steps) {
  const particles::Rhs f = [&](double t, const Eigen::VectorXd& y) -> Eigen::VectorXd {
    return dydt(body, wrench, t, y);
  };
  const double h = (t1 - t0) / steps;
  std::vector<State> states{start};
  for (int n = 0; n < steps; ++n) {
    State state = unpack(particles::rk4_step(f, t0 + n * h, pack(states.back()), h));
    // Rounding and the method's error have changed the length of q: q ← q/|q|
    state.q.normalized();
    states.push_back(state);
  }
  return states;
}

}  // namespace rigid_body
