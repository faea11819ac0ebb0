/// @file
/// 11.3 first_contact: its laws, and what goes wrong.
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include "11_when_bodies_meet/contract.hpp"
#include "judge/spec/spec.hpp"

using namespace tumble::judge;
using when_bodies_meet::FirstContact, when_bodies_meet::GapAt;

namespace student {
const Function<decltype(when_bodies_meet::first_contact)> first_contact{TUMBLE_UNIT};
}

namespace {

constexpr FirstContact none{false, 0};

/// One question.
struct Search {
  GapAt gap;
  double speed;
  double t0 = 0, t1 = 10;
  double tolerance = 1e-6;
};

FirstContact advance(const Search& q, double factor = 1, int most = 3000) {
  double t = q.t0;
  // A wrong factor may make the steps tiny: then it is wrong, and must not hang.
  for (int n = 0; n < most && t <= q.t1; ++n) {
    const double distance = q.gap(t);
    if (distance <= q.tolerance) return {true, t};
    t += factor * distance / q.speed;
  }
  return none;
}

auto ask(const Search& q) {
  return student::first_contact(q.gap, q.speed, q.t0, q.t1, q.tolerance);
}

// ── Wrong answers ──

auto as(FirstContact (*law)(const Search&)) {
  return [law](const GapAt& gap, double speed, double t0, double t1, double tolerance) {
    return law({gap, speed, t0, t1, tolerance});
  };
}

constexpr int steps = 200;

double time_of(const Search& q, int step) { return q.t0 + (q.t1 - q.t0) * step / steps; }

/// Looks at equal steps.
FirstContact in_equal_steps(const Search& q) {
  for (int n = 0; n <= steps; ++n)
    if (q.gap(time_of(q, n)) <= q.tolerance) return {true, time_of(q, n)};
  return none;
}

/// Looks at equal steps, and halves the first one over which the gap changes its sign.
FirstContact by_bisection(const Search& q) {
  for (int n = 0; n <= steps; ++n) {
    if (q.gap(time_of(q, n)) > q.tolerance) continue;
    double low = time_of(q, std::max(n - 1, 0)), high = time_of(q, n);
    for (int i = 0; i < 60; ++i) {
      const double middle = low + (high - low) / 2;
      (q.gap(middle) > q.tolerance ? low : high) = middle;
    }
    return {true, high};
  }
  return none;
}

/// Guesses the speed from the last two gaps, as Newton's and the secant method do. It looks at t1
/// before it gives up, so that it doesn't answer as those do who never begin.
FirstContact by_secants(const Search& q) {
  double before = q.t0, gap_before = q.gap(before);
  if (gap_before <= q.tolerance) return {true, before};
  double t = q.t0 + gap_before / q.speed;
  for (int n = 0; n < 100 && t <= q.t1; ++n) {
    const double gap = q.gap(t);
    if (gap <= q.tolerance) return {true, t};
    const double closing = (gap_before - gap) / (t - before);
    const double next = t + gap / (closing > 0 ? closing : q.speed);
    before = std::exchange(t, t < q.t1 ? std::min(next, q.t1) : next);
    gap_before = gap;
  }
  return none;
}

FirstContact until_zero(const Search& q) {
  double t = q.t0;
  // Rounding may keep it short of 0 for ever.
  for (int n = 0; n < 3000 && t <= q.t1 && q.gap(t) > 0; ++n) t += q.gap(t) / q.speed;
  return t <= q.t1 ? FirstContact{true, t} : none;
}

FirstContact one_step(const Search& q) {
  const double distance = q.gap(q.t0), t = q.t0 + std::fmax(0, distance) / q.speed;
  return t <= q.t1 ? FirstContact{true, t} : none;
}

FirstContact without_start(const Search& q) {
  const double t = q.t0 + std::fmax(std::abs(q.gap(q.t0)), q.tolerance) / q.speed;
  return advance({q.gap, q.speed, t, q.t1, q.tolerance});
}

FirstContact without_end(const Search& q) {
  return advance({q.gap, q.speed, q.t0, 4 * (std::abs(q.t1) + 1), q.tolerance});
}

FirstContact step_before(const Search& q) {
  double t = q.t0, before = q.t0;
  for (int n = 0; n < 3000 && t <= q.t1; ++n) {
    const double distance = q.gap(t);
    if (distance <= q.tolerance) return {true, before};
    before = std::exchange(t, t + distance / q.speed);
  }
  return none;
}

FirstContact looks_twice(const Search& q) {
  double t = q.t0;
  while (t <= q.t1) {
    if (q.gap(t) <= q.tolerance) return {true, t};
    t += q.gap(t) / q.speed;
  }
  return none;
}

FirstContact from_time_zero(const Search& q) {
  FirstContact found = advance(q);
  if (found.found) found.t -= q.t0;
  return found;
}

// ── Questions ──

/// A ball under gravity over a floor: its gap is h + v t − g t²/2.
struct Fall {
  double h = any_number(1, 4), v = any_number(-3, 3), g = 9.81;

  double at(double t) const { return h + v * t - g / 2 * t * t; }
  double landing() const { return (v + std::sqrt(v * v + 2 * g * h)) / g; }
  Search search(double t0, double tolerance = 1e-6) const {
    const double speed = std::abs(v) + g * landing() + 0.1;
    return {[*this, t0](double t) { return at(t - t0); }, speed, t0, t0 + landing() + 0.01,
            tolerance};
  }
};

/// A rod of length 2 l that turns at the rate w with its middle at height h over the floor.
Search any_rod(double h, double l, double w, double phase) {
  const auto gap = [=](double t) { return h - l * std::abs(std::sin(w * t + phase)); };
  return {gap, l * std::abs(w), 0, 10, 1e-6};
}

// ── What a search has to keep ──

/// By how much a step is longer than the last gap allows, or the search leaves t0 … t1 [s].
double rashness(const Answer<FirstContact>& answer, const Search& q) {
  double worst = 0, safe = q.t0;
  for (const Evaluation& each : answer.evaluations()) {
    const double t = from_value<double>(each.arguments[0]);
    worst = worse(worst, worse(t - safe, worse(q.t0 - t, t - q.t1)));
    safe = std::fmax(safe, t + q.gap(t) / q.speed);
  }
  return worst;
}

/// By how far it goes on although it has found a contact, or returns another time than the first.
double misses_first(const Answer<FirstContact>& answer, const Search& q) {
  for (const Evaluation& each : answer.evaluations()) {
    const double t = from_value<double>(each.arguments[0]);
    if (!(q.gap(t) <= q.tolerance)) continue;
    return answer->found ? std::abs(answer->t - t) : std::numeric_limits<double>::infinity();
  }
  return answer->found ? std::numeric_limits<double>::infinity() : 0;
}

/// How often it looks at a time that it knows already.
int repeated(const Answer<FirstContact>& answer) {
  std::set<double> known;
  int count = 0;
  for (const Evaluation& each : answer.evaluations())
    count += !known.insert(from_value<double>(each.arguments[0])).second;
  return count;
}

int needed(const Search& q) {
  int count = 0;
  const auto counted = [&](double t) {
    ++count;
    return q.gap(t);
  };
  advance({counted, q.speed, q.t0, q.t1, q.tolerance});
  return count;
}

/// Times are rounded: at each step by an eps of the time, and its gap by some of its size.
double rounding(const Search& q) { return 8 * eps * (std::abs(q.t0) + std::abs(q.t1)) * needed(q); }

/// The same at another time of the day: a clock that starts at 0 hides what is forgotten of t0.
Search at_another_time(const Search& q) {
  const double shift = any_number(0.5, 1) * (q.t1 - q.t0 + (q.t1 == q.t0));
  return {[gap = q.gap, shift](double t) { return gap(t - shift); }, q.speed, q.t0 + shift,
          q.t1 + shift, q.tolerance};
}

/// A search by the contract. It may go more carefully than it must, but not at twice the price.
bool is_right(const Search& at_zero) {
  const Search q = at_another_time(at_zero);
  const FirstContact expected = advance(q);
  const auto answer = ask(q);
  const auto count = static_cast<double>(answer.evaluations().size());
  return answer == obeys("a contact is found if, and only if, there is one",
                         answer->found == expected.found ? 0 : 1, 0) &&
         answer == obeys("it never looks later than the gap and the speed allow",
                         rashness(answer, q), rounding(q)) &&
         answer == obeys("it returns the first time that it looked at with a gap ≤ tolerance",
                         misses_first(answer, q), 0) &&
         answer == obeys("it looks at no time twice", repeated(answer), 0) &&
         answer ==
             at_most("the gap is evaluated no more often than needed", count, 2 * needed(q) + 2) &&
         answer == obeys("no contact has the time 0", answer->found ? 0 : std::abs(answer->t), 0);
}

}  // namespace

TEST_SUITE(TUMBLE_UNIT) {
  TEST_CASE("a ball that falls on the floor: the time is a root of the quadratic") {
    for (int n = 0; n < 8; ++n) {
      const Fall fall;
      const double t0 = any_number(-5, 5);
      const Search q = fall.search(t0);
      const auto answer = ask(q);
      // The gap falls at this speed there, and the last of it is the tolerance.
      const double late = q.tolerance / std::sqrt(fall.v * fall.v + 2 * fall.g * fall.h);
      REQUIRE(answer == obeys("t is the root, up to tolerance/speed",
                              std::abs(answer->t - t0 - fall.landing()), 2 * late));
      REQUIRE(is_right(q));
    }
  }

  TEST_CASE("a bound far above the speed: it takes 2000 steps, and they touch for all that") {
    // Each step leaves the same part of the gap, all but 1/150.
    const double d = any_number(1, 2), speed = any_number(1, 5);
    REQUIRE(is_right({[=](double t) { return d - speed * t; }, 150 * speed, 0, 10, 1e-6}));
  }

  TEST_CASE("two cars at a constant speed: one look, one step, and they touch") {
    for (int n = 0; n < 5; ++n) {
      const double d = any_number(1, 100), speed = any_number(1, 50);
      const Search q{[=](double t) { return d - speed * t; }, speed, 0, 1000, 1e-6};
      REQUIRE(is_right(q));
    }
  }

  TEST_CASE("10 km/s against a plate of 1 mm: nothing goes through") {
    for (int n = 0; n < 5; ++n) {
      const double v = 1e4, start = any_number(-9e3, -1e3);
      const auto gap = [=](double t) { return std::abs(start + v * t) - 0.0005; };
      REQUIRE(is_right({gap, v, 0, 1, 1e-7}));
      REQUIRE(is_right({gap, 3 * v, 0, 1, 1e-7}));  // a bound may be larger than it need be
    }
  }

  TEST_CASE("a turning rod over the floor: it hits, or it just misses") {
    for (int n = 0; n < 6; ++n) {
      const double l = any_number(0.5, 1), w = any_number(1, 4), phase = any_number(0, 0.5);
      REQUIRE(is_right(any_rod(0.9 * l, l, w, phase)));
      REQUIRE(is_right(any_rod(1.01 * l, l, w, phase)));
    }
  }

  TEST_CASE("a ball that is thrown until just below the ceiling, or just against it") {
    for (const double spare : {0.01, 1e-3, -1e-3}) {  // [m]
      const double v = any_number(3, 6), g = 9.81, height = v * v / (2 * g) + spare;
      const auto gap = [=](double t) { return height - v * t + g / 2 * t * t; };
      REQUIRE(is_right({gap, v, 0, 2 * v / g, 1e-6}));
    }
  }

  TEST_CASE("bodies that part, or that touch at the start") {
    const double v = any_number(1, 3);
    REQUIRE(is_right({[=](double t) { return 1 + v * t; }, v, 0, 10, 1e-6}));
    REQUIRE(is_right({[=](double t) { return v * t; }, v, 0, 10, 1e-6}));
    REQUIRE(is_right({[=](double t) { return 5e-7 - v * t; }, v, 2, 10, 1e-6}));
    REQUIRE(is_right({[=](double t) { return -0.1 + v * t; }, v, 0, 10, 1e-6}));
  }

  TEST_CASE("a contact after t1 is none, and the same time may be the first and the last") {
    const double d = any_number(5, 6);
    const auto gap = [=](double t) { return d - t; };
    REQUIRE(is_right({gap, 1.5, 0, 4, 1e-6}));
    REQUIRE(is_right({gap, 1.5, 0, 0, 1e-6}));
    REQUIRE(is_right({[](double) { return 0.; }, 1.5, 3, 3, 1e-6}));
    REQUIRE(is_right({[](double) { return 1e-6; }, 1.5, 3, 3, 1e-6}));  // not larger: it touches
  }

  TEST_CASE("small and large: microseconds to months, tolerances of 1e-3 and 1e-9 of the way") {
    for (const double size : {1e-6, 1e-3, 1e3, 1e6}) {
      const double d = size * any_number(1, 2), v = any_number(1, 2), wobble = any_number(0.1, 0.4);
      const auto gap = [=](double t) {
        return d - v * t + wobble * size * (1 - std::cos(t / size));
      };
      REQUIRE(is_right({gap, v + wobble, 0, 10 * size, 1e-3 * size}));
      REQUIRE(is_right({gap, v + wobble, 0, 10 * size, 1e-9 * size}));
    }
  }
}

const Misconceptions<decltype(when_bodies_meet::first_contact)> misconceptions{
    TUMBLE_UNIT,
    {{"equal steps",
      "You look at equal steps of time. Between two of them a fast body goes through a thin one, "
      "and you never see it.",
      "When they touch", as(in_equal_steps)},
     {"bisection between equal steps",
      "You look at equal steps, and halve the one in which the sign changes. Where a body goes in "
      "and out within one step, there is no change to see.",
      "When they touch", as(by_bisection)},
     {"speed guessed from the last gaps",
      "You guess the speed from the last two gaps. Bodies may come together faster than they did "
      "so far; only the bound that you are given is safe.",
      "When they touch", as(by_secants)},
     {"waits for a gap of 0",
      "You go on until the gap is 0. It gets smaller and smaller, and may never be exactly 0: that "
      "is what the tolerance is for.",
      "When they touch", as(until_zero)},
     {"one step only",
      "You step once by distance/speed, and call that the contact. It is only the earliest time at "
      "which they could touch: look again there.",
      "When they touch", as(one_step)},
     {"twice the safe step",
      "Your steps are too long: within one of them the bodies can come together and pass.",
      "When they touch", as([](const Search& q) { return advance(q, 2); })},
     {"start not looked at",
      "You don't look at t0. Bodies that touch there have their contact there.", "When they touch",
      as(without_start)},
     {"gives up",
      "You give up after 1000 steps or fewer. If the bound is far above the speed there are more, "
      "and each leads on: only t1 ends the search.",
      "When they touch", as([](const Search& q) { return advance(q, 1, 1000); })},
     {"end ignored", "You go on after t1. What happens later doesn't count.", "When they touch",
      as(without_end)},
     {"the time before",
      "You return the last time at which they were still apart, not the first at which they touch.",
      "When they touch", as(step_before)},
     {"each time looked at twice",
      "You evaluate the gap twice at each time: once to compare, and once for the step. Keep it in "
      "a variable.",
      "When they touch", as(looks_twice)},
     {"time counted from t0", "Your time is right, but counted from t0. Return the time itself.",
      "When they touch", as(from_time_zero)}}};
