#pragma once
/// @file
/// What takes the steps of a Pack of bodies, by some method; and how their centres of mass go where
/// the forces do not depend on the way: without steps.

#include "tumble/ensemble/force_kernel_list.hpp"
#include "tumble/ensemble/spin.hpp"

namespace tumble::detail::ensembles {

/// The motion of a Pack of bodies between memory and memory: begin(), then a step() for each step,
/// then end(). Specialised for each method.
template <class Method, class P, class Kernels>
class Stepper;

/// The path over the time T [s] under forces that push steadily; of bodies that all fall alike it
/// is not written: see CommonFall.
template <class P, class Kernels>
TUMBLE_INLINE void store_drift([[maybe_unused]] const Kernels& kernels,
                               [[maybe_unused]] EightPaths& to, [[maybe_unused]] int lane,
                               [[maybe_unused]] double T) {
  if constexpr (Kernels::fall_alike) return;
  Push<P> push;
  kernels.add_push(push);
  Point<P> x = load<P>(to.x, lane), v = load<P>(to.v, lane);
  drift<Kernels::drags>(x, v, push, T);
  store(x, to.x, lane);
  store(v, to.v, lane);
}

}  // namespace tumble::detail::ensembles
