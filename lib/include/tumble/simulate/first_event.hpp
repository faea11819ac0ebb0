#pragma once
/// @file
/// When something happens, for the first time or each time: where a function of time and state
/// changes its sign.
///
/// Source: Hairer, Nørsett & Wanner, "Solving Ordinary Differential Equations I", 2nd ed. (1993),
/// II.6 "Event Location".

#include <algorithm>
#include <cmath>
#include <concepts>
#include <optional>
#include <vector>

#include "tumble/simulate/trajectory.hpp"

namespace tumble {

/// @addtogroup simulate
/// @{

namespace detail {

/// A callable (t, state) → number, whose change of sign is the event.
template <class G, class State = RigidBodyState<>>
concept EventFunction = requires(const G& g, double t, const State& state) {
  { g(t, state) } -> std::convertible_to<double>;
};

/// When something happened, and where the body was, or each of several.
template <class State>
struct EventOf {
  double t;  ///< [s]
  State state;
};

}  // namespace detail

/// When it happened, `t` [s], and where the body was, `state`.
using Event = detail::EventOf<RigidBodyState<>>;

namespace detail {

/// The first double at which `value` has left the sign it has at a, by halving and secants in turn.
template <class Value>
double change_of_sign(const Value& value, double a, double b, double value_a, double value_b) {
  for (int i = 0; value_b != 0 && std::nextafter(a, b) != b; ++i) {
    const double middle = a + (b - a) / 2;
    const double secant = a - value_a * ((b - a) / (value_b - value_a));
    const double t = i % 2 && secant > std::min(a, b) && secant < std::max(a, b) ? secant : middle;
    const double value_t = value(t);
    if (value_t != 0 && std::signbit(value_t) == std::signbit(value_a)) {
      a = t;
      value_a = value_t;
    } else {
      b = t;
      value_b = value_t;
    }
  }
  return b;
}

/// Shows `visit` each event, in turn, until it has seen enough.
/// @param visit visit(event) → whether to look for more
template <class State, class G, class Visit>
void visit_events(const TrajectoryOf<State>& trajectory, const G& g, const Visit& visit) {
  constexpr int parts = 8;
  const auto value = [&](double t) { return static_cast<double>(g(t, trajectory.at(t))); };
  const std::vector<double>& times = trajectory.times();
  double before = times.front(), g_before = value(before);
  for (std::size_t i = 1; i < times.size(); ++i)
    for (int part = 1; part <= parts; ++part) {
      const double t =
          part == parts ? times[i] : times[i - 1] + part * (times[i] - times[i - 1]) / parts;
      const double g_now = value(t);
      if (g_before != 0 && (g_now == 0 || std::signbit(g_now) != std::signbit(g_before))) {
        const double root = change_of_sign(value, before, t, g_before, g_now);
        if (!visit(EventOf<State>{root, trajectory.at(root)})) return;
      }
      before = t;
      g_before = g_now;
    }
}

}  // namespace detail

/// The first moment at which g is no longer of the sign it had at the start, to the last digits of
/// t. A g that is 0 at the start counts from where it leaves 0. Looked for at eight moments in each
/// step: what changes sign and back in between is not seen. In a motion backwards in time the first
/// is the latest.
template <class State, detail::EventFunction<State> G>
std::optional<detail::EventOf<State>> first_event(const TrajectoryOf<State>& trajectory,
                                                  const G& g) {
  std::optional<detail::EventOf<State>> first;
  detail::visit_events(trajectory, g, [&](const detail::EventOf<State>& event) {
    first = event;
    return false;
  });
  return first;
}

/// All such times in turn, each found as first_event() finds the first.
template <class State, detail::EventFunction<State> G>
std::vector<detail::EventOf<State>> every_event(const TrajectoryOf<State>& trajectory, const G& g) {
  std::vector<detail::EventOf<State>> all;
  detail::visit_events(trajectory, g, [&](const detail::EventOf<State>& event) {
    all.push_back(event);
    return true;
  });
  return all;
}

/// @}

}  // namespace tumble
