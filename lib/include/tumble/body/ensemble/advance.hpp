#pragma once
/// @file
/// Steps of one size for a whole ensemble.
///
/// As many bodies at once as a Pack has lanes; a few Packs in turn, so that none waits for its own
/// last operation; and all the steps of these before the next ones: they stay in the innermost
/// cache, and memory is read and written once. The result of a body is the same, to the last bit,
/// wherever it stands, in whatever company, and with any number of threads.

#include <mutex>
#include <type_traits>

#include "tumble/body/ensemble/ensemble.hpp"
#include "tumble/body/ensemble/lost_bodies.hpp"
#include "tumble/body/ensemble/rk4.hpp"
#include "tumble/body/ensemble/taylor_magnus.hpp"
#include "tumble/core/loop_options.hpp"
#include "tumble/core/parallel.hpp"

namespace tumble {

/// Which steps, and how they are taken.
struct FixedSteps {
  double h;               ///< length [s], negative to go back in time
  int count;              ///< at least 0
  double t0 = 0;          ///< the time before the first [s], for forces that depend on it
  LoopOptions loop = {};  ///< a thread pays from some 10⁵ steps of a body on
};

namespace ensemble {

/// Structures of eight whose steps are taken in turn.
inline constexpr std::size_t in_turn = 4;

/// NaN in the lanes where a component is not finite, else 0.
template <class P>
TUMBLE_INLINE P nan_unless_finite(const EightMotions& motion, int lane) {
  P sum{};
  for (const Row& row : motion.q) sum += 0 * load<P>(row, lane);
  for (int k = 0; k < 3; ++k)
    sum += 0 * load<P>(motion.x[k], lane) + 0 * load<P>(motion.v[k], lane) +
           0 * load<P>(motion.omega[k], lane);
  return sum;
}

/// All steps of the structures of eight begin … end − 1: a kernel for simd::dispatch().
template <class Method, class... Forces>
struct Advance {
  Ensemble& bodies;
  const FixedSteps& steps;
  const std::tuple<const Forces&...>& forces;
  std::size_t begin, end;
  LostBodies& lost;

  template <class P, Fma>
  TUMBLE_INLINE void run() const {
    for (std::size_t at = begin; at < end; at += in_turn)
      advance<P>(at, static_cast<int>(std::min(end - at, in_turn)) * packs_in_eight<P>);
  }

 private:
  template <class P>
  static constexpr int packs_in_eight = eight / simd::lanes<P>;

  /// Where a Pack is: the structure of eight and the lane of its first body.
  struct Place {
    std::size_t at;
    int lane;
    std::size_t body() const { return eight * at + static_cast<std::size_t>(lane); }
  };

  template <class P>
  TUMBLE_INLINE void advance(std::size_t first, int packs) const {
    const auto place = [first](int i) __attribute__((always_inline)) {
      return Place{first + static_cast<std::size_t>(i / packs_in_eight<P>),
                   i % packs_in_eight<P> * simd::lanes<P>};
    };
    Stepper<Method, P, LawsOf<P, Forces...>> steppers[in_turn * packs_in_eight<P>];
    for (int i = 0; i < packs; ++i) begin_steps<P>(place(i), steppers[i]);
    for (int k = 0; k < steps.count; ++k)
      for (int i = 0; i < packs; ++i) steppers[i].step(steps.t0 + k * steps.h);
    for (int i = 0; i < packs; ++i) end_steps<P>(place(i), steppers[i]);
  }

  template <class P>
  TUMBLE_INLINE void begin_steps(const Place& place, auto& stepper) const {
    const auto& [at, lane] = place;
    const EightBodies& from = bodies.bodies()[at];
    const PackBody<P> body{place.body(), load<P>(from.mass, lane), load<P>(from.moments, lane),
                           load<P>(from.asymmetry, lane), load<P>(from.axes, lane)};
    stepper.begin(bodies.motions()[at], lane, body, forces, steps.h);
  }

  template <class P>
  TUMBLE_INLINE void end_steps(const Place& place, const auto& stepper) const {
    EightMotions& motion = bodies.motions()[place.at];
    stepper.end(motion, place.lane, steps.h, steps.count);
    const P finite = nan_unless_finite<P>(motion, place.lane);
    for (int i = 0; i < simd::lanes<P>; ++i) {
      const std::size_t body = place.body() + static_cast<std::size_t>(i);
      if (finite[i] != 0 && body < bodies.size()) lost.add(body);
    }
  }
};

/// The method for these forces if nobody asks for another one.
template <class... Forces>
using DefaultMethod =
    std::conditional_t<LawsOf<simd::FourDoubles, Forces...>::steady, TaylorMagnus<4>, Rk4>;

/// @throws std::invalid_argument as advance() does
template <class... Forces>
void check_steps([[maybe_unused]] std::size_t bodies, const FixedSteps& steps,
                 const Forces&... forces) {
  require(std::isfinite(steps.h) && std::isfinite(steps.t0), "advance: the step is ", steps.h,
          " s and the time ", steps.t0, " s, but both must be finite");
  require(steps.count >= 0, "advance: the number of steps is ", steps.count);
  require(steps.loop.threads >= 1, "advance: the number of threads is ", steps.loop.threads);
  (check_forces(forces, bodies), ...);
}

}  // namespace ensemble

/// Takes the steps with every body. A centre of mass that is pushed steadily (by anything but a
/// user's own force) takes none: it goes where it is at the end, exactly.
/// @tparam Method Rk4, with any force; TaylorMagnus<4>, <6> or <8>, with the library's own forces;
///                if none is named, TaylorMagnus<4> where it can be
/// @param forces each a Weight, BodyDrag or ForceAtBodyPoint for all bodies, a PerBody of such
///               forces, or a PackForce
/// @return the bodies that left the finite numbers; all the others are where they should be
/// @throws std::invalid_argument if the step, the time or a force is not finite, a drag is
/// negative,
///         the number of steps is negative, that of threads not positive, or there are not as many
///         forces as bodies
template <class Method = void, class... Forces>
[[nodiscard]] LostBodies advance(Ensemble& bodies, const FixedSteps& steps,
                                 const Forces&... forces) {
  using Chosen =
      std::conditional_t<std::is_void_v<Method>, ensemble::DefaultMethod<Forces...>, Method>;
  ensemble::check_steps(bodies.size(), steps, forces...);
  FixedSteps all = steps;
  if (steps.h == 0) all.h = 1, all.count = 0;  // h divides
  const std::tuple<const Forces&...> tied(forces...);
  constexpr std::size_t chunk = 4 * ensemble::in_turn;
  const std::size_t eights = bodies.bodies().size(), chunks = (eights + chunk - 1) / chunk;
  LostBodies lost;
  std::mutex losing;
  parallel_for(static_cast<int>(chunks), steps.loop.threads, [&](int i) {
    const std::size_t begin = chunk * static_cast<std::size_t>(i);
    LostBodies here;
    dispatch(steps.loop.instructions,
             ensemble::Advance<Chosen, Forces...>{bodies, all, tied, begin,
                                                  std::min(begin + chunk, eights), here});
    if (here.count == 0) return;
    const std::lock_guard lock(losing);
    lost += here;
  });
  return lost;
}

}  // namespace tumble
