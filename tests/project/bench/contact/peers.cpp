#include "project/bench/contact/contest.hpp"
#include "project/bench/peer_modules.hpp"

namespace tumble::bench {

void add_peers(std::vector<Stepper>& steppers) { add_modules(TUMBLE_PEERS, steppers); }

}  // namespace tumble::bench
