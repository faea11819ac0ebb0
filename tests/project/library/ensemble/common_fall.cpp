#include "tumble/ensemble/common_fall.hpp"

#include <doctest/doctest.h>

#include "project/library/ensemble/scenes.hpp"

using namespace tumble;
using test::eps;

namespace {

/// The weight of each body by itself: the same fall, written body by body.
std::vector<Weight> each(const Weight& weight, std::size_t n) { return {n, weight}; }

}  // namespace

TEST_CASE("common fall: steps of many lengths under many weights add up to the parabolas") {
  const test::Bodies all = test::random_bodies(21, 3, 651);
  Ensemble together = all.ensemble();
  test::Random rng(652);
  std::array<long double, 3> u{}, s{};
  long double T = 0;
  for (int run = 0; run < 200; ++run) {
    const double h = rng.uniform(-0.01, 0.05);
    const int count = run % 7;
    const Weight weight{rng.vector(9)};
    const bool none = run % 5 == 0, two = run % 5 == 1;
    const std::size_t lost = none  ? advance(together, {h, count}).count
                             : two ? advance(together, {h, count}, weight, weight).count
                                   : advance(together, {h, count}, weight).count;
    CHECK(lost == 0);
    const long double t = static_cast<long double>(h) * count;
    for (std::size_t k = 0; k < 3; ++k) {
      const long double a = (none ? 0 : two ? 2 : 1) * weight.g[static_cast<int>(k)];
      s[k] += t * u[k] + t * t / 2 * a;
      u[k] += t * a;
    }
    T += t;
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    const RigidBodyState<> end = together.state(i), &start = all.states[i];
    const Vec3 v = start.P / all.bodies[i].mass();
    for (int k = 0; k < 3; ++k) {
      const auto at = static_cast<std::size_t>(k);
      const auto x = static_cast<double>(start.x[k] + T * v[k] + s[at]);
      CHECK(std::abs(end.x[k] - x) <= 400 * eps * (1 + std::abs(x)));
      CHECK(std::abs(end.P[k] / all.bodies[i].mass() - static_cast<double>(v[k] + u[at])) <=
            400 * eps);
    }
  }
}

TEST_CASE("common fall: between forces that push each body in its own way, nothing is lost of it") {
  const test::Bodies all = test::random_bodies(13, 3, 653);
  const Weight weight{{0.3, -0.2, -9.8}};
  const std::vector<Weight> weights = each(weight, all.size());
  const BodyDrag drag{0.4, 0};
  const FixedSteps steps{0.01, 3};
  Ensemble alike = all.ensemble(), apart = all.ensemble();
  for (int run = 0; run < 30; ++run) {
    CHECK(advance(alike, steps, weight).count == 0);
    CHECK(advance(apart, steps, ensemble::PerBody{weights}).count == 0);
    if (run % 3 != 0) continue;
    CHECK(advance(alike, steps, weight, drag).count == 0);
    CHECK(advance(apart, steps, weight, drag).count == 0);
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    const RigidBodyState<> a = alike.state(i), b = apart.state(i);
    CHECK((a.x - b.x).norm() <= 200 * eps * (1 + b.x.norm()));
    CHECK((a.P - b.P).norm() <= 200 * eps * (1 + b.P.norm()));
    CHECK(a.q.coeffs() == b.q.coeffs());
    CHECK(a.L == b.L);
  }
}

TEST_CASE("common fall: who falls beyond the numbers is named, and takes no other with it") {
  test::Bodies all = test::random_bodies(30, 3, 654);
  all.bodies[17] = RigidBody<>(1, Mat3(Vec3(1, 2, 2.5).asDiagonal()));
  all.states[17] = {Vec3(1e308, 0, 0), Quat(1, 0, 0, 0), Vec3(1e308, 0, 0), Vec3(1, 2, 3)};
  Ensemble ensemble = all.ensemble();
  CHECK(advance(ensemble, {0.01, 10}).count == 0);
  for (int call = 0; call < 2; ++call) {
    const LostBodies lost = advance(ensemble, {0.01, 1000}, Weight{});
    CHECK(lost.count == 1);
    CHECK(lost.first == 17);
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    CHECK(ensemble.state(i).x.allFinite() == (i != 17));
    CHECK(ensemble.state(i).L.allFinite());
  }
  // A weight without end takes all.
  CHECK(advance(ensemble, {0.01, 1000}, Weight{{0, 0, -1e308}}).count == all.size());
}

TEST_CASE("common fall: what a force of its own has done to a body is seen by the next fall") {
  const test::Bodies all = test::random_bodies(20, 3, 655);
  Ensemble ensemble = all.ensemble();
  std::vector<ForceAtBodyPoint> pulls(all.size(), {Vec3::Zero(), Vec3::Zero()});
  pulls[9].force = Vec3(1e307, 0, 0);
  CHECK(advance(ensemble, {0.01, 3}, Weight{}).count == 0);
  CHECK(advance(ensemble, {0.01, 10}, ensemble::PerBody{pulls}).count == 0);
  for (int call = 0; call < 2; ++call) {
    const LostBodies lost = advance(ensemble, {0.01, 100'000}, Weight{});
    CHECK(lost.count == 1);
    CHECK(lost.first == 9);
  }
}

TEST_CASE("common fall: a body alone falls as in company, whatever comes between") {
  const test::Bodies all = test::random_bodies(19, 3, 656);
  const Weight weight{{0.3, -0.2, -9.8}};
  const auto go = [&](Ensemble& bodies) {
    for (int run = 0; run < 4; ++run) {
      CHECK(advance(bodies, {0.01, 7}, weight).count == 0);
      CHECK(advance(bodies, {0.02, 2}, weight, BodyDrag{0.3, 0.1}).count == 0);
      CHECK(advance(bodies, {-0.005, 3}).count == 0);
    }
  };
  Ensemble together = all.ensemble();
  go(together);
  for (std::size_t i = 0; i < all.size(); ++i) {
    Ensemble alone = all.alone(i);
    go(alone);
    CHECK(test::same(alone.state(0), together.state(i)));
  }
}

TEST_CASE("common fall: without a force no time is too long") {
  test::Bodies all = test::random_bodies(1, 0, 657);
  all.states[0] = {Vec3(1, 2, 3), Quat(1, 0, 0, 0), Vec3::Zero(), Vec3::Zero()};
  Ensemble ensemble = all.ensemble();
  CHECK(advance(ensemble, {1e200, 1}).count == 0);
  CHECK(ensemble.state(0).x == Vec3(1, 2, 3));
}
