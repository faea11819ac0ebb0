#pragma once
/// @file
/// Painlevé's rod: no finite force can explain its contact. What does each make of it?

#include "project/bench/contact/contest.hpp"
#include "support/table.hpp"

namespace tumble::bench {

struct Jamming {
  support::Table table;
  std::string broken;  ///< what of ours is not as we promise; empty if all is
};

Jamming jamming(const std::vector<Stepper>& steppers);

}  // namespace tumble::bench
