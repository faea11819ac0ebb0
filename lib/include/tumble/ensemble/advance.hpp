#pragma once
/// @file
/// Steps of one size for a whole ensemble.
///
/// The result of a body is the same, to the last bit, wherever it is, in whatever company, and
/// with any number of threads.

#include <type_traits>

#include "tumble/core/parallel.hpp"
#include "tumble/ensemble/packs_in_turn.hpp"
#include "tumble/ensemble/rk4.hpp"
#include "tumble/ensemble/taylor_magnus.hpp"

namespace tumble {

/// @addtogroup ensemble
/// @{

namespace detail::ensembles {

/// The method for these forces if nobody asks for another one.
template <class... Forces>
using DefaultMethod =
    std::conditional_t<ForceKernelsOf<simd::FourDoubles, Forces...>::steady, TaylorMagnus<4>, Rk4>;

}  // namespace detail::ensembles

/// Takes the steps with every body. A centre of mass that is pushed steadily (by anything but a
/// user's own force) takes none: it goes where it is at the end, exactly.
/// @tparam Method Rk4, with any force; TaylorMagnus<4>, <6> or <8>, with the library's own forces;
///                if none is named, TaylorMagnus<4> where it can be
/// @param forces each a Weight, BodyDrag or ForceAtBodyPoint for all bodies, a PerBody of such
///               forces, or a PackForce
/// @return the bodies that left the finite numbers; all the others are where they should be
/// @throws std::invalid_argument if the step, the time or a force is not finite, the step not 0 and
///         below 1e-150 s, a drag or the number of steps is negative, that of
///         threads not positive, the processor does not have the instructions, or there are not as
///         many forces as bodies
template <class Method = void, class... Forces>
[[nodiscard]] LostBodies advance(Ensemble& bodies, const FixedSteps& steps,
                                 const Forces&... forces) {
  using Chosen = std::conditional_t<std::is_void_v<Method>,
                                    detail::ensembles::DefaultMethod<Forces...>, Method>;
  detail::ensembles::require_valid_steps(bodies.size(), steps, forces...);
  FixedSteps all = steps;
  if (steps.h == 0) {  // h divides
    all.h = 1;
    all.count = 0;
  }
  constexpr bool fall_alike =
      detail::ensembles::ForceKernelsOf<simd::FourDoubles, Forces...>::fall_alike;
  if constexpr (!fall_alike) bodies.write_paths();
  const detail::ensembles::PacksInTurn<Chosen, Forces...> take_steps(bodies, all, forces...);
  constexpr std::size_t chunk = 4 * detail::ensembles::in_turn;
  const std::size_t eights = bodies.bodies().size(), chunks = (eights + chunk - 1) / chunk;
  LostBodies lost;
  detail::OneAtATime losing;
  const int threads = detail::ensembles::worthwhile_threads(bodies.size(), all);
  detail::parallel_for(static_cast<int>(chunks), threads, [&](int i) {
    const std::size_t begin = chunk * static_cast<std::size_t>(i);
    const LostBodies here = take_steps(begin, std::min(begin + chunk, eights));
    if (here.count == 0) return;
    losing([&] { lost += here; });
  });
  if constexpr (fall_alike) {
    bodies.fall(all.h * all.count, (Vec3::Zero() + ... + forces.g));
    return bodies.lost_by_falling(lost);
  }
  return lost;
}

/// @}

}  // namespace tumble
