#pragma once
/// @file
/// Steps by the classical Runge–Kutta method, with any force.
///
/// Where the forces push steadily the turning alone is integrated, 7 numbers. A user's own force
/// may depend on everything: then x and u = h v go along. After each step q gets back its length,
/// of which the method takes (½|b|)⁶/144, by a step of Newton's method: 9 operations of some 140
/// and no root, and forces that turn with the body need a unit quaternion.
/// Source: Kutta (1901), see ode/rk4.hpp.

#include "tumble/ensemble/stepper.hpp"
#include "tumble/ode/rk4.hpp"

namespace tumble::detail::ensembles {

/// The turning and the path of some bodies.
template <class P>
struct SpinAndPath {
  Spin<P> spin;
  Point<P> x;  ///< [m]
  Point<P> u;  ///< h v [m]
};

/// y + s rate. As q of a rate counts q ⟨0, b⟩, twice its rate.
template <class P>
TUMBLE_INLINE Spin<P> add_scaled(const Spin<P>& y, double s, const Spin<P>& rate) {
  return {add_scaled(y.q, s / 2, rate.q), add_scaled(y.b, s, rate.b)};
}
template <class P>
TUMBLE_INLINE SpinAndPath<P> add_scaled(const SpinAndPath<P>& y, double s,
                                        const SpinAndPath<P>& rate) {
  return {add_scaled(y.spin, s, rate.spin), add_scaled(y.x, s, rate.x), add_scaled(y.u, s, rate.u)};
}

/// y a step later. @param rate rate(y, s) at the fraction s of the step
template <class State, class Rate>
TUMBLE_INLINE State runge_kutta_4(const State& y, const Rate& rate) {
  const State k1 = rate(y, 0.0);
  const State k2 = rate(add_scaled(y, 0.5, k1), 0.5);
  const State k3 = rate(add_scaled(y, 0.5, k2), 0.5);
  const State k4 = rate(add_scaled(y, 1.0, k3), 1.0);
  return add_scaled(add_scaled(add_scaled(add_scaled(y, 1. / 6, k1), 1. / 3, k2), 1. / 3, k3),
                    1. / 6, k4);
}

/// By the method of Runge and Kutta.
template <class P, class Kernels>
class Stepper<Rk4, P, Kernels> {
 public:
  template <class Forces>
  TUMBLE_INLINE void begin(const EightMotions& from, int lane, const ensemble::PackBody<P>& body,
                           const Forces& forces, double h) {
    if constexpr (Kernels::steady)
      body_.asymmetry = body.asymmetry;  // nothing else is read from memory
    else
      body_ = body;
    kernels_.prepare(forces, body, h);
    now_.spin = load_spin<P>(from.spins, lane, h);
    if constexpr (!Kernels::steady) begin_path(from.paths, lane, h);
    begin_ = now_;
  }

  TUMBLE_INLINE void step(double t) {
    if constexpr (Kernels::steady) {
      const auto rate = [&](const Spin<P>& y, double) __attribute__((always_inline)) {
        return spin_rate(y);
      };
      now_.spin = runge_kutta_4(now_.spin, rate);
    } else {
      const auto rate = [&](const SpinAndPath<P>& y, double s) __attribute__((always_inline)) {
        return whole_rate(t + s * h_, y);
      };
      now_ = runge_kutta_4(now_, rate);
    }
    now_.spin.q = nearly_normalised(now_.spin.q);
  }

  TUMBLE_INLINE void end(const EightMotions& to, int lane, double h, int steps) const {
    store_spin(now_.spin, begin_.spin.b, to.spins, lane, h);
    if constexpr (Kernels::steady) {
      store_drift<P>(kernels_, to.paths, lane, h * steps);
    } else {
      store(now_.x, to.paths.x, lane);
      store(changed(load<P>(to.paths.v, lane), begin_.u, now_.u, h), to.paths.v, lane);
    }
  }

 private:
  TUMBLE_INLINE void begin_path(const EightPaths& from, int lane, double h) {
    now_.x = load<P>(from.x, lane);
    now_.u = h * load<P>(from.v, lane);
    h_ = h;
    per_mass_ = h * h / body_.mass;
    per_moments_ = quotient(P{} + h * h, body_.moments);
    kernels_.add_push(push_);
    push_ = {h * h * push_.acceleration, h * push_.drag};
  }

  TUMBLE_INLINE Spin<P> spin_rate(const Spin<P>& y) const {
    Point<P> rate = scaled_axes(body_.asymmetry, cyclic_products(y.b, y.b));
    kernels_.add_spin(y.q, y.b, rate);
    return {times_vector(y.q, y.b), rate};
  }

  TUMBLE_INLINE SpinAndPath<P> whole_rate(double t, const SpinAndPath<P>& y) const {
    const Quaternion<P> q = nearly_normalised(y.spin.q);
    const ensemble::PackKinematics<P> now{y.x, q * conjugate(body_.axes), 1 / h_ * y.u,
                                          1 / h_ * rotate(q, y.spin.b)};
    ensemble::PackWrench<P> wrench{};
    kernels_.add_wrench(t, body_, now, wrench);
    Spin<P> spin = spin_rate(y.spin);
    spin.b = spin.b + scaled_axes(per_moments_, rotate(conjugate(q), wrench.torque));
    return {spin, y.u, push_.acceleration - push_.drag * y.u + per_mass_ * wrench.force};
  }

  ensemble::PackBody<P> body_;
  Kernels kernels_;
  SpinAndPath<P> begin_, now_;  // without a path where the forces push steadily, as what follows:
  double h_;
  P per_mass_;            // h²/m
  Point<P> per_moments_;  // h²/I
  Push<P> push_;          // times h², drag times h
};

}  // namespace tumble::detail::ensembles
