/// @file
/// 9.4 dydt: its laws, and what goes wrong.
#include <cmath>
#include <string>
#include <utility>

#include "09_rigid_body/contract.hpp"
#include "judge/spec/shared/bodies.hpp"
#include "judge/spec/shared/rigid_body_reference.hpp"
#include "judge/spec/spec.hpp"
#include "tumble/free_body/free_symmetric_top.hpp"
#include "tumble/rotation/skew.hpp"

using namespace bodies;

namespace student {
const Function<decltype(rigid_body::dydt)> dydt{TUMBLE_UNIT};
}

namespace {

double any_time() { return any_number(-5, 5); }

/// Any number of ẏ: q̇ is half of ω times q, and takes 8 roundings more on either side; force and
/// torque pass through.
double rounding_of_rate(const Body& body, const State& state) {
  return std::fmax(1, state.q.norm()) * rounding(body, state);
}

Answer<PackedState> ask(const Body& body, const WrenchAt& wrench, double t, const State& state) {
  return student::dydt(body, wrench, t, reference::pack(state));
}

PackedState right(const Body& body, const WrenchAt& wrench, double t, const State& state) {
  return reference::dydt(body, wrench, t, reference::pack(state));
}

// ── Wrong laws ──

/// The rates that `law` makes of the body, the state, what follows from it and the wrench.
template <class Law>
auto with_law(Law law) {
  return [law](const Body& body, const WrenchAt& wrench, double t, const PackedState& y) {
    const State s = reference::unpack(y);
    const Wrench push = wrench(t, s);
    return reference::pack(law(body, s, reference::derived(body, s), push));
  };
}

/// The right rates, from which a law may go astray.
State rates(const State& s, const Derived& now, const Wrench& push) {
  return {now.v, reference::quaternion_dot(s.q, now.omega), push.force, push.torque};
}

/// The right rates but for ω, which `law` makes of R, the body and L.
template <class Law>
auto with_omega(Law law) {
  return with_law([law](const Body& body, const State& s, Derived now, const Wrench& push) {
    now.omega = law(now.R, body, s.L);
    return rates(s, now, push);
  });
}

Quaternion pure(const Vec3& v) { return {0, v.x(), v.y(), v.z()}; }

}  // namespace

TEST_SUITE(TUMBLE_UNIT) {
  TEST_CASE("any body, any push, at any time and in any state") {
    for (int n = 0; n < 20; ++n) {
      const Body body = any_body();
      const WrenchAt wrench = any_wrench();
      const State state = any_state();
      const double t = any_time();
      REQUIRE(ask(body, wrench, t, state) ==
              close_to(right(body, wrench, t, state), rounding_of_rate(body, state)));
    }
  }

  TEST_CASE("right, with what pushes evaluated exactly once: at t, in the state as it is packed") {
    for (int n = 0; n < 5; ++n) {
      const Body body = any_body();
      const WrenchAt wrench = any_wrench();
      const State state = any_state();
      const double t = any_time();
      const auto rate = ask(body, wrench, t, state);
      REQUIRE(rate == close_to(right(body, wrench, t, state), rounding_of_rate(body, state)));
      const auto& asked = rate.evaluations();
      REQUIRE(rate == obeys("what pushes is evaluated exactly once",
                            std::abs(static_cast<double>(asked.size()) - 1), 0));
      const double time = from_value<double>(asked[0].arguments[0]);
      const State place = from_value<State>(asked[0].arguments[1]);
      REQUIRE(rate == obeys("it is evaluated at the time t", std::abs(time - t), 0));
      REQUIRE(rate == obeys("it is evaluated in the state of y, unrounded",
                            (reference::pack(place) - reference::pack(state)).norm(), 0));
    }
  }

  TEST_CASE("right whatever the body is and does; the momenta change by the force and the torque") {
    for (const double mass : {1e-3, 1., 1e3}) {
      const Vec3 moments = mass * any_moments();
      const Body body = body_with(mass, moments, any_rotation());
      State state = any_state();
      state.P *= mass;
      state.L *= mass;
      const Vec3 F = any_vector(20), tau = any_vector(20);
      const WrenchAt wrench = constant_wrench(F, tau);
      const auto rate = ask(body, wrench, any_time(), state);
      REQUIRE(rate ==
              close_to(right(body, wrench, 0, state), rounding_of_rate(body, state) + 40 * eps));
      const Vec3 Pdot = rate->segment<3>(7), Ldot = rate->segment<3>(10);
      REQUIRE(rate == obeys("Ṗ = F, unrounded", (Pdot - F).norm(), 0));
      REQUIRE(rate == obeys("L̇ = τ, unrounded", (Ldot - tau).norm(), 0));
    }
  }

  TEST_CASE("an upright body of 2 kg with moments 1, 2 and 3, by hand") {
    const Body body = upright_body(2, {1, 2, 3});
    const Vec3 F(1, 2, 3), tau(4, 5, 6);
    for (const auto& [L, qdot] : {std::pair(Vec3(6, 0, 0), Quaternion(0, 3, 0, 0)),
                                  std::pair(Vec3(0, 6, 0), Quaternion(0, 0, 1.5, 0)),
                                  std::pair(Vec3(0, 0, 6), Quaternion(0, 0, 0, 1))}) {
      const State state{any_vector(3), {1, 0, 0, 0}, {2, 4, 6}, L};
      REQUIRE(ask(body, constant_wrench(F, tau), any_time(), state) ==
              close_to(reference::pack({{1, 2, 3}, qdot, F, tau}), rounding_of_rate(body, state)));
    }
  }

  TEST_CASE(
      "q·q̇ = 0, and a quaternion twice as long changes twice as fast, everything else alike") {
    for (int n = 0; n < 10; ++n) {
      const Body body = any_body();
      const Vec3 F = any_vector(3), tau = any_vector(3);
      const WrenchAt wrench = constant_wrench(F, tau);
      State state = any_state();
      const auto once = ask(body, wrench, any_time(), state);
      const Quaternion qdot = once->segment<4>(3);
      // Each of the four numbers is off by `rounding_of_rate` at most.
      REQUIRE(once == obeys("q·q̇ = 0", std::abs(state.q.dot(qdot)),
                            4 * state.q.norm() * rounding_of_rate(body, state)));
      PackedState expected = once;
      expected.segment<4>(3) *= 2;
      state.q *= 2;
      REQUIRE(ask(body, wrench, any_time(), state) ==
              close_to(expected, 2 * rounding_of_rate(body, state)));
    }
  }

  TEST_CASE(
      "the energy grows by what the force and the torque do: F·v + τ·ω, and not without them") {
    for (int n = 0; n < 10; ++n) {
      const Body body = any_body();
      const Vec3 F = any_vector(3), tau = any_vector(3);
      for (const WrenchAt& wrench : {no_wrench(), constant_wrench(F, tau)}) {
        const bool pushed = wrench(0, any_state()).force != Vec3::Zero();
        State state = any_state();
        state.q = any_unit_quaternion();
        const auto rate = ask(body, wrench, any_time(), state);
        const double h = 0x1p-13;
        const auto energy_after = [&](double time) {
          const PackedState y = reference::pack(state) + time * rate.value();
          return reference::energy(body, reference::unpack(y));
        };
        const double slope = (energy_after(h) - energy_after(-h)) / (2 * h);
        const Derived now = reference::derived(body, state);
        const double power = pushed ? F.dot(now.v) + tau.dot(now.omega) : 0;
        // In body axes L turns at ω while the torque adds to it, so that each derivative of it is
        // at most `speed` times the one before; the third derivative of the energy has eight terms,
        // and ½ before them. Each energy is off by what v and ω are, times P and L.
        const double speed = now.omega.norm() + tau.norm() / state.L.norm();
        const double third =
            4 * speed * speed * speed * size_of_motion(body, state) * state.L.norm();
        REQUIRE(rate == obeys("Ṫ = F·v + τ·ω", std::abs(slope - power),
                              h * h / 6 * third + 2 * rounding(body, state) *
                                                      (state.P.norm() + state.L.norm()) / h));
      }
    }
  }

  TEST_CASE("ẏ is the slope of a free flight: a symmetric top, whose motion is known") {
    for (int n = 0; n < 10; ++n) {
      const double transverse = any_number(1, 2), axial = any_number(0.5, 1.9 * transverse);
      const double mass = any_number(0.5, 5);
      const Body body = body_with(mass, {transverse, transverse, axial}, any_rotation());
      State state = any_state();
      state.q = any_unit_quaternion();
      const double h = 0x1p-13;
      const auto after = [&](double time) {
        const tumble::RigidBodyState<> start{state.x, tumble::from_coefficients<double>(state.q),
                                             state.P, state.L};
        const auto end =
            tumble::free_symmetric_top(tumble::RigidBody<>(mass, body.I_body), start, time);
        return reference::pack({end.x, tumble::coefficients(end.q), end.P, end.L});
      };
      const PackedState slope = (after(h) - after(-h)) / (2 * h);
      // The state turns about two axes, at no more than 2 ω together: a central difference misses
      // h²/6 of its third derivative. Each state is off by some 200 eps.
      const double speed = 2 * size_of_motion(body, state);
      REQUIRE(ask(body, no_wrench(), any_time(), state) ==
              close_to(slope, h * h / 6 * speed * speed * speed +
                                  200 * eps * (state.L.norm() + state.P.norm() + 3) / h));
    }
  }

  TEST_CASE("at rest, spinning at 10000 rad/s, and a needle a million times easier to spin") {
    const Body needle = body_with(1, {1, 1, 1e-6}, any_rotation());
    for (const Body& body : {any_body(), needle}) {
      for (const double size : {0., 1., 1e4}) {
        State state = any_state();
        state.q.normalize();
        const Mat3 R = reference::to_matrix(state.q);
        state.P = any_vector(size);
        state.L = size * R * (body.I_body * any_direction());
        const WrenchAt wrench = any_wrench();
        const double t = any_time();
        REQUIRE(ask(body, wrench, t, state) ==
                close_to(right(body, wrench, t, state), rounding_of_rate(body, state)));
      }
    }
  }

  TEST_CASE("specks of dust and planets, tiny and huge quaternions") {
    for (const double size : {1e-100, 1e-20, 1e20, 1e100}) {
      const Body like = any_body();
      const Body body = {size * like.mass, size * like.I_body, like.I_body_inv / size};
      State state = any_state();
      state.P *= size;
      state.L *= size;
      // Their momenta change by as much as suits them: that is not what is tried here.
      REQUIRE(ask(body, no_wrench(), any_time(), state) ==
              close_to(right(body, no_wrench(), 0, state), rounding_of_rate(body, state)));
      const State other = any_state();
      state = {other.x, size * any_unit_quaternion(), Vec3::Zero(), state.L};
      REQUIRE(ask(body, no_wrench(), any_time(), state) ==
              close_to(right(body, no_wrench(), 0, state), rounding_of_rate(body, state)));
    }
  }
}

const Misconceptions<decltype(rigid_body::dydt)> misconceptions{
    TUMBLE_UNIT,
    {{"momentum for velocity",
      "You let the position change at the rate P. A heavier body with the same momentum is slower: "
      "what do you have to divide P by?",
      "Derived quantities",
      with_law([](const Body&, const State& s, const Derived& now, const Wrench& push) {
        State ydot = rates(s, now, push);
        ydot.x = s.P;
        return ydot;
      })},
     {"acceleration for force",
      "You divided the force by the mass. That is the rate of a velocity; the rate of P is the "
      "force as it is.",
      "The right-hand side",
      with_law([](const Body& body, const State& s, const Derived& now, Wrench push) {
        push.force /= body.mass;
        return rates(s, now, push);
      })},
     {"angular acceleration for torque",
      "You multiplied the torque by the inverse tensor. That is a part of the rate of ω; the rate "
      "of L is the torque as it is.",
      "The right-hand side",
      with_law([](const Body& body, const State& s, const Derived& now, Wrench push) {
        push.torque = now.R * (body.I_body_inv * (now.R.transpose() * push.torque));
        return rates(s, now, push);
      })},
     {"gyroscopic term added",
      "You took ω × L off the torque. That term belongs to Euler's equations, in body axes. Our L "
      "is in world axes, and there it stands still without a torque.",
      "The gyroscopic term",
      with_law([](const Body&, const State& s, const Derived& now, Wrench push) {
        push.torque -= now.omega.cross(s.L);
        return rates(s, now, push);
      })},
     {"force and torque swapped",
      "You gave the torque to P and the force to L. Which of the two moves the centre of mass?",
      "The right-hand side",
      with_law([](const Body&, const State& s, const Derived& now, Wrench push) {
        std::swap(push.force, push.torque);
        return rates(s, now, push);
      })},
     {"torque turned as well",
      "You turned the torque by R, as if it came in body axes. What pushes is in world axes, force "
      "and torque alike.",
      "Frames of reference",
      with_law([](const Body&, const State& s, const Derived& now, Wrench push) {
        push.torque = now.R * push.torque;
        return rates(s, now, push);
      })},
     {"factor ½ forgotten",
      "Your quaternion changes twice as fast as the body turns. It holds half the angle of the "
      "turn: which factor is missing?",
      "The right-hand side",
      with_law([](const Body&, const State& s, const Derived& now, const Wrench& push) {
        State ydot = rates(s, now, push);
        ydot.q *= 2;
        return ydot;
      })},
     {"factors of the quaternion's rate swapped",
      "You put ω on the right of q, where an ω in body axes belongs. Yours is in world axes.",
      "Frames of reference",
      with_law([](const Body&, const State& s, const Derived& now, const Wrench& push) {
        State ydot = rates(s, now, push);
        ydot.q = reference::product(s.q, pure(now.omega)) / 2;
        return ydot;
      })},
     {"body tensor used in the world",
      "You made ω of a tensor in body axes and an L in world axes. That is right only while the "
      "body stands upright.",
      "Frames of reference", with_omega([](const Mat3&, const Body& body, const Vec3& L) -> Vec3 {
        return body.I_body_inv * L;
      })},
     {"ω left in body axes", "You left ω in body axes, and used it as if it were in world axes.",
      "Frames of reference", with_omega([](const Mat3& R, const Body& body, const Vec3& L) -> Vec3 {
        return body.I_body_inv * (R.transpose() * L);
      })},
     {"turned the wrong way for ω",
      "You swapped R and its transpose on the way from L to ω: L is turned further instead of into "
      "body axes.",
      "Frames of reference", with_omega([](const Mat3& R, const Body& body, const Vec3& L) -> Vec3 {
        return R.transpose() * (body.I_body_inv * (R * L));
      })},
     {"tensor for its inverse",
      "You multiplied L by the tensor. On the way from L to ω you need its inverse.",
      "Derived quantities", with_omega([](const Mat3& R, const Body& body, const Vec3& L) -> Vec3 {
        return R * (body.I_body * (R.transpose() * L));
      })},
     {"angular momentum for angular velocity",
      "You put L itself into the quaternion's rate. How fast a body with this L turns depends on "
      "its tensor.",
      "Derived quantities",
      with_omega([](const Mat3&, const Body&, const Vec3& L) -> Vec3 { return L; })},
     {"q normalised first",
      "You gave the rate of q/|q|. A solver adds up slopes at states that it makes up, so it needs "
      "the slope at this very q.",
      "The length of q",
      with_law([](const Body&, const State& s, const Derived& now, const Wrench& push) {
        State ydot = rates(s, now, push);
        ydot.q /= s.q.norm();
        return ydot;
      })},
     {"length of q ignored for ω",
      "You made R as if q had length 1, and ω with it. In the states that a solver tries out q is "
      "longer or shorter, and then your R stretches.",
      "Derived quantities",
      with_law([](const Body& body, const State& s, Derived now, const Wrench& push) {
        const Mat3 V = tumble::rotation::skew<double>(s.q.tail<3>());
        const Mat3 R = Mat3::Identity() + 2 * (s.q[0] * V + V * V);
        now.omega = R * (body.I_body_inv * (R.transpose() * s.L));
        return rates(s, now, push);
      })},
     {"state repaired before the forces are asked",
      "You evaluated what pushes in a state with q scaled to length 1. Evaluate it in the state "
      "that you unpacked, as it is.",
      "Force and torque",
      [](const Body& body, const WrenchAt& wrench, double t, const PackedState& y) {
        State s = reference::unpack(y);
        s.q.normalize();
        return reference::rate(body, reference::unpack(y), wrench(t, s));
      }},
     {"always at time zero",
      "You evaluated what pushes at the time 0. It may depend on t: pass t on.", "Force and torque",
      [](const Body& body, const WrenchAt& wrench, double, const PackedState& y) {
        return reference::dydt(body, wrench, 0, y);
      }},
     {"asked more than once",
      "Your result is right, but you evaluated what pushes more than once. In a scene with many "
      "contacts that costs nearly all of the time: keep the answer.",
      "Force and torque",
      [](const Body& body, const WrenchAt& wrench, double t, const PackedState& y) {
        wrench(t, reference::unpack(y));
        return reference::dydt(body, wrench, t, y);
      }},
     {"rate added to the state",
      "You added y to the result. Return the rate alone; the step is the solver's business.",
      "The right-hand side",
      [](const Body& body, const WrenchAt& wrench, double t, const PackedState& y) -> PackedState {
        return y + reference::dydt(body, wrench, t, y);
      }},
     {"rates in another order",
      "Your four rates are right, but you packed them in the order x, P, q, L. Put each rate in "
      "the place of the number whose rate it is.",
      "Packing", [](const Body& body, const WrenchAt& wrench, double t, const PackedState& y) {
        const PackedState ydot = reference::dydt(body, wrench, t, y);
        PackedState other;
        other << ydot.segment<3>(0), ydot.segment<3>(7), ydot.segment<4>(3), ydot.segment<3>(10);
        return other;
      }}}};
