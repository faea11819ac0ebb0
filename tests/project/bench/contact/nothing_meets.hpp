#pragma once
/// @file
/// What the question *can anything touch?* costs where nothing can.

#include "project/bench/speed_against_error.hpp"
#include "support/table.hpp"

namespace tumble::bench {

struct NothingMeets {
  support::Table table;
  std::string broken;  ///< what of ours is not as we promise; empty if all is
};

NothingMeets nothing_meets(const Budget& budget);

}  // namespace tumble::bench
