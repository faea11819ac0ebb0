// The other software. Each is a module that is loaded beside the others, not linked with them:
// Bullet's two precisions have the same names, and Simbody brings functions of SUNDIALS of its own.
#include <dlfcn.h>

#include <sstream>

#include "project/bench/dynamics/contest.hpp"
#include "tumble/core/require.hpp"

namespace tumble::bench {
namespace {

void add_peer(Contestants& contestants, const std::string& file) {
  void* module = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  require(module != nullptr, "cannot load a peer: ", module ? "" : dlerror());
  const auto add = reinterpret_cast<decltype(&tumble_add_peer)>(dlsym(module, "tumble_add_peer"));
  require(add != nullptr, file, " is no peer");
  add(contestants);
}

}  // namespace

void add_peers(Contestants& contestants) {
  std::istringstream files(TUMBLE_PEERS);  // with colons between
  for (std::string file; std::getline(files, file, ':');) add_peer(contestants, file);
}

}  // namespace tumble::bench
