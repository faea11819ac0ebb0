/// @file
/// 9.5 simulate: its laws, and what goes wrong.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "09_rigid_body/contract.hpp"
#include "judge/spec/shared/bodies.hpp"
#include "judge/spec/shared/rigid_body_reference.hpp"
#include "judge/spec/spec.hpp"
#include "tumble/free_body/free_symmetric_top.hpp"
#include "tumble/ode/euler.hpp"
#include "tumble/ode/midpoint.hpp"

using namespace bodies;

namespace student {
const Function<decltype(rigid_body::simulate)> simulate{TUMBLE_UNIT};
}

namespace {

using States = std::vector<State>;

/// What a question consists of. The quaternion has length 1 to rounding.
struct Scene {
  Body body = any_body();
  WrenchAt wrench = any_wrench();
  State start = any_state();
  double t0 = any_number(-2, 2), t1 = t0 + any_number(0.5, 1);
  int steps = 5;

  Scene() { start.q = any_unit_quaternion(); }
  double h() const { return (t1 - t0) / steps; }
};

Answer<States> ask(const Scene& s) {
  return student::simulate(s.body, s.wrench, s.start, s.t0, s.t1, s.steps);
}

States right(const Scene& s) {
  return reference::simulate(s.body, s.wrench, s.start, s.t0, s.t1, s.steps);
}

double largest(const State& state) { return reference::pack(state).cwiseAbs().maxCoeff(); }

double difference(const State& a, const State& b) {
  return (reference::pack(a) - reference::pack(b)).cwiseAbs().maxCoeff();
}

/// By how much a small error at the start has grown anywhere until the end: tried, not guessed.
double growth(const Scene& scene) {
  constexpr double small = 0x1p-20;
  const States states = right(scene);
  double most = 1;
  for (int n = 0; n < 13; ++n) {
    Scene other = scene;
    other.start = reference::unpack(reference::pack(scene.start) +
                                    small * largest(scene.start) * PackedState::Unit(n));
    const States others = right(other);
    for (std::size_t i = 0; i < states.size(); ++i)
      most = worse(most, difference(states[i], others[i]) / (small * largest(scene.start)));
  }
  return most;
}

/// A step takes some 32 roundings of the largest number of a state, and h times what four slopes
/// are off; what it adds grows with all that comes after it, and all steps add up.
double rounding(const Scene& scene) {
  double sum = 0;
  for (const State& state : right(scene))
    sum += 32 * eps * largest(state) +
           std::abs(scene.h()) * (4 * bodies::rounding(scene.body, state) + 16 * eps);
  return growth(scene) * sum;
}

// ── Wrong ways ──

PackedState with_unit_q(PackedState y) {
  y.segment<4>(3).normalize();
  return y;
}

/// One step of any method: f, t, y and h → y.
using Step = std::function<PackedState(const reference::Rhs&, double, const PackedState&, double)>;

const Step rk4 = [](const reference::Rhs& f, double t, const PackedState& y, double h) {
  return tumble::runge_kutta::rk4_step(f, t, y, h);
};

/// The state after one step, q repaired.
State after(const Step& step, const reference::Rhs& f, double t, const State& now, double h) {
  return reference::unpack(with_unit_q(step(f, t, reference::pack(now), h)));
}

/// All states on the way, `next(n, now)` the one after step number n.
template <class Next>
States walk(const State& start, int steps, const Next& next) {
  States path(1, start);
  while (path.size() <= static_cast<std::size_t>(steps))
    path.push_back(next(static_cast<double>(path.size() - 1), path.back()));
  return path;
}

States march(const Step& step, const reference::Rhs& f, const State& start, double t0, double h,
             int steps) {
  return walk(start, steps,
              [&](double n, const State& now) { return after(step, f, t0 + n * h, now, h); });
}

auto by(Step step) {
  return [step = std::move(step)](const Body& body, const WrenchAt& wrench, const State& start,
                                  double t0, double t1, int steps) {
    return march(step, reference::right_hand_side(body, wrench), start, t0, (t1 - t0) / steps,
                 steps);
  };
}

/// The right way with another step than (t1 − t0)/steps.
template <class Length>
auto with_h(Length length) {
  return [length](const Body& body, const WrenchAt& wrench, const State& start, double t0,
                  double t1, int steps) {
    const reference::Rhs f = reference::right_hand_side(body, wrench);
    return march(rk4, f, start, t0, length(t0, t1, steps), steps);
  };
}

/// The right steps, after each of which `repair` is made of the packed state.
template <class Repair>
auto repaired_by(Repair repair) {
  return [repair](const Body& body, const WrenchAt& wrench, const State& start, double t0,
                  double t1, int steps) {
    const reference::Rhs f = reference::right_hand_side(body, wrench);
    const double h = (t1 - t0) / steps;
    return walk(start, steps, [&](double n, const State& now) {
      return reference::unpack(repair(rk4(f, t0 + n * h, reference::pack(now), h)));
    });
  };
}

}  // namespace

TEST_SUITE(TUMBLE_UNIT) {
  TEST_CASE("any body, pushed by anything, in a few steps") {
    for (int n = 0; n < 12; ++n) {
      Scene scene;
      scene.steps = 2 + n % 5;
      REQUIRE(ask(scene) == close_to(right(scene), rounding(scene)));
    }
  }

  TEST_CASE(
      "right states, and what pushes is evaluated four times a step, where Runge–Kutta looks") {
    for (int n = 0; n < 3; ++n) {
      const Scene scene;
      const auto states = ask(scene);
      REQUIRE(states == close_to(right(scene), rounding(scene)));

      std::vector<std::pair<double, State>> places;
      Scene watched = scene;
      watched.wrench = [&](double t, const State& state) {
        places.emplace_back(t, state);
        return scene.wrench(t, state);
      };
      right(watched);
      const auto& asked = states.evaluations();
      REQUIRE(states == obeys("what pushes is evaluated exactly four times per step",
                              std::abs(static_cast<double>(asked.size()) - 4. * scene.steps), 0));
      double late = 0, off = 0;
      for (std::size_t i = 0; i < places.size(); ++i) {
        const auto& [t, state] = places[i];
        late = worse(late, std::abs(from_value<double>(asked[i].arguments[0]) - t));
        off = worse(off, difference(from_value<State>(asked[i].arguments[1]), state));
      }
      // Times that are added up are off by one rounding a step.
      REQUIRE(states ==
              obeys("it is evaluated at the start, twice halfway and at the end of each step", late,
                    8 * (scene.steps + 4) * eps));
      REQUIRE(states == obeys("it is evaluated in the states of the four slopes, the first in that "
                              "which the step before has come to",
                              off, rounding(scene)));
    }
  }

  TEST_CASE("right states: q has length 1 in each, and the first is the start as it is") {
    for (const int steps : {1, 3, 40}) {
      Scene scene;
      scene.steps = steps;
      const auto states = ask(scene);
      REQUIRE(states == close_to(right(scene), rounding(scene)));
      REQUIRE(states == obeys("the first state is the start, unrounded",
                              difference(states->front(), scene.start), 0));
      for (const State& state : states.value())
        REQUIRE(states == obeys("|q| = 1", std::abs(state.q.norm() - 1), 16 * eps));
    }
  }

  TEST_CASE(
      "nothing pushes: the right states, with momenta that stay and a centre that goes straight") {
    for (int n = 0; n < 5; ++n) {
      Scene scene;
      scene.wrench = no_wrench();
      scene.steps = 10;
      const auto states = ask(scene);
      REQUIRE(states == close_to(right(scene), rounding(scene)));
      const Vec3 v = scene.start.P / scene.body.mass;
      for (int i = 0; i <= scene.steps; ++i) {
        const State& state = states.value()[static_cast<std::size_t>(i)];
        const double bound = 8 * (scene.steps + 1) * eps * largest(scene.start);
        REQUIRE(states == obeys("P stays", (state.P - scene.start.P).norm(), bound));
        REQUIRE(states == obeys("L stays", (state.L - scene.start.L).norm(), bound));
        const Vec3 x = scene.start.x + i * scene.h() * v;
        REQUIRE(states == obeys("x goes straight on", (state.x - x).norm(),
                                8 * (scene.steps + 1) * eps * (largest(scene.start) + v.norm())));
      }
    }
  }

  TEST_CASE(
      "a constant push: the right states, a parabola for the centre, momenta that grow evenly") {
    for (int n = 0; n < 5; ++n) {
      Scene scene;
      const Vec3 F = any_vector(10), tau = any_vector(10);
      scene.wrench = constant_wrench(F, tau);
      scene.steps = 10;
      const auto states = ask(scene);
      REQUIRE(states == close_to(right(scene), rounding(scene)));
      for (int i = 0; i <= scene.steps; ++i) {
        const State& state = states.value()[static_cast<std::size_t>(i)];
        const double t = i * scene.h(), m = scene.body.mass;
        const Vec3 x = scene.start.x + t / m * (scene.start.P + t / 2 * F);
        const double size = largest(scene.start) + (F.norm() + tau.norm() + x.norm()) / m;
        const double bound = 32 * (scene.steps + 1) * eps * (size + F.norm() + tau.norm());
        REQUIRE(states == obeys("x = x₀ + v t + ½ (F/m) t²", (state.x - x).norm(), bound));
        REQUIRE(states == obeys("P = P₀ + F t", (state.P - scene.start.P - t * F).norm(), bound));
        REQUIRE(states == obeys("L = L₀ + τ t", (state.L - scene.start.L - t * tau).norm(), bound));
      }
    }
  }

  TEST_CASE("a symmetric top's flight in RK4's states: half the step, a sixteenth of the error") {
    const double mass = any_number(0.5, 5), transverse = any_number(1, 2);
    const double axial = any_number(0.4, 0.6) * transverse;
    Scene scene;
    scene.body = body_with(mass, {transverse, transverse, axial}, any_rotation());
    scene.wrench = no_wrench();
    scene.start.L = 3 * transverse * any_direction();
    scene.t1 = scene.t0 + 1;
    const tumble::RigidBodyState<> start{scene.start.x,
                                         tumble::from_coefficients<double>(scene.start.q),
                                         scene.start.P, scene.start.L};
    const tumble::Quat exact =
        tumble::free_symmetric_top(tumble::RigidBody<>(mass, scene.body.I_body), start, 1).q;
    const auto angle = [&](const Answer<States>& states) {
      return tumble::angle_between<double>(tumble::from_coefficients<double>(states->back().q),
                                           exact);
    };
    scene.steps = 32;
    const auto coarse = ask(scene);
    REQUIRE(coarse == close_to(right(scene), rounding(scene)));
    scene.steps = 64;
    const auto fine = ask(scene);
    REQUIRE(fine == close_to(right(scene), rounding(scene)));
    // Nearer to 4 than to any other whole number.
    REQUIRE(fine == obeys("the error falls as h⁴",
                          std::abs(std::log2(angle(coarse) / angle(fine)) - 4), 0.5));
  }

  TEST_CASE("one step, no step at all, back in time, and steps that go nowhere") {
    Scene scene;
    scene.steps = 0;
    REQUIRE(ask(scene) == close_to(States{scene.start}, 0));
    scene.steps = 1;
    REQUIRE(ask(scene) == close_to(right(scene), rounding(scene)));
    scene.steps = 4;
    std::swap(scene.t0, scene.t1);
    REQUIRE(ask(scene) == close_to(right(scene), rounding(scene)));
    scene.t1 = scene.t0;  // steps that go nowhere
    REQUIRE(ask(scene) == close_to(States(5, scene.start), rounding(scene)));
  }

  TEST_CASE("a spin of 10000 rad/s, a needle, specks of dust and planets") {
    Scene spinning;
    spinning.start.L = 1e4 * any_direction();
    spinning.t1 = spinning.t0 + 1e-4;
    REQUIRE(ask(spinning) == close_to(right(spinning), rounding(spinning)));
    Scene needle;
    needle.body = body_with(1, {1, 1, 1e-3}, any_rotation());
    const Mat3 R = reference::to_matrix(needle.start.q);
    needle.start.L = R * (needle.body.I_body * any_vector(3));
    needle.wrench = no_wrench();
    REQUIRE(ask(needle) == close_to(right(needle), rounding(needle)));
    for (const double size : {1e-20, 1e20}) {
      Scene scene;
      const Scene like = scene;
      scene.body = {size * like.body.mass, size * like.body.I_body, like.body.I_body_inv / size};
      scene.start.P *= size;
      scene.start.L *= size;
      scene.wrench = no_wrench();
      Scene expected = like;
      expected.wrench = no_wrench();
      const auto states = ask(scene);
      const States others = right(expected);
      REQUIRE(states == obeys("one more state than there are steps",
                              std::abs(static_cast<double>(states->size()) -
                                       static_cast<double>(others.size())),
                              0));
      for (std::size_t i = 0; i < others.size(); ++i) {
        State state = states.value()[i];
        state.P /= size;
        state.L /= size;
        REQUIRE(states == obeys("a body as heavy as you like flies the same way",
                                difference(state, others[i]), 2 * rounding(expected)));
      }
    }
  }
}

const Misconceptions<decltype(rigid_body::simulate)> misconceptions{
    TUMBLE_UNIT,
    {{"never normalised",
      "You left the quaternion's length to itself, and each step makes it a little longer or "
      "shorter. Divide q by its length after each step.",
      "The length of q", repaired_by([](const PackedState& y) { return y; })},
     {"only what is returned is normalised",
      "The states that you return have quaternions of length 1, but your next step started from "
      "the state before the repair. Start it from the repaired one.",
      "The length of q",
      [](const Body& body, const WrenchAt& wrench, const State& start, double t0, double t1,
         int steps) {
        const auto drift = repaired_by([](const PackedState& y) { return y; });
        States states = drift(body, wrench, start, t0, t1, steps);
        for (std::size_t i = 1; i < states.size(); ++i) states[i].q.normalize();
        return states;
      }},
     {"normalised within the step",
      "You scaled the quaternion to length 1 in the middle of the step, too, before you took a "
      "slope. Then the slopes belong to other states than those of the step. Scale once, when the "
      "step is done.",
      "The length of q", by([](const reference::Rhs& f, double t, const PackedState& y, double h) {
        const reference::Rhs repaired = [&f](double time, const PackedState& z) {
          return f(time, with_unit_q(z));
        };
        return tumble::runge_kutta::rk4_step(repaired, t, y, h);
      })},
     {"scalar made positive",
      "You changed the sign of the quaternion where its scalar is negative. That is the same "
      "rotation, but a jump in the numbers: touch nothing but the length.",
      "The length of q", repaired_by([](const PackedState& y) {
        PackedState repaired = with_unit_q(y);
        if (repaired[3] < 0) repaired.segment<4>(3) *= -1;
        return repaired;
      })},
     {"whole state normalised",
      "You divided all thirteen numbers by the length of all of them together. Only the quaternion "
      "should have length 1.",
      "The length of q",
      repaired_by([](const PackedState& y) -> PackedState { return y.normalized(); })},
     {"divided by the square of the length",
      "You divided the quaternion by |q|², which overshoots: what was a little too long is now a "
      "little too short.",
      "The length of q", repaired_by([](PackedState y) {
        y.segment<4>(3) /= y.segment<4>(3).squaredNorm();
        return y;
      })},
     {"Euler's method",
      "Each of your steps follows the slope at its start only. The method of 1.5 takes four "
      "slopes.",
      "Taking steps",
      by([](const reference::Rhs& f, double t, const PackedState& y, double h) -> PackedState {
        return tumble::runge_kutta::euler_step(f, t, y, h);
      })},
     {"momenta first, then the rest",
      "You moved P and L first, and then x and q with the new momenta, as many games do. Here you "
      "move the whole state at once, by four slopes.",
      "Taking steps",
      by([](const reference::Rhs& f, double t, const PackedState& y, double h) -> PackedState {
        PackedState next = y;
        next.tail<6>() += h * f(t, y).tail<6>();
        next.head<7>() += h * f(t, next).head<7>();
        return next;
      })},
     {"midpoint method",
      "Each of your steps follows one slope, the one halfway. The method of 1.5 averages four.",
      "Taking steps",
      by([](const reference::Rhs& f, double t, const PackedState& y, double h) -> PackedState {
        return tumble::runge_kutta::midpoint_step(f, t, y, h);
      })},
     {"pushed alike for a whole step",
      "You evaluated what pushes once per step, at its start, and used it for all four slopes. You "
      "lose what changes within the step, and with it the order of the method.",
      "How often the forces are evaluated",
      [](const Body& body, const WrenchAt& wrench, const State& start, double t0, double t1,
         int steps) {
        const double h = (t1 - t0) / steps;
        return walk(start, steps, [&](double n, const State& now) {
          const Wrench push = wrench(t0 + n * h, now);
          const reference::Rhs f = [&](double, const PackedState& y) {
            return reference::rate(body, reference::unpack(y), push);
          };
          return after(rk4, f, 0, now, h);
        });
      }},
     {"time stands still",
      "Every step of yours begins at the time t0, as far as what pushes can see. From step to step "
      "the time moves on by h.",
      "Taking steps",
      [](const Body& body, const WrenchAt& wrench, const State& start, double t0, double t1,
         int steps) {
        const reference::Rhs f = reference::right_hand_side(body, wrench);
        const double h = (t1 - t0) / steps;
        return walk(start, steps,
                    [&](double, const State& now) { return after(rk4, f, t0, now, h); });
      }},
     {"time counted from zero",
      "You set the clock to 0 at the start. It should show t0, because what pushes may depend on "
      "it.",
      "Taking steps",
      [](const Body& body, const WrenchAt& wrench, const State& start, double t0, double t1,
         int steps) { return reference::simulate(body, wrench, start, 0, t1 - t0, steps); }},
     {"always from the start",
      "Every step of yours sets out from the start again, so the body never gets further than one "
      "step. Go on from where the last step has arrived.",
      "Taking steps",
      [](const Body& body, const WrenchAt& wrench, const State& start, double t0, double t1,
         int steps) {
        const reference::Rhs f = reference::right_hand_side(body, wrench);
        const double h = (t1 - t0) / steps;
        return walk(start, steps,
                    [&](double n, const State&) { return after(rk4, f, t0 + n * h, start, h); });
      }},
     {"t1 taken for the duration",
      "You worked out the length of a step from t1 alone. Divide what lies between t0 and t1.",
      "Taking steps", with_h([](double, double t1, int steps) { return t1 / steps; })},
     {"steps and states mixed up",
      "You divided the time by the number of states. There is one more state than there are steps, "
      "as with fence posts and fields.",
      "Taking steps",
      with_h([](double t0, double t1, int steps) { return (t1 - t0) / (steps + 1); })},
     {"only forwards",
      "You made time run forwards, although t1 is before t0. Let h be negative, and it leads back.",
      "Taking steps",
      with_h([](double t0, double t1, int steps) { return std::abs(t1 - t0) / steps; })},
     {"start left out",
      "Your list begins after the first step. The start belongs to it, so there is one more state "
      "than there are steps.",
      "Taking steps",
      [](const Body& body, const WrenchAt& wrench, const State& start, double t0, double t1,
         int steps) {
        States states = reference::simulate(body, wrench, start, t0, t1, steps);
        states.erase(states.begin());
        return states;
      }},
     {"one step too few",
      "Your list ends one step before t1. The start is not a step, so there is one more state than "
      "there are steps.",
      "Taking steps",
      [](const Body& body, const WrenchAt& wrench, const State& start, double t0, double t1,
         int steps) {
        States states = reference::simulate(body, wrench, start, t0, t1, steps);
        if (states.size() > 1) states.pop_back();
        return states;
      }},
     {"only the end", "You returned only the last state. Return all of them, from the start on.",
      "Taking steps",
      [](const Body& body, const WrenchAt& wrench, const State& start, double t0, double t1,
         int steps) -> States {
        return {reference::simulate(body, wrench, start, t0, t1, steps).back()};
      }}}};
