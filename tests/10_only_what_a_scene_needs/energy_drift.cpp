/// @file
/// 10.3 energy_drift: its laws, and what goes wrong.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "10_only_what_a_scene_needs/contract.hpp"
#include "judge/spec/shared/bodies.hpp"
#include "judge/spec/shared/rigid_body_reference.hpp"
#include "judge/spec/spec.hpp"
#include "tumble/free_body/free_symmetric_top.hpp"

using namespace bodies;
using only_what_a_scene_needs::EnergyDrift;

namespace student {
const Function<decltype(only_what_a_scene_needs::energy_drift)> energy_drift{TUMBLE_UNIT};
}

namespace {

using States = std::vector<State>;
using Numbers = std::vector<double>;

// ── Right and wrong answers, in parts ──

using Energy = double (*)(const Body& body, const State& state);

Numbers energies_of(const Body& body, const States& states, Energy energy) {
  Numbers energies;
  for (const State& state : states) energies.push_back(energy(body, state));
  return energies;
}

/// (Eₙ − E₀)/E₀.
Numbers relative(const Numbers& energies) {
  Numbers e;
  for (const double energy : energies) e.push_back((energy - energies[0]) / energies[0]);
  return e;
}

double largest_of(const Numbers& e) {
  double largest = 0;
  for (const double each : e) largest = std::fmax(largest, std::abs(each));
  return largest;
}

/// The slope of the fitted line, per state.
double slope_of(const Numbers& e) {
  double above = 0, below = 0;
  for (std::size_t n = 0; n < e.size(); ++n) {
    const double s = static_cast<double>(n) - (static_cast<double>(e.size()) - 1) / 2;
    above += s * e[n];
    below += s * s;
  }
  return below > 0 ? above / below : 0;
}

/// What is made of the energies of all states, none of which is zero, and of h.
using Law = EnergyDrift (*)(const Numbers& energies, double h);

EnergyDrift right_law(const Numbers& energies, double h) {
  const Numbers e = relative(energies);
  return {largest_of(e), slope_of(e) / h};
}

struct Reader {
  Energy energy = reference::energy;
  Law law = right_law;
  bool knows_rest = true;

  EnergyDrift operator()(const Body& body, const States& states, double h) const {
    const Numbers energies = energies_of(body, states, energy);
    if (energies.empty() || (knows_rest && energies[0] == 0)) return {0, 0};
    return law(energies, h);
  }
};

EnergyDrift right(const Body& body, const States& states, double h) {
  return Reader{}(body, states, h);
}

auto as(const Reader& reader) {
  return [reader](const Body& body, const States& states, double h) {
    return reader(body, states, h);
  };
}

// ── How exact ──

/// What a number eₙ may be off by: ω is off by up to 160 eps on either side, as in chapter 9, v by
/// less, and with them the energy; all of it as a fraction of the first one.
double rounding_of_e(const Body& body, const States& states) {
  double size = 0;
  for (const State& s : states)
    size =
        std::fmax(size, s.P.squaredNorm() / body.mass + body.I_body_inv.norm() * s.L.squaredNorm());
  const double first = reference::energy(body, states.front());
  return 320 * eps * size / first;
}

/// Both answers. Of N states the slope per state is a mean of all e with weights that add up to
/// less than 4/N; sums that are not centred lose up to another 8 times as much, and each sum of N
/// terms N eps.
double rounding(const Body& body, const States& states, double h) {
  const double e = rounding_of_e(body, states), count = static_cast<double>(states.size());
  const double size = 1 + largest_of(relative(energies_of(body, states, reference::energy)));
  return std::fmax(e, 32 / (count * std::abs(h)) * (e + count * eps * size));
}

// ── Motions ──

/// A body, its states and the time between them.
struct Motion {
  Body body = any_body();
  States states = {};
  double h = any_number(0.1, 0.5);

  double duration() const { return (static_cast<double>(states.size()) - 1) * h; }
};

Answer<EnergyDrift> ask(const Motion& m) { return student::energy_drift(m.body, m.states, m.h); }
EnergyDrift right(const Motion& m) { return right(m.body, m.states, m.h); }
double rounding(const Motion& m) { return rounding(m.body, m.states, m.h); }

/// States that have nothing to do with each other.
Motion any_motion(int count) {
  Motion motion;
  for (int n = 0; n < count; ++n) motion.states.push_back(any_state());
  return motion;
}

/// `state`, turned with all that it carries, and with this energy.
State turned(const Body& body, State state, double energy) {
  const Quaternion turn = any_unit_quaternion();
  const Mat3 T = reference::to_matrix(turn);
  const double faster = std::sqrt(energy / reference::energy(body, state));
  return {any_vector(3), reference::product(turn, state.q), faster * T * state.P,
          faster * T * state.L};
}

/// A motion with the energies E₀ (1 + e), e one for each state, the first of them 0.
Motion with_energies(const Numbers& e) {
  Motion motion;
  const State first = any_state();
  const double energy = reference::energy(motion.body, first);
  for (const double each : e)
    motion.states.push_back(turned(motion.body, first, energy * (1 + each)));
  return motion;
}

/// `times` full swings by `height`, seen 20 times each.
Numbers swings(int times, double height) {
  Numbers e;
  for (int n = 0; n <= 20 * times; ++n)
    e.push_back(height * std::sin(2 * std::numbers::pi * n / 20));
  return e;
}

}  // namespace

TEST_SUITE(TUMBLE_UNIT) {
  TEST_CASE("any body in any states") {
    // All is asked before the first answer is looked at: two wrong readings of one list of energies
    // may be the same number by chance.
    std::vector<Motion> motions;
    std::vector<Answer<EnergyDrift>> answers;
    for (int n = 0; n < 20; ++n) {
      motions.push_back(any_motion(5 + n));
      answers.push_back(ask(motions.back()));
    }
    for (std::size_t n = 0; n < motions.size(); ++n)
      REQUIRE(answers[n] == close_to(right(motions[n]), rounding(motions[n])));
  }

  TEST_CASE(
      "an energy that runs away evenly: its rate is the trend, and at the end it is largest") {
    // The last one is small, and far above rounding: it is a drift like any other.
    for (const double rate : {0.3, -0.02, 1e-3, 1e-11}) {
      const int count = 20;
      Numbers e;
      for (int n = 0; n < count; ++n) e.push_back(rate * n);
      const Motion motion = with_energies(e);
      const EnergyDrift expected{std::abs(rate) * (count - 1), rate / motion.h};
      REQUIRE(ask(motion) == close_to(expected, 2 * rounding(motion)));
    }
  }

  TEST_CASE("an energy that only swings: largest is its height, the trend small, and both right") {
    const double height = any_number(0.2, 0.8);
    for (const int times : {2, 10}) {
      const Motion motion = with_energies(swings(times, height));
      const auto drift = ask(motion);
      REQUIRE(drift == close_to(right(motion), rounding(motion)));
      REQUIRE(drift == obeys("largest is the height of the swing",
                             std::abs(drift->largest - height), 2 * rounding(motion)));
      // The slope of the line through `times` full waves is −6/(π times) of a wave's height.
      REQUIRE(drift == obeys("trend · duration is a small part of it",
                             std::abs(drift->trend) * motion.duration(), 2 * height / times));
    }
  }

  TEST_CASE("a swing on top of a run-away: both are seen, each for itself") {
    for (const double rate : {0.01, -0.003}) {
      Numbers e = swings(6, 0.3);
      for (std::size_t n = 0; n < e.size(); ++n) e[n] += rate * static_cast<double>(n);
      const Motion motion = with_energies(e);
      REQUIRE(ask(motion) == close_to(right(motion), rounding(motion)));
    }
  }

  TEST_CASE("real flights: 0 for the exact one, and as much as Euler's steps heat the body up") {
    const double mass = any_number(0.5, 5), transverse = any_number(1, 2);
    Motion exact;
    exact.body = body_with(mass, {transverse, transverse, 0.5 * transverse}, any_rotation());
    exact.h = 0.01;
    State start = any_state();
    start.q.normalize();
    start.L = 2 * transverse * any_direction();
    Motion euler = exact;
    euler.states = {start};
    const reference::Rhs f = reference::right_hand_side(exact.body, no_wrench());
    for (int n = 0; n <= 100; ++n) {
      const tumble::RigidBodyState<> first{start.x, tumble::from_coefficients<double>(start.q),
                                           start.P, start.L};
      const auto now = tumble::free_symmetric_top(tumble::RigidBody<>(mass, exact.body.I_body),
                                                  first, n * exact.h);
      exact.states.push_back({now.x, tumble::coefficients(now.q), now.P, now.L});
      const PackedState y = reference::pack(euler.states.back());
      euler.states.push_back(reference::unpack(y + euler.h * f(0, y)));
    }
    // What the exact flight's own rounding does to its energy counts like the student's.
    REQUIRE(ask(exact) == close_to(EnergyDrift{0, 0}, 2 * rounding(exact)));
    REQUIRE(ask(euler) == close_to(right(euler), rounding(euler)));
  }

  TEST_CASE("the same right drift with states turned, moved, or with q longer or shorter") {
    Motion motion = any_motion(12);
    const EnergyDrift expected = right(motion);
    for (State& state : motion.states) {
      state = turned(motion.body, state, reference::energy(motion.body, state));
      state.q *= any_number(0.1, 10);
    }
    REQUIRE(ask(motion) == close_to(expected, 4 * rounding(motion)));
  }

  TEST_CASE(
      "back in time the trend has a minus, half as fast it is half, and largest stays right") {
    Motion motion = any_motion(12);
    const EnergyDrift once = right(motion);
    for (const double factor : {-1., 2., -0.5}) {
      Motion other = motion;
      other.h *= factor;
      REQUIRE(ask(other) ==
              close_to(EnergyDrift{once.largest, once.trend / factor}, 2 * rounding(other)));
    }
  }

  TEST_CASE("no state at all, one, two, and a body at rest") {
    Motion motion = any_motion(0);
    REQUIRE(ask(motion) == close_to(EnergyDrift{0, 0}, 0));
    for (const int count : {1, 2, 3}) {
      motion = any_motion(count);
      REQUIRE(ask(motion) == close_to(right(motion), rounding(motion)));
    }
    for (const std::size_t count : {1u, 2u, 5u}) {
      motion.states.assign(count,
                           {any_vector(3), any_unit_quaternion(), Vec3::Zero(), Vec3::Zero()});
      REQUIRE(ask(motion) == close_to(EnergyDrift{0, 0}, 0));
    }
  }

  TEST_CASE("specks of dust and planets, 10000 rad/s, a needle, and many states") {
    for (const double size : {1e-20, 1e20}) {
      Motion motion = any_motion(10);
      const EnergyDrift expected = right(motion);
      const double bound = 2 * rounding(motion);
      const Body like = motion.body;
      motion.body = {size * like.mass, size * like.I_body, like.I_body_inv / size};
      for (State& state : motion.states) {
        state.P *= size;
        state.L *= size;
      }
      REQUIRE(ask(motion) == close_to(expected, bound));
    }
    Motion fast = any_motion(10);
    for (State& state : fast.states) state.L *= 1e4;
    REQUIRE(ask(fast) == close_to(right(fast), rounding(fast)));
    Motion needle = any_motion(10);
    needle.body = body_with(1, {1, 1, 1e-6}, any_rotation());
    for (State& state : needle.states) {
      const Mat3 R = reference::to_matrix(state.q);
      state.L = R * (needle.body.I_body * any_vector(3));
    }
    REQUIRE(ask(needle) == close_to(right(needle), rounding(needle)));
    const Motion crowd = any_motion(1000);
    REQUIRE(ask(crowd) == close_to(right(crowd), rounding(crowd)));
  }
}

const Misconceptions<decltype(only_what_a_scene_needs::energy_drift)> misconceptions{
    TUMBLE_UNIT,
    {{"sign kept",
      "Your `largest` is the largest increase, and where the energy falls you didn't see it. The "
      "size counts, upwards and downwards.",
      "Drift or oscillation", as({.law = [](const Numbers& E, double h) -> EnergyDrift {
        const Numbers e = relative(E);
        return {*std::max_element(e.begin(), e.end()), slope_of(e) / h};
      }})},
     {"only the end looked at",
      "Your `largest` is how far the energy is off at the end. On the way it was further off: all "
      "states count.",
      "Drift or oscillation", as({.law = [](const Numbers& E, double h) -> EnergyDrift {
        const Numbers e = relative(E);
        return {std::abs(e.back()), slope_of(e) / h};
      }})},
     {"from the lowest to the highest",
      "Your `largest` is the distance between the lowest and the highest energy. Measure from the "
      "first one, which is the right one.",
      "Drift or oscillation", as({.law = [](const Numbers& E, double h) -> EnergyDrift {
        const Numbers e = relative(E);
        return {*std::max_element(e.begin(), e.end()) - *std::min_element(e.begin(), e.end()),
                slope_of(e) / h};
      }})},
     {"from state to state",
      "Your `largest` is the largest change from one state to the next. A slow drift makes only "
      "small ones, and still goes far.",
      "Drift or oscillation", as({.law = [](const Numbers& E, double h) -> EnergyDrift {
        double largest = 0;
        for (std::size_t n = 1; n < E.size(); ++n)
          largest = std::fmax(largest, std::abs(E[n] - E[n - 1]) / E[0]);
        return {largest, slope_of(relative(E)) / h};
      }})},
     {"middle rounded down",
      "With an even number of states your line turns about the wrong middle: (n − 1)/2 of whole "
      "numbers is rounded down. The middle lies between two states there.",
      "Drift or oscillation", as({.law = [](const Numbers& E, double h) -> EnergyDrift {
        const Numbers e = relative(E);
        const auto middle = static_cast<double>((E.size() - 1) / 2);
        double above = 0, below = 0;
        for (std::size_t n = 0; n < e.size(); ++n) {
          const double s = static_cast<double>(n) - middle;
          above += s * e[n];
          below += s * s;
        }
        return {largest_of(e), below > 0 ? above / below / h : 0};
      }})},
     {"in joules",
      "Both of your numbers are differences of energies, not fractions of the first energy. A "
      "joule is much for a coin and nothing for a ship.",
      "Energy", as({.law = [](const Numbers& E, double h) -> EnergyDrift {
        const EnergyDrift drift = right_law(E, h);
        return {E[0] * drift.largest, E[0] * drift.trend};
      }})},
     {"fractions of the mean",
      "You compared the energies with their mean. If the energy runs away, the mean runs along: "
      "the first energy is the one that should have stayed.",
      "Energy", as({.law = [](const Numbers& E, double h) -> EnergyDrift {
        double mean = 0;
        for (const double energy : E) mean += energy / static_cast<double>(E.size());
        Numbers e;
        for (const double energy : E) e.push_back((energy - mean) / mean);
        return {largest_of(e), slope_of(e) / h};
      }})},
     {"fractions of each energy itself",
      "You divided each difference by the energy of its own state. Make all of them fractions of "
      "the first one, or you can't compare them.",
      "Energy", as({.law = [](const Numbers& E, double h) -> EnergyDrift {
        Numbers e;
        for (const double energy : E) e.push_back((energy - E[0]) / energy);
        return {largest_of(e), slope_of(e) / h};
      }})},
     {"from the first to the last",
      "You took the trend from two states only, the first and the last. Where the energy swings, "
      "it depends on where in a swing you stop. In a fitted line all states have a say.",
      "Drift or oscillation", as({.law = [](const Numbers& E, double h) -> EnergyDrift {
        const Numbers e = relative(E);
        const double count = static_cast<double>(E.size());
        return {largest_of(e), count > 1 ? e.back() / ((count - 1) * h) : 0};
      }})},
     {"per state, not per second",
      "Your trend is how much the energy changes from one state to the next. With twice as many "
      "states per second it would be half as large: make it per second.",
      "Drift or oscillation",
      as({.law = [](const Numbers& E, double) -> EnergyDrift { return right_law(E, 1); }})},
     {"sign of the time lost",
      "You divided the trend by the size of h. Where the states lead back in time it has the "
      "opposite sign.",
      "Drift or oscillation", as({.law = [](const Numbers& E, double h) -> EnergyDrift {
        return right_law(E, std::abs(h));
      }})},
     {"line through the first point",
      "You made the line go through the first state. Let it fit all of them best and miss each: "
      "one energy that happens to be low would tilt yours.",
      "Drift or oscillation", as({.law = [](const Numbers& E, double h) -> EnergyDrift {
        const Numbers e = relative(E);
        double above = 0, below = 0;
        for (std::size_t n = 0; n < e.size(); ++n) {
          const auto s = static_cast<double>(n);
          above += s * e[n];
          below += s * s;
        }
        return {largest_of(e), below > 0 ? above / below / h : 0};
      }})},
     {"no line through one point",
      "For a single state your slope is zero over zero. One point has no trend.",
      "Drift or oscillation", as({.law = [](const Numbers& E, double h) -> EnergyDrift {
        const EnergyDrift drift = right_law(E, h);
        return {drift.largest,
                E.size() == 1 ? std::numeric_limits<double>::quiet_NaN() : drift.trend};
      }})},
     {"line through the sizes",
      "You fitted the line to the sizes of the deviations. Then a swing that grows looks like a "
      "run-away, and energy that is lost like energy that is gained.",
      "Drift or oscillation", as({.law = [](const Numbers& E, double h) -> EnergyDrift {
        Numbers e = relative(E);
        for (double& each : e) each = std::abs(each);
        return {largest_of(e), slope_of(e) / h};
      }})},
     {"only the turning", "Your energy is that of the turning alone. The centre of mass moves too.",
      "Energy",
      as({.energy =
              [](const Body& body, const State& s) {
                return s.L.dot(reference::derived(body, s).omega) / 2;
              }})},
     {"only the flight",
      "Your energy is that of the centre's motion alone. The body turns about it too.", "Energy",
      as({.energy = [](const Body& body,
                       const State& s) { return s.P.squaredNorm() / body.mass / 2; }})},
     {"half of the turning forgotten",
      "One of the two parts of your energy lacks its ½. If it were missing in both, nobody would "
      "notice.",
      "Energy",
      as({.energy =
              [](const Body& body, const State& s) {
                return s.P.squaredNorm() / body.mass / 2 +
                       s.L.dot(reference::derived(body, s).omega);
              }})},
     {"tensor for its inverse",
      "You made the energy of the turning from L with the tensor. The tensor goes with ω, as in ½ "
      "ω·Iω; with L you need its inverse.",
      "Energy",
      as({.energy =
              [](const Body& given, const State& s) {
                Body body = given;
                body.I_body_inv = body.I_body;
                return reference::energy(body, s);
              }})},
     {"body tensor used in the world",
      "For the energy of the turning you left L in world axes, and the tensor is in body axes.",
      "Energy",
      as({.energy =
              [](const Body& body, const State& s) {
                return (s.P.squaredNorm() / body.mass + s.L.dot(body.I_body_inv * s.L)) / 2;
              }})},
     {"zero over zero",
      "A body at rest has no energy, and you divide by it. It has none that could drift.", "Energy",
      as({.knows_rest = false})}}};
