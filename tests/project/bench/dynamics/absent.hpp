#pragma once
/// @file
/// What is not there costs nothing: forces that a scene does not have, numbers that a body does not
/// need.

#include "project/bench/speed_against_error.hpp"
#include "support/table.hpp"

namespace tumble::bench {

/// Tables, and what of the promises was broken, in words; empty if nothing.
struct Absent {
  support::Table forces;  ///< steps of a body, the library's beside a right-hand side by hand
  support::Table rungs;   ///< each model: numbers of its state, and times
  std::string broken;
};

Absent absent(const Budget& budget);

}  // namespace tumble::bench
