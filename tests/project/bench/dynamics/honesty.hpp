#pragma once
/// @file
/// What simulate() says of its error, on many random scenes, beside what is true.

#include <string>

#include "support/table.hpp"

namespace tumble::bench {

struct Honesty {
  support::Table table;
  int unknown;         ///< scenes whose truth is not known well enough
  std::string broken;  ///< what is not as we promise; empty if all is
};

/// Scenes number 1, 2, … of the same kind as those of the test.
Honesty honesty(int scenes);

}  // namespace tumble::bench
