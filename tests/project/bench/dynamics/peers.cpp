#include "project/bench/dynamics/contest.hpp"
#include "project/bench/peer_modules.hpp"

namespace tumble::bench {

void add_peers(Contestants& contestants) { add_modules(TUMBLE_PEERS, contestants); }

}  // namespace tumble::bench
