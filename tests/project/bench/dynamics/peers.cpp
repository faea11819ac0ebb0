// The other software. Each is a module that is loaded beside the others, not linked with them:
// Bullet's two precisions have the same names, and Simbody brings functions of SUNDIALS of its own.
#include <sstream>

#include "project/bench/dynamics/contest.hpp"
#include "support/module.hpp"

namespace tumble::bench {
namespace {

void add_peer(Contestants& contestants, const std::string& file) {
  support::Module(file).symbol<decltype(tumble_add_peer)>("tumble_add_peer")(contestants);
}

}  // namespace

void add_peers(Contestants& contestants) {
  std::istringstream files(TUMBLE_PEERS);  // with colons between
  for (std::string file; std::getline(files, file, ':');) add_peer(contestants, file);
}

}  // namespace tumble::bench
