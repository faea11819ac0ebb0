#pragma once
/// @file
/// Other software. Each is a module that is loaded beside the others, not linked with them:
/// Bullet's two precisions have the same names, and Simbody brings functions of SUNDIALS of its
/// own.

#include <sstream>
#include <string>

#include "support/module.hpp"

namespace tumble::bench {

/// Lets each module add what it has.
/// @param files with colons between them
template <class Contestants>
void add_modules(const std::string& files, Contestants& contestants) {
  std::istringstream names(files);
  for (std::string file; std::getline(names, file, ':');)
    support::Module(file).symbol<void(Contestants&)>("tumble_add_peer")(contestants);
}

}  // namespace tumble::bench
