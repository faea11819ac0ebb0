#pragma once
/// @file
/// ODE solvers on plain arrays, as the course notes on rigid bodies write them.
///
///     void dydt(double t, const double y[], double ydot[]);
///     y1 = ode(y0, t0, tf, dydt, tolerances);    // the end state, to the tolerances
///     ode(Y, len, h, dydt);                      // one step of size h, in place
///     ode(x0, xEnd, len, t0, t1, dxdt);          // the end state in xEnd
///
/// dydt may take `double y[]` as well; it gets a copy. Whole integrations are DormandPrince54's,
/// the one step is rk4_step()'s. The other way round, a typed f(t, y) is a C function inside a
/// lambda: `Map<Vec6>(ydot) = f(t, Map<const Vec6>(y))`.

#include <cmath>
#include <concepts>
#include <iterator>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "tumble/ode/dormand_prince_54.hpp"
#include "tumble/ode/integrate_adaptive.hpp"
#include "tumble/ode/rk4.hpp"

namespace tumble {

/// @addtogroup ode
/// @{

namespace detail {

/// A callable dydt(t, y, ydot) on arrays.
template <class F>
concept CDydt = std::invocable<const F&, double, double*, double*>;

/// A C function as an OdeRhs of any state of doubles; made by rhs_from_c().
template <CDydt F>
class CRhs {
 public:
  explicit CRhs(F dydt) : dydt_(std::move(dydt)) {}

  template <OdeState State>
  State operator()(double t, const State& y) const {
    State copy = y;
    // What dydt forgets to write stays NaN and is found out.
    State ydot = State::Constant(y.size(), std::numeric_limits<double>::quiet_NaN());
    dydt_(t, copy.data(), ydot.data());
    return ydot;
  }

 private:
  F dydt_;
};

/// The numbers of a state whose length is known at run time only, on the stack: a rigid body
/// has 13.
using ShortState = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 16, 1>;

/// The end state of ode().
template <class State, class F>
std::vector<double> end_of_ode(const F& dydt, std::span<const double> y0, double t0, double tf,
                               const Tolerances& tolerances) {
  const State start = Eigen::Map<const Eigen::VectorXd>(y0.data(), std::ssize(y0));
  const State end = integrate_adaptive<DormandPrince54>(dydt, start, t0, tf, tolerances).y;
  return {end.data(), end.data() + end.size()};
}

}  // namespace detail

/// dydt(t, y, ydot) for the typed solvers: integrate_adaptive<Dop853>(rhs_from_c(dydt), y0, …).
template <detail::CDydt F>
detail::CRhs<F> rhs_from_c(F dydt) {
  return detail::CRhs<F>(std::move(dydt));
}

/// The state at tf, from y0 at t0.
/// @param y0 an array, std::vector, std::array or std::span, whose length it knows. Write t0 with a
///           point (0.0): an array followed by a whole number is the form with a length
/// @throws as integrate_adaptive()
template <detail::CDydt F>
std::vector<double> ode(std::span<const double> y0, double t0, double tf, F dydt,
                        const Tolerances& tolerances = {}) {
  using namespace detail;
  const CRhs<F> f = rhs_from_c(dydt);
  return std::ssize(y0) <= ShortState::MaxSizeAtCompileTime
             ? end_of_ode<ShortState>(f, y0, t0, tf, tolerances)
             : end_of_ode<Eigen::VectorXd>(f, y0, t0, tf, tolerances);
}

/// One step of size h of the classical Runge–Kutta method, in place (Lien's form).
/// @param Y   `len` numbers, replaced by those at t + h
/// @param h   step, negative to go back in time
/// @param t   the time that dydt is told
/// @throws std::invalid_argument if len < 1, or h, t or a number in Y is not finite
template <std::integral Length, detail::CDydt F>
void ode(double Y[], Length len, double h, F dydt, double t = 0) {
  require(len >= 1, "ode: a state of len = ", len, " numbers; for a time write ", len, ".0");
  require(std::isfinite(h), "ode: the step h = ", h, " is not finite");
  require(std::isfinite(t), "ode: the time t = ", t, " is not finite");
  Eigen::Map<Eigen::VectorXd> y(Y, static_cast<Eigen::Index>(len));
  require(y.allFinite(), "ode: Y = (", y.transpose(), ") is not finite");
  const detail::CRhs<F> f = rhs_from_c(dydt);
  if (y.size() <= detail::ShortState::MaxSizeAtCompileTime)
    y = runge_kutta::rk4_step(f, t, detail::ShortState(y), h);
  else
    y = runge_kutta::rk4_step(f, t, Eigen::VectorXd(y), h);
}

/// The state at t1 in xEnd, from x0 at t0 (Baraff's form).
/// @param x0   `len` numbers
/// @param xEnd room for as many; may be x0 itself
/// @throws as integrate_adaptive(), and std::invalid_argument if len < 1
template <std::integral Length, detail::CDydt F>
void ode(const double x0[], double xEnd[], Length len, double t0, double t1, F dxdt,
         const Tolerances& tolerances = {}) {
  require(len >= 1, "ode: a state of len = ", len, " numbers");
  const std::vector<double> end =
      ode(std::span<const double>(x0, static_cast<std::size_t>(len)), t0, t1, dxdt, tolerances);
  std::copy(end.begin(), end.end(), xEnd);
}

/// @}

}  // namespace tumble
