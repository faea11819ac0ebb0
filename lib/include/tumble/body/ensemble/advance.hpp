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

/// Does something with a Pack: a kernel for simd::dispatch().
template <class P, class Action>
struct WithPack {
  const Action& action;  // inlined always

  template <class Q, Fma>
  TUMBLE_INLINE void run() const {
    if constexpr (std::is_same_v<P, Q>) action();
  }
};

/// Takes the steps of some bodies. What is computed for a Pack is code that exists once: see
/// TUMBLE_ONE_COPY.
template <class Method, class... Forces>
class Advance {
 public:
  Advance(Ensemble& bodies, const FixedSteps& steps, const Forces&... forces)
      : bodies_(bodies), steps_(steps), forces_(forces...) {}

  /// Of those in the structures of eight begin … end − 1.
  LostBodies operator()(std::size_t begin, std::size_t end) const {
    LostBodies lost;
    for (std::size_t at = begin; at < end; at += in_turn) {
      const std::size_t eights = std::min(end - at, in_turn);
      if (steps_.loop.instructions == simd::InstructionSet::avx512)
        advance<simd::EightDoubles>(at, eights, lost);
      else
        advance<simd::FourDoubles>(at, eights, lost);
    }
    return lost;
  }

 private:
  /// Where a Pack is: the structure of eight and the lane of its first body.
  struct Place {
    std::size_t at;
    int lane;
    std::size_t body() const { return eight * at + static_cast<std::size_t>(lane); }
  };

  template <class P>
  void advance(std::size_t first, std::size_t eights, LostBodies& lost) const {
    constexpr std::size_t packs_in_eight = eight / simd::lanes<P>;
    Stepper<Method, P, LawsOf<P, Forces...>> steppers[in_turn * packs_in_eight];
    const std::size_t packs = eights * packs_in_eight;
    const auto place = [first](std::size_t i) {
      return Place{first + i / packs_in_eight,
                   static_cast<int>(i % packs_in_eight) * simd::lanes<P>};
    };
    for (std::size_t i = 0; i < packs; ++i) begin_steps<P>(place(i), steppers[i]);
    for (int k = 0; k < steps_.count; ++k)
      for (std::size_t i = 0; i < packs; ++i) step<P>(steppers[i], steps_.t0 + k * steps_.h);
    for (std::size_t i = 0; i < packs; ++i) end_steps<P>(place(i), steppers[i], lost);
  }

  template <class P, class Action>
  void with_pack(const Action& action) const {
    dispatch(steps_.loop.instructions, WithPack<P, Action>{action});
  }

  template <class P>
  void begin_steps(const Place& place, auto& stepper) const {
    with_pack<P>([&]() __attribute__((always_inline)) {
      const auto& [at, lane] = place;
      const EightBodies& from = bodies_.bodies()[at];
      const PackBody<P> body{place.body(), load<P>(from.mass, lane), load<P>(from.moments, lane),
                             load<P>(from.asymmetry, lane), load<P>(from.axes, lane)};
      stepper.begin(bodies_.motions()[at], lane, body, forces_, steps_.h);
    });
  }

  template <class P>
  void step(auto& stepper, double t) const {
    with_pack<P>([&stepper, t ]() __attribute__((always_inline)) { stepper.step(t); });
  }

  template <class P>
  void end_steps(const Place& place, const auto& stepper, LostBodies& lost) const {
    EightMotions& motion = bodies_.motions()[place.at];
    P finite;
    with_pack<P>([&]() __attribute__((always_inline)) {
      stepper.end(motion, place.lane, steps_.h, steps_.count);
      finite = nan_unless_finite<P>(motion, place.lane);
    });
    for (int i = 0; i < simd::lanes<P>; ++i) {
      const std::size_t body = place.body() + static_cast<std::size_t>(i);
      if (finite[i] != 0 && body < bodies_.size()) lost.add(body);
    }
  }

  Ensemble& bodies_;
  const FixedSteps& steps_;
  std::tuple<const Forces&...> forces_;
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
  const ensemble::Advance<Chosen, Forces...> take_steps(bodies, all, forces...);
  constexpr std::size_t chunk = 4 * ensemble::in_turn;
  const std::size_t eights = bodies.bodies().size(), chunks = (eights + chunk - 1) / chunk;
  LostBodies lost;
  std::mutex losing;
  parallel_for(static_cast<int>(chunks), steps.loop.threads, [&](int i) {
    const std::size_t begin = chunk * static_cast<std::size_t>(i);
    const LostBodies here = take_steps(begin, std::min(begin + chunk, eights));
    if (here.count == 0) return;
    const std::lock_guard lock(losing);
    lost += here;
  });
  return lost;
}

}  // namespace tumble
