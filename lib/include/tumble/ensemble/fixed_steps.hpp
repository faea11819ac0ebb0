#pragma once
/// @file
/// Which steps an ensemble takes.

#include <algorithm>
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
  simd::LoopOptions loop = {};  ///< no more threads are started than there is work for
};

namespace detail::ensembles {

/// Of the threads that are allowed, as many as gain time: starting one takes as long as some 10⁴
/// steps of a body.
inline int worthwhile_threads(std::size_t bodies, const FixedSteps& steps) {
  constexpr double per_start = 1e4;
  const double work = static_cast<double>(bodies) * steps.count / per_start;
  return static_cast<int>(std::clamp(work, 1.0, static_cast<double>(steps.loop.threads)));
}

/// @throws std::invalid_argument as advance() does
template <class... Forces>
void require_valid_steps([[maybe_unused]] std::size_t bodies, const FixedSteps& steps,
                         const Forces&... forces) {
  require(std::isfinite(steps.h) && std::isfinite(steps.t0), "advance: the step is ", steps.h,
          " s and the time ", steps.t0, " s, but both must be finite");
  constexpr double shortest = 1e-150;  // of which h² is a double
  require(steps.h == 0 || std::abs(steps.h) >= shortest, "advance: the step is ", steps.h,
          " s. It must be 0, or at least ", shortest, " s long: the square of a shorter one is 0");
  require(steps.count >= 0, "advance: the number of steps is ", steps.count, ", less than 0");
  require(steps.loop.threads >= 1, "advance: the number of threads is ", steps.loop.threads,
          ", not positive");
  require(steps.loop.instructions <= simd::best_instruction_set(),
          "advance: this processor lacks the instruction set that you asked for");
  (require_valid_forces(forces, bodies), ...);
}

}  // namespace detail::ensembles

/// @}

}  // namespace tumble
