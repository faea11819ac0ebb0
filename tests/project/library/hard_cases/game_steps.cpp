// A million steps of 1/60 s, as a game takes them: four hours and a half.
#include <doctest/doctest.h>

#include "project/harness/sanitized.hpp"
#include "tumble/ensemble/advance.hpp"
#include "tumble/geometric/splitting.hpp"
#include "tumble/ode/integrate_fixed.hpp"
#include "tumble/ode/rk4.hpp"
#include "tumble/steady/lagrange_top.hpp"
#include "turning.hpp"

using namespace tumble;
using test::eps;

namespace {

constexpr int steps = test::tries(1'000'000);
constexpr double h = 1.0 / 60, whole_time = steps / 60.0;

/// What is left in the end.
struct Kept {
  double energy, L;  ///< relative error
  double length;     ///< | |q| − 1 |
  double angle;      ///< [rad]
};

Kept kept(const RigidBody<>& body, const RigidBodyState<>& start, const RigidBodyState<>& end,
          const Quat& truth) {
  return {std::abs(kinetic_energy(body, end) / kinetic_energy(body, start) - 1),
          (end.L - start.L).norm() / start.L.norm(), std::abs(end.q.norm() - 1),
          angle_between(end.q.normalized(), truth)};
}

template <class Method>
RigidBodyState<> by_ensemble(const RigidBody<>& body, const RigidBodyState<>& start) {
  Ensemble ensemble(std::span(&body, 1), std::span(&start, 1));
  CHECK(advance<Method>(ensemble, {h, steps}).count == 0);
  return ensemble.state(0);
}

}  // namespace

TEST_CASE("game steps: a free body") {
  const Vec3 J(1, 2, 3);
  const RigidBody<> body = test::body_with(J);
  const RigidBodyState<> start = test::turning(J, Vec3(0.5, 1, 0.7));
  const Quat truth = test::truth_of(J, start).at(whole_time).q;

  const Kept by_rk4 = kept(
      body, start,
      unpack<double>(integrate_fixed<Rk4>(RigidBodyRhs(body), pack(start), 0, whole_time, steps)),
      truth);
  CHECK(by_rk4.L == 0);  // a free body's rate of L is 0: nothing is ever added
  CHECK(by_rk4.energy < 1e-6);
  CHECK(by_rk4.length < 1e-6);
  CHECK(by_rk4.angle < 0.01);

  const Kept ensemble = kept(body, start, by_ensemble<Rk4>(body, start), truth);
  CHECK(ensemble.energy < 2e-7);
  CHECK(ensemble.length <= 4 * eps);
  CHECK(ensemble.angle < 1e-3);

  const Kept series = kept(body, start, by_ensemble<TaylorMagnus<8>>(body, start), truth);
  CHECK(series.energy < 1e-12);  // of 1e6 roundings
  CHECK(series.L < 1e-12);
  CHECK(series.length <= 4 * eps);
  CHECK(series.angle < 1e-8);
}

TEST_CASE("game steps: a top under its weight, by a splitting") {
  const Vec3 J(1, 1, 0.5);
  const RigidBody<> body = test::body_with(J);
  const Quat q(std::cos(0.25), std::sin(0.25), 0, 0);
  const RigidBodyState<> start{Vec3::Zero(), q, Vec3::Zero(),
                               q * Vec3(J.cwiseProduct(Vec3(0.25, 0, 10)))};
  const ForceAtBodyPoint weight{Vec3(0, 0, -5), Vec3(0, 0, 1)};
  const auto held = [&](double t, const RigidBody<>& b, const Derived<>& now) -> Wrench<> {
    return {Vec3::Zero(), weight(t, b, now).torque};
  };
  const RigidBodyRhs motion(body, held);
  const geometric::Splitting<geometric::Strang, std::decay_t<decltype(held)>> splitting(motion);
  const auto energy = [&](const RigidBodyState<>& s) {
    return kinetic_energy(body, s) + 5 * (s.q * Vec3(0, 0, 1)).z();
  };
  RigidBodyState<> s = start;
  double early = 0, late = 0, length = 0;
  for (int i = 0; i < steps; ++i) {
    s = splitting.step(i * h, s, h);
    const double off = std::abs(energy(s) / energy(start) - 1);
    (i < steps / 100 ? early : late) = std::max(i < steps / 100 ? early : late, off);
    length = std::max(length, std::abs(s.q.norm() - 1));
  }
  // Order 2 in steps of a sixth of a radian: the energy is off, but no more in the end than soon.
  CHECK(early < 1e-3);
  CHECK(late < 1.1 * early);
  CHECK(length <= 4 * eps);
}
