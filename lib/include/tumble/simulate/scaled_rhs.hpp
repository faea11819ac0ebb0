#pragma once
/// @file
/// A body and any forces on it, in the units and axes of ScaledBody.
///
/// What the forces are is forgotten here. An evaluation then costs a call more, which is little
/// beside the rest of it, and a program compiles the solvers once and not for every force.

#include <functional>

#include "tumble/body/dydt.hpp"
#include "tumble/simulate/scaled_body.hpp"

namespace tumble::detail {

/// A right-hand side of a body under forces.
class ScaledRhs {
 public:
  using Numbers = PackedState<double>;
  using State = RigidBodyState<>;
  static constexpr auto why = "a force depends on where the body is or how it is turned";

  /// @param rhs  a RigidBodyRhs<double, …>
  /// @param t0   the start [s]
  /// @param span how long it will move [s]
  template <class Rhs>
  ScaledRhs(const Rhs& rhs, const State& start, double t0, double span)
      : unscaled_(rhs.body()),
        net_([rhs](double t, const Derived<>& now) { return rhs.net(t, now); }),
        body_(rhs.body(), units_of(rhs.body(), start, rhs.net(t0, start), span)) {}

  double lost_moments() const { return body_.lost_moments(); }
  Numbers numbers(const State& state) const { return body_.numbers(state); }
  State state(const Numbers& y) const { return body_.state(y); }
  double omega(const Numbers& y) const { return body_.omega(y); }

  /// The squares of the sizes that are too small to matter in a span of time.
  SquaredSizes<Numbers> least_squares(double span) const {
    return body_.squares(least_sizes(unscaled_, span));
  }

  /// All that the forces may depend on, but the time.
  Derived<> motion(const Numbers& y) const { return body_.moving(y).now; }
  Wrench<> net(double t, const Derived<>& now) const { return net_(t, now); }

  /// dy/dt at time t [s].
  TUMBLE_FLATTEN Numbers operator()(double t, const Numbers& y) const {
    const ScaledBody::Moving moving = body_.moving(y);
    return body_.rate(y, moving, net_(t, moving.now));
  }

 private:
  RigidBody<> unscaled_;
  std::function<Wrench<>(double, const Derived<>&)> net_;
  ScaledBody body_;
};

}  // namespace tumble::detail
