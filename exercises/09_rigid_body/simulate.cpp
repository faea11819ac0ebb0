#include "contract.hpp"

namespace rigid_body {

// 9.5 simulate: a body in motion.
// contract.hpp says what to write. Stuck? ./tumble hint 9.5 · Done? ./tumble check 9.5
std::vector<State> simulate(const Body& body, const WrenchAt& wrench, const State& start, double t0,
                            double t1, int steps) {
  throw NotImplemented{};
}

}  // namespace rigid_body
