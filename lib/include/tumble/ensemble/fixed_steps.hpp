#pragma once
/// @file
/// Which steps an ensemble takes.

#include <cmath>

#include "tumble/core/require.hpp"
#include "tumble/ensemble/force_of.hpp"
#include "tumble/simd/loop_options.hpp"

namespace tumble {

/// @addtogroup ensemble
/// @{

/// Which steps, and how they are taken.
struct FixedSteps {
  double h;                     ///< length [s], negative to go back in time
  int count;                    ///< at least 0
  double t0 = 0;                ///< the time before the first [s], for forces that depend on it
  simd::LoopOptions loop = {};  ///< starting a thread takes the time of some 10⁴ steps of a body
};

namespace detail::ensembles {

/// @throws std::invalid_argument as advance() does
template <class... Forces>
void require_valid_steps([[maybe_unused]] std::size_t bodies, const FixedSteps& steps,
                         const Forces&... forces) {
  require(std::isfinite(steps.h) && std::isfinite(steps.t0), "advance: the step is ", steps.h,
          " s and the time ", steps.t0, " s, but both must be finite");
  require(steps.count >= 0, "advance: the number of steps is ", steps.count);
  require(steps.loop.threads >= 1, "advance: the number of threads is ", steps.loop.threads);
  require(steps.loop.instructions <= simd::best_instruction_set(),
          "advance: this processor does not have the instructions that were asked for");
  (require_valid_forces(forces, bodies), ...);
}

}  // namespace detail::ensembles

/// @}

}  // namespace tumble
