#pragma once
/// @file
/// When something happens, for the first time or each time: where a function of time and state
/// changes its sign.
///
/// Source: Hairer, Nørsett & Wanner, "Solving Ordinary Differential Equations I", 2nd ed. (1993),
/// II.6 "Event Location".

#include <algorithm>
#include <array>
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

/// A moment, and what a function is then.
struct Look {
  double t, g;
};

/// The number that a user's function of the time and the state has given.
/// @throws std::runtime_error with the time if it is not a number
double require_number(double g, double t);

/// Where the parabola through three looks at one side of 0 comes nearest to it, if that is between
/// them, and near enough that the function may be beyond 0 there.
std::optional<double> nearest_to_zero(const std::array<Look, 3>& looks);

/// Whether a function is beyond 0 somewhere between three looks at one side of it, and where.
template <class Value>
std::optional<Look> beyond_zero(const Value& value, std::array<Look, 3> looks) {
  constexpr int tries = 8;
  for (int i = 0; i < tries; ++i) {
    const auto& [a, b, c] = looks;
    const std::optional<double> t = nearest_to_zero(looks);
    if (!t || *t == b.t) return {};
    const Look found{*t, value(*t)};
    if (found.g == 0 || std::signbit(found.g) != std::signbit(b.g)) return found;
    const bool before_b = std::abs(*t - a.t) < std::abs(b.t - a.t);
    if (std::abs(found.g) < std::abs(b.g))
      looks = before_b ? std::array{a, found, b} : std::array{b, found, c};
    else
      looks = before_b ? std::array{found, b, c} : std::array{a, b, found};
  }
  return {};
}

/// Moments soon after a start, each twice as far from it, up to `first`. Where the function is 0
/// but for rounding, as when an event has just been, these show what leaves 0 and is back before
/// `first`. They begin where the function has grown a few times in turn: that is no rounding.
template <class Value>
std::vector<double> soon_after(const Look& start, double first, const Value& value) {
  constexpr int middle = 20, halvings = 30, enough = 4;
  const auto moment = [&](int k) { return start.t + std::ldexp(first - start.t, -k); };
  std::vector<double> moments;
  if (start.g != 0 && std::signbit(value(moment(middle))) == std::signbit(start.g)) return moments;
  double before = start.g;
  int growing = 0;
  for (int k = halvings; k > 0; --k) {
    const double now = value(moment(k)), growth = now / before;
    if (growing < enough) growing = growth > 1.5 && growth < 5 ? growing + 1 : 0;
    if (growing == enough) moments.push_back(moment(k));
    before = now;
  }
  return moments;
}

/// Shows `visit` each event, in turn, until it has seen enough.
/// @param visit visit(event, whether g falls) → whether to look for more
template <class State, class G, class Visit>
void visit_events(const TrajectoryOf<State>& trajectory, const G& g, const Visit& visit) {
  constexpr int parts = 8;
  const auto value = [&](double t) { return require_number(g(t, trajectory.at(t)), t); };
  const std::vector<double>& times = trajectory.times();
  const auto changes = [](const Look& a, const Look& b) {
    return a.g != 0 && (b.g == 0 || std::signbit(a.g) != std::signbit(b.g));
  };
  const auto goes_on = [&](const Look& a, const Look& b) {
    const double root = change_of_sign(value, a.t, b.t, a.g, b.g);
    return visit(EventOf<State>{root, trajectory.at(root)}, a.g > 0);
  };
  std::array<Look, 3> looks{};  // the last ones
  looks[2] = {times.front(), value(times.front())};
  int at_one_side = 1;  // how many of them
  const auto goes_on_after = [&](double t) {
    looks = {looks[1], looks[2], Look{t, value(t)}};
    const auto& [a, b, c] = looks;
    const bool changed = changes(b, c);
    if (changed && !goes_on(b, c)) return false;
    at_one_side = changed || b.g == 0 ? 1 : at_one_side + 1;
    if (at_one_side < 3) return true;
    if (const std::optional<Look> there = beyond_zero(value, looks)) {
      const bool before_b = std::abs(there->t - a.t) < std::abs(b.t - a.t);
      const Look &from = before_b ? a : b, &to = before_b ? b : c;
      if (!goes_on(from, *there) || (changes(*there, to) && !goes_on(*there, to))) return false;
      at_one_side = 1;  // or the next three looks would find it once more
    }
    return true;
  };
  for (std::size_t i = 1; i < times.size(); ++i)
    for (int part = 1; part <= parts; ++part) {
      const double t =
          part == parts ? times[i] : times[i - 1] + part * (times[i] - times[i - 1]) / parts;
      if (i == 1 && part == 1)
        for (const double soon : soon_after(looks[2], t, value))
          if (!goes_on_after(soon)) return;
      if (!goes_on_after(t)) return;
    }
}

}  // namespace detail

/// The first moment at which g is no longer of the sign it had at the start, to the last digits of
/// t. A g that is 0 at the start counts from where it leaves 0. Looked for at eight moments in each
/// step, and where g comes nearest to 0 between them, as at the top of a path: what changes sign
/// and back so fast that three looks don't show it is not seen. In a motion backwards in time the
/// first is the latest.
/// @throws std::runtime_error with the time if g is not a number there
template <class State, detail::EventFunction<State> G>
std::optional<detail::EventOf<State>> first_event(const TrajectoryOf<State>& trajectory,
                                                  const G& g) {
  std::optional<detail::EventOf<State>> first;
  detail::visit_events(trajectory, g, [&](const detail::EventOf<State>& event, bool) {
    first = event;
    return false;
  });
  return first;
}

/// All such times in turn, each found as first_event() finds the first.
/// @throws as first_event() does
template <class State, detail::EventFunction<State> G>
std::vector<detail::EventOf<State>> every_event(const TrajectoryOf<State>& trajectory, const G& g) {
  std::vector<detail::EventOf<State>> all;
  detail::visit_events(trajectory, g, [&](const detail::EventOf<State>& event, bool) {
    all.push_back(event);
    return true;
  });
  return all;
}

/// @}

}  // namespace tumble

#ifndef TUMBLE_COMPILED
#include "tumble/simulate/first_event.inl"
#endif
