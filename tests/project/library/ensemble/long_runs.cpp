/// @file
/// Many bodies, and many steps.

#include <doctest/doctest.h>

#include "project/harness/relative_error.hpp"
#include "scenes.hpp"

using namespace tumble;
using test::eps;

namespace {

/// The largest relative change of energy and angular momentum among some bodies.
struct Drift {
  double energy = 0, L = 0;
};

template <class Method>
Drift drift_of(const test::Bodies& all, double h, int steps) {
  Ensemble ensemble = all.ensemble();
  CHECK(advance<Method>(ensemble, {h, steps}).count == 0);
  Drift worst;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const RigidBodyState<> end = ensemble.state(i), start = all.states[i];
    worst.energy =
        std::max(worst.energy, test::relative_error(kinetic_energy(all.bodies[i], end),
                                                    kinetic_energy(all.bodies[i], start)));
    worst.L = std::max(worst.L, (end.L - start.L).norm() / start.L.norm());
  }
  return worst;
}

}  // namespace

TEST_CASE("advance: 1e5 bodies in one call, each as if alone") {
  const test::Bodies few = test::random_bodies(97, 3, 631);
  test::Bodies all;
  for (std::size_t i = 0; i < 100'000; ++i) {
    all.bodies.push_back(few.bodies[i % 97]);
    all.states.push_back(few.states[i % 97]);
  }
  Ensemble ensemble = all.ensemble();
  CHECK(advance(ensemble, {1. / 240, 12, 0, {2}}, Weight{}).count == 0);
  for (const std::size_t i :
       {std::size_t{0}, std::size_t{7}, std::size_t{50'000}, std::size_t{99'999}}) {
    Ensemble alone = few.alone(i % 97);
    CHECK(advance(alone, {1. / 240, 12}, Weight{}).count == 0);
    CHECK(test::same(ensemble.state(i), alone.state(0)));
  }
}

TEST_CASE("advance: a free body keeps energy and angular momentum over 1e5 steps") {
  const test::Bodies all = test::random_bodies(8, 3, 632);
  constexpr int steps = 100'000;
  const Drift d = drift_of<TaylorMagnus<6>>(all, 1. / 240, steps);
  MESSAGE("TaylorMagnus<6>: energy " << d.energy << ", L " << d.L);
  // Every step rounds ω and q; at worst all in the same sense.
  CHECK(d.energy <= steps * 4 * eps);
  CHECK(d.L <= steps * 4 * eps);
}

TEST_CASE("advance: what is not kept falls with the order") {
  const test::Bodies all = test::random_bodies(8, 3, 633);
  const auto check = [&]<class Method>(Method) {
    const Drift coarse = drift_of<Method>(all, 1. / 20, 2000),
                fine = drift_of<Method>(all, 1. / 40, 4000);
    MESSAGE("order " << Method::order << ": energy " << coarse.energy << " → " << fine.energy
                     << ", L " << coarse.L << " → " << fine.L);
    const double ratio = std::exp2(Method::order) / 1.5;  // terms of higher order help or hinder
    CHECK(fine.energy <= coarse.energy / ratio + 4000 * eps);
    CHECK(fine.L <= coarse.L / ratio + 4000 * eps);
  };
  check(Rk4{});
  check(TaylorMagnus<4>{});
  check(TaylorMagnus<6>{});
  check(TaylorMagnus<8>{});
}

TEST_CASE("advance: a ball spins on with the same ω to the last bit, and turns by ω t") {
  const RigidBody<> ball(2, Mat3(3 * Mat3::Identity()));
  test::Random rng(635);
  test::Bodies all;
  for (int i = 0; i < 20; ++i) {
    all.bodies.push_back(ball);
    all.states.push_back({Vec3::Zero(), Quat(1, 0, 0, 0), Vec3::Zero(), 6 * rng.vector()});
  }
  constexpr int steps = 10'000;
  constexpr double h = 1. / 60;
  Ensemble ensemble = all.ensemble(), start = all.ensemble();
  CHECK(advance(ensemble, {h, steps}).count == 0);
  for (std::size_t i = 0; i < start.bodies().size(); ++i) {
    const auto &omega = ensemble.motions(i).spins.omega, &before = start.motions(i).spins.omega;
    CHECK(std::memcmp(&omega, &before, sizeof omega) == 0);
  }
  // h is rounded once, the rotation vector and q once a step.
  for (std::size_t i = 0; i < all.size(); ++i)
    CHECK(angle_between(ensemble.state(i).q,
                        exp_quaternion<double>(h * steps / 3 * all.states[i].L)) <=
          steps * 4 * eps);
}

TEST_CASE("advance: the sets of instructions agree to rounding") {
  const test::Bodies all = test::random_bodies(16, 3, 634);
  constexpr int steps = 240;
  const ForceAtBodyPoint pull{Vec3(0.4, -0.3, -2), Vec3(0.2, 0.5, -0.3)};
  const auto after = [&](simd::InstructionSet set) {
    Ensemble ensemble = all.ensemble();
    CHECK(advance(ensemble, {1. / 240, steps, 0, {1, set}}, pull, BodyDrag{0.2, 0.1}).count == 0);
    return ensemble;
  };
  const Ensemble baseline = after(simd::InstructionSet::baseline);
  for (const simd::InstructionSet set : test::instruction_sets()) {
    const Ensemble ensemble = after(set);
    for (std::size_t i = 0; i < all.size(); ++i) {
      const RigidBodyState<> a = ensemble.state(i), b = baseline.state(i);
      CHECK(angle_between(a.q, b.q) <= steps * 4 * eps);
      CHECK((a.L - b.L).norm() <= steps * 8 * eps * b.L.norm());
      CHECK((a.x - b.x).norm() <= 64 * eps);
    }
  }
}
