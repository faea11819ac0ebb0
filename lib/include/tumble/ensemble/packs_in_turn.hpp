#pragma once
/// @file
/// The loop over steps and bodies.
///
/// As many bodies at once as a Pack has lanes; a few Packs in turn, so that none waits for its own
/// last operation; and all the steps of these before the next ones: they stay in the innermost
/// cache, and memory is read and written once.

#include <type_traits>

#include "tumble/ensemble/ensemble.hpp"
#include "tumble/ensemble/fixed_steps.hpp"
#include "tumble/ensemble/lost_bodies.hpp"
#include "tumble/ensemble/stepper.hpp"

namespace tumble::detail::ensembles {

/// Structures of eight whose steps are taken in turn.
inline constexpr std::size_t in_turn = 4;

/// NaN in the lanes where a component is not finite, else 0.
template <class P>
TUMBLE_INLINE P nan_unless_finite(const EightSpins& spins, int lane) {
  P sum{};
  for (const Row& row : spins.q) sum += 0 * load<P>(row, lane);
  for (const Row& row : spins.omega) sum += 0 * load<P>(row, lane);
  return sum;
}
template <class P>
TUMBLE_INLINE P nan_unless_finite(const EightPaths& paths, int lane) {
  P sum{};
  for (int k = 0; k < 3; ++k) sum += 0 * load<P>(paths.x[k], lane) + 0 * load<P>(paths.v[k], lane);
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

/// Takes the steps of some bodies. What is computed for a Pack is code that exists once, for all of
/// them: see TUMBLE_ONE_COPY.
template <class Method, class... Forces>
class PacksInTurn {
 public:
  PacksInTurn(Ensemble& bodies, const FixedSteps& steps, const Forces&... forces)
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
    Stepper<Method, P, ForceKernelsOf<P, Forces...>> steppers[in_turn * packs_in_eight];
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
      const EightMotions motions = bodies_.motions(at);
      const ensemble::PackBody<P> body{
          place.body(), load<P>(from.mass, lane), load<P>(from.moments, lane),
          load<P>(motions.spins.asymmetry, lane), load<P>(from.axes, lane)};
      stepper.begin(motions, lane, body, forces_, steps_.h);
    });
  }

  template <class P>
  void step(auto& stepper, double t) const {
    with_pack<P>([&stepper, t ]() __attribute__((always_inline)) { stepper.step(t); });
  }

  template <class P>
  void end_steps(const Place& place, const auto& stepper, LostBodies& lost) const {
    const EightMotions motions = bodies_.motions(place.at);
    P finite;
    with_pack<P>([&]() __attribute__((always_inline)) {
      stepper.end(motions, place.lane, steps_.h, steps_.count);
      finite = nan_unless_finite<P>(motions.spins, place.lane);
      if constexpr (!ForceKernelsOf<P, Forces...>::fall_alike)
        finite += nan_unless_finite<P>(motions.paths, place.lane);
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

}  // namespace tumble::detail::ensembles
