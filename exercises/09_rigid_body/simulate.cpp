#include "contract.hpp"

namespace rigid_body {

// 9.5 simulate: a body in motion.
// What is demanded stands in contract.hpp. Ask: ./tumble hint 9.5 · Be judged: ./tumble check 9.5
std::vector<State> simulate(const Body& body, const WrenchAt& wrench, const State& start, double t0,
                            double t1, int steps) {
  throw NotImplemented{};
}

}  // namespace rigid_body
