#pragma once
/// @file
/// How a loop over very many things is run.

#include "tumble/simd/instruction_set.hpp"

namespace tumble::simd {

/// @addtogroup simd
/// @{

/// Threads and instructions of a loop. The result does not depend on the threads, and on the
/// instructions only by rounding.
struct LoopOptions {
  int threads = 1;  ///< at least 1
  simd::InstructionSet instructions = simd::best_instruction_set();
};

/// @}

}  // namespace tumble::simd
