#pragma once
/// @file
/// A right-hand side that counts how often it is asked.

#include "tumble/ode/jacobian.hpp"

namespace tumble::runge_kutta {

/// @addtogroup ode
/// @{

/// f itself, with its Jacobian if it knows one, and a count of the evaluations of f.
template <class F>
class CountedRhs {
 public:
  CountedRhs(F& f, int& evaluations) : f_(f), evaluations_(evaluations) {}

  template <OdeState State>
  State operator()(ScalarOf<State> t, const State& y) const {
    ++evaluations_;
    return f_(t, y);
  }

  template <OdeState State>
  // clang-format off
  detail::JacobianOf<State> jacobian(ScalarOf<State> t, const State& y) const
    requires detail::KnowsJacobian<F, State> {
    return f_.jacobian(t, y);
  }
  // clang-format on

 private:
  F& f_;
  int& evaluations_;
};

/// @}

}  // namespace tumble::runge_kutta
