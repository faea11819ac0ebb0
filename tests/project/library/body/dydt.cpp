#include "tumble/body/dydt.hpp"

#include <doctest/doctest.h>

#include "project/harness/relative_error.hpp"
#include "project/library/body/random_state.hpp"
#include "reference/rigid_body.hpp"
#include "tumble/body/matrix_state.hpp"
#include "tumble/ode/dop853.hpp"
#include "tumble/ode/integrate_adaptive.hpp"
#include "tumble/ode/integrate_fixed.hpp"
#include "tumble/ode/rk4.hpp"
#include "tumble/quaternion/exp_log.hpp"
#include "tumble/rotation/orthonormality.hpp"

using namespace tumble;
using rotation::unpack;  // and that of tumble
using test::body, test::eps, test::random_state;

namespace {

const Tolerances tight{1e-13, 1e-13};

template <class Rhs, class State>
State end_state(const Rhs& motion, const State& start, double duration) {
  return unpack<double>(integrate_adaptive<Dop853>(motion, pack(start), 0.0, duration, tight).y);
}

}  // namespace

static_assert(OdeRhs<RigidBodyRhs<double>, PackedState<double>>);
static_assert(OdeRhs<RigidBodyRhs<float, Weight>, PackedState<float>>);

TEST_CASE("dydt: a worked number, all four parts") {
  const RigidBodyState<> state{Vec3(1, 2, 3), Quat(1, 0, 0, 0), Vec3(2, 0, 0), Vec3(0, 0, 5)};
  const RigidBodyRhs motion(body, Weight{Vec3(0, 0, -10)},
                            ForceAtBodyPoint{Vec3(0, 1, 0), Vec3(1, 0, 0)});
  const RigidBodyState<> rate = motion.rate(0, state);
  CHECK(rate.x == Vec3(1, 0, 0));                              // P/m
  CHECK(coefficients(rate.q) == Eigen::Vector4d(0, 0, 0, 1));  // ½⟨0, (0,0,2)⟩
  CHECK(rate.P == Vec3(0, 1, -20));                            // F
  CHECK(rate.L == Vec3(0, 0, 1));                              // τ
  CHECK(motion(0, pack(state)) == pack(rate));
}

TEST_CASE("dydt: with nothing pushing, P, L and the energy stay and the body moves on a line") {
  test::Random rng(141);
  for (int i = 0; i < 10; ++i) {
    const RigidBodyState<> start = random_state(rng);
    const RigidBodyState<> end = end_state(RigidBodyRhs(body), start, 20);
    CHECK(end.P == start.P);
    CHECK(end.L == start.L);
    CHECK((end.x - (start.x + 20 * start.P / 2)).norm() <= 100 * eps * 20);
    CHECK(test::relative_error(kinetic_energy(body, end), kinetic_energy(body, start)) <= 1e-11);
  }
}

TEST_CASE("dydt: free fall is a parabola, and gravity does not turn the body") {
  const RigidBodyState<> start{Vec3(0, 0, 1), Quat(1, 0, 0, 0), Vec3(2, 0, 8), Vec3::Zero()};
  const RigidBodyState<> end = end_state(RigidBodyRhs(body, Weight{Vec3(0, 0, -10)}), start, 1.5);
  CHECK((end.x - Vec3(1.5, 0, 1 + 4 * 1.5 - 5 * 2.25)).norm() <= 100 * eps);
  CHECK(end.q.coeffs() == start.q.coeffs());
}

TEST_CASE("dydt: a spring conserves kinetic plus elastic energy") {
  const SpringToWorld spring{Vec3(0.5, 0.2, -0.1), Vec3(0, 0, 2), 20, 1};
  const auto energy = [&](const RigidBodyState<>& s) {
    const double stretch =
        (spring.anchor - point_position(derived(body, s), spring.p_body)).norm() - 1;
    return kinetic_energy(body, s) + 10 * stretch * stretch;
  };
  test::Random rng(142);
  for (int i = 0; i < 5; ++i) {
    const RigidBodyState<> start = random_state(rng);
    const RigidBodyState<> end = end_state(RigidBodyRhs(body, spring), start, 10);
    CHECK(end.L != start.L);
    CHECK(test::relative_error(energy(end), energy(start)) <= 1e-10);
  }
}

TEST_CASE("dydt: reaches the end of the heavy top's motion, known to 35 digits") {
  const RigidBody<> top(1, reference::top.I_body);
  const RigidBodyState<> end = end_state(RigidBodyRhs(top, reference::TopTorque{}),
                                         reference::start(reference::top), reference::top.duration);
  // About 1000 steps at a tolerance of 1e-13.
  CHECK(angle_between(end.q, reference::top.q_end) <= 1e-10);
  CHECK((end.L - reference::top.L_end).norm() <= 1e-10 * reference::top.L_end.norm());
}

TEST_CASE(
    "dydt: reaches the end of a heavy body's motion about a fixed point, known to 35 digits") {
  // What holds the point pushes back as much: at the origin of the body, where it turns nothing.
  const ForceAtBodyPoint& weight = reference::heavy_force;
  const ForceAtBodyPoint reaction{-weight.force, Vec3::Zero()};
  const RigidBodyState<> end =
      end_state(RigidBodyRhs(RigidBody<>(1, reference::heavy.I_body), weight, reaction),
                reference::start(reference::heavy), reference::heavy.duration);
  // A few hundred steps at a tolerance of 1e-13; an error grows fiftyfold.
  CHECK(angle_between(end.q, reference::heavy.q_end) <= 50 * 300 * 1e-13);
  CHECK((end.L - reference::heavy.L_end).norm() <=
        50 * 300 * 1e-13 * reference::heavy.L_end.norm());
  CHECK(end.x == Vec3::Zero());
}

TEST_CASE("dydt: quaternion and matrix state tell the same motion") {
  test::Random rng(143);
  const ForceAtBodyPoint push{Vec3(0.3, -0.2, 0.5), Vec3(0.1, 0.4, 0)};
  for (int i = 0; i < 5; ++i) {
    const RigidBodyState<> start = random_state(rng);
    const RigidBodyState<> end = end_state(RigidBodyRhs(body, push), start, 5);
    const rotation::MatrixState<> other =
        end_state(rotation::MatrixStateRhs(body, push),
                  rotation::MatrixState<>{start.x, to_matrix(start.q), start.P, start.L}, 5);
    CHECK((to_matrix(end.q) - other.R).norm() <= 1e-11);
    CHECK((end.x - other.x).norm() <= 1e-11);
    CHECK((end.L - other.L).norm() <= 1e-11);
  }
}

TEST_CASE("dydt: with RK4, the length of q and the shape of R drift off at the method's order") {
  test::Random rng(144);
  const RigidBodyState<> start = random_state(rng);
  const rotation::MatrixState<> matrix_start{start.x, to_matrix(start.q), start.P, start.L};
  const auto drifts = [&](int steps) {
    const PackedState<double> y =
        integrate_fixed<Rk4>(RigidBodyRhs(body), pack(start), 0.0, 10.0, steps);
    const rotation::PackedMatrixState<double> z =
        integrate_fixed<Rk4>(rotation::MatrixStateRhs(body), pack(matrix_start), 0.0, 10.0, steps);
    return std::pair{std::abs(unpack<double>(y).q.norm() - 1),
                     rotation::orthonormality_error(unpack<double>(z).R)};
  };
  const auto [q_coarse, R_coarse] = drifts(100);
  const auto [q_fine, R_fine] = drifts(200);
  CHECK(std::abs(std::log2(q_coarse / q_fine) - 4) <= 0.25);
  CHECK(std::abs(std::log2(R_coarse / R_fine) - 4) <= 0.25);
}

TEST_CASE("dydt: float works, and is as far from double as float is") {
  test::Random rng(145);
  const RigidBodyState<> start = random_state(rng);
  const RigidBodyRhs motion(RigidBody<float>(2, body.I_body()), Weight{});
  const PackedState<float> y =
      integrate_fixed<Rk4>(motion, PackedState<float>(pack(start).cast<float>()), 0.0f, 1.0f, 100);
  const PackedState<double> exact =
      integrate_fixed<Rk4>(RigidBodyRhs(body, Weight{}), pack(start), 0.0, 1.0, 100);
  const double error = (y.cast<double>() - exact).norm() / exact.norm();
  CHECK(error > 0);
  CHECK(error <= 100 * 4 * 0x1p-24);  // 100 steps of a few roundings each
}
