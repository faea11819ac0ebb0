/// @file
/// 9.3 derived: its laws, and what goes wrong.
#include <cmath>
#include <utility>

#include "09_rigid_body/contract.hpp"
#include "judge/spec/shared/bodies.hpp"
#include "judge/spec/shared/rigid_body_reference.hpp"
#include "judge/spec/spec.hpp"
#include "tumble/rotation/orthonormality.hpp"
#include "tumble/rotation/skew.hpp"

using namespace bodies;

namespace student {
const Function<decltype(rigid_body::derived)> derived{TUMBLE_UNIT};
}

namespace {

/// The state of a body that is somewhere, is turned somehow, and moves with v and ω.
State moving(const Body& body, const Vec3& v, const Vec3& omega) {
  const Vec3 x = any_vector(3);
  const Quaternion q = any_unit_quaternion();
  const Mat3 R = reference::to_matrix(q);
  return {x, q, body.mass * v, R * (body.I_body * (R.transpose() * omega))};
}

/// The right motion but for ω, which `law` makes of R, the body and L.
template <class Law>
auto with_omega(Law law) {
  return [law](const Body& body, const State& state) -> Derived {
    Derived d = reference::derived(body, state);
    d.omega = law(d.R, body, state.L);
    return d;
  };
}

}  // namespace

TEST_SUITE(TUMBLE_UNIT) {
  TEST_CASE("any body in any state, with a quaternion of any length") {
    for (int n = 0; n < 20; ++n) {
      const Body body = any_body();
      const State state = any_state();
      REQUIRE(student::derived(body, state) ==
              close_to(reference::derived(body, state), rounding(body, state)));
    }
  }

  TEST_CASE("a body on its side: R has the axes of the body for columns, and ω = L over a moment") {
    // A quarter turn about z: the body's x axis is the world's y axis, its y axis the world's −x.
    const Body body = upright_body(2, {3, 4, 5});
    const Quaternion q = Quaternion(1, 0, 0, 1) / std::sqrt(2.);
    const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ(), P(2, 4, 6);
    Mat3 R;
    R << y, -x, z;
    for (const auto& [L, omega] :
         {std::pair(Vec3(12 * x), Vec3(3 * x)), std::pair(Vec3(12 * y), Vec3(4 * y)),
          std::pair(Vec3(15 * z), Vec3(3 * z))}) {
      const State state{any_vector(3), q, P, L};
      REQUIRE(student::derived(body, state) ==
              close_to(Derived{R, {1, 2, 3}, omega}, rounding(body, state)));
    }
  }

  TEST_CASE("R, v and ω are right to rounding, however little or far q has drifted") {
    for (const double drift :
         {0., 1e-12, 1e-9, 1e-6, 1e-3, 0.1, 1., -1e-12, -1e-9, -1e-6, -1e-3, -0.1, -0.9}) {
      const Body body = any_body();
      State state = any_state();
      state.q = any_unit_quaternion();
      const Derived expected = reference::derived(body, state);
      state.q *= 1 + drift;
      const auto now = student::derived(body, state);
      REQUIRE(now == close_to(expected, rounding(body, state)));
      // Nine numbers that are each off by `rounding` make RᵀR off by at most 6 of it.
      REQUIRE(now == obeys("RᵀR = 1", tumble::rotation::orthonormality_error(now->R),
                           6 * rounding(body, state)));
    }
  }

  TEST_CASE("what is put in as v and ω, times mass and tensor, comes out again") {
    for (int n = 0; n < 20; ++n) {
      const Body body = any_body();
      const Vec3 v = any_vector(4), omega = any_vector(4);
      const State state = moving(body, v, omega);
      const Derived expected{reference::to_matrix(state.q), v, omega};
      // L itself has been rounded like ω, and the tensor and its inverse are rounded too: the
      // condition number is in the size of the motion already.
      REQUIRE(student::derived(body, state) == close_to(expected, 2 * rounding(body, state)));
    }
  }

  TEST_CASE("turn the body and its momenta together, and v and ω turn with them") {
    for (int n = 0; n < 10; ++n) {
      const Body body = any_body();
      State state = any_state();
      const auto before = student::derived(body, state);
      const Quaternion turn = any_unit_quaternion();
      const Mat3 T = reference::to_matrix(turn);
      state.q = reference::product(turn, state.q);
      state.P = T * state.P;
      state.L = T * state.L;
      const Derived expected{T * before->R, T * before->v, T * before->omega};
      REQUIRE(student::derived(body, state) == close_to(expected, 4 * rounding(body, state)));
    }
  }

  TEST_CASE("right also with −q for q, and wherever the body is") {
    const Body body = any_body();
    State state = any_state();
    const Derived expected = reference::derived(body, state);
    state.q = -state.q;
    state.x = any_vector(1e100);
    REQUIRE(student::derived(body, state) == close_to(expected, rounding(body, state)));
  }

  TEST_CASE("at rest, spinning at 10000 rad/s, and a needle a million times easier to spin") {
    const Body needle = body_with(1, {1, 1, 1e-6}, any_rotation());
    for (const Body& body : {any_body(), needle}) {
      for (const double size : {0., 1., 1e4}) {
        const Vec3 v = any_vector(size), omega = size * any_direction();
        const State state = moving(body, v, omega);
        REQUIRE(student::derived(body, state) ==
                close_to(reference::derived(body, state), rounding(body, state)));
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
      REQUIRE(student::derived(body, state) ==
              close_to(reference::derived(body, state), rounding(body, state)));
      state.q = size * any_unit_quaternion();
      REQUIRE(student::derived(body, state) ==
              close_to(reference::derived(body, state), rounding(body, state)));
    }
  }
}

const Misconceptions<decltype(rigid_body::derived)> misconceptions{
    TUMBLE_UNIT,
    {{"R transposed",
      "Your R is transposed, and so is the one in your ω. The columns of R are the body's axes in "
      "the world; in yours the rows are.",
      "Frames of reference",
      [](const Body& body, State s) {
        s.q = reference::conjugate(s.q);
        return reference::derived(body, s);
      }},
     {"scalar read last", "You took the numbers of q in the order x, y, z, w. q[0] is the scalar.",
      "Packing",
      [](const Body& body, State s) {
        s.q = reference::read_scalar_last(s.q);
        return reference::derived(body, s);
      }},
     {"length of q ignored",
      "You made R as if q had length 1. This q has drifted, so your R stretches, and your ω is "
      "wrong with it.",
      "Derived quantities",
      [](const Body& body, const State& s) -> Derived {
        const Mat3 V = tumble::rotation::skew<double>(s.q.tail<3>());
        const Mat3 R = Mat3::Identity() + 2 * (s.q[0] * V + V * V);
        return {R, s.P / body.mass, R * (body.I_body_inv * (R.transpose() * s.L))};
      }},
     {"only the diagonal inverted",
      "You divided by the diagonal of I_body. These body axes are not the principal ones, so the "
      "tensor has products as well: multiply by its inverse, which the body has.",
      "Derived quantities", with_omega([](const Mat3& R, const Body& body, const Vec3& L) -> Vec3 {
        return R * (R.transpose() * L).cwiseQuotient(body.I_body.diagonal());
      })},
     {"momentum for velocity",
      "You returned P where v belongs. Of two bodies with the same momentum the heavier one is "
      "slower: which number do you have to bring in?",
      "Derived quantities",
      [](Body body, const State& s) {
        body.mass = 1;
        return reference::derived(body, s);
      }},
     {"multiplied by the mass",
      "Your v grows with the mass. You multiplied, as P = m v does; here you go back from P to v.",
      "Derived quantities",
      [](Body body, const State& s) {
        body.mass = 1 / body.mass;
        return reference::derived(body, s);
      }},
     {"tensor for its inverse",
      "Your ω is the tensor times L. But L is the tensor times ω: on the way back you need the "
      "inverse, and you are given it.",
      "Derived quantities",
      [](Body body, const State& s) {
        body.I_body_inv = body.I_body;
        return reference::derived(body, s);
      }},
     {"body tensor used in the world",
      "You multiplied a tensor in body axes by L in world axes. That is right only while the body "
      "stands upright: in the world the tensor turns with the body.",
      "Frames of reference", with_omega([](const Mat3&, const Body& body, const Vec3& L) -> Vec3 {
        return body.I_body_inv * L;
      })},
     {"ω left in body axes",
      "You worked ω out in body axes, where you know the tensor, and left it there. Your ω should "
      "be in world axes.",
      "Frames of reference", with_omega([](const Mat3& R, const Body& body, const Vec3& L) -> Vec3 {
        return body.I_body_inv * (R.transpose() * L);
      })},
     {"L not taken into body axes",
      "You turned the result into world axes, but before that you gave the tensor an L in world "
      "axes. Turn L into body axes first.",
      "Frames of reference", with_omega([](const Mat3& R, const Body& body, const Vec3& L) -> Vec3 {
        return R * (body.I_body_inv * L);
      })},
     {"turned the wrong way for ω",
      "Your R is right, but in your ω it is where its transpose belongs: you turned L further "
      "instead of into body axes. R maps body → world.",
      "Frames of reference", with_omega([](const Mat3& R, const Body& body, const Vec3& L) -> Vec3 {
        return R.transpose() * (body.I_body_inv * (R * L));
      })},
     {"diagonal only",
      "You used only the three numbers on the diagonal of the tensor. That is right if the body's "
      "axes are its principal axes; here they need not be.",
      "Derived quantities", with_omega([](const Mat3& R, const Body& body, const Vec3& L) -> Vec3 {
        return R * body.I_body_inv.diagonal().cwiseProduct(R.transpose() * L);
      })},
     {"a single moment",
      "Your ω points along L, as for a ball. Other bodies turn about another axis than L: the "
      "tensor is a matrix, not a number.",
      "Derived quantities", with_omega([](const Mat3&, const Body& body, const Vec3& L) -> Vec3 {
        return body.I_body_inv.trace() / 3 * L;
      })}}};
