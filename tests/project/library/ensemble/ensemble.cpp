#include "tumble/ensemble/ensemble.hpp"

#include <doctest/doctest.h>

#include "project/harness/refusal.hpp"
#include "project/harness/relative_error.hpp"
#include "scenes.hpp"

using namespace tumble;
using namespace tumble::detail;
using test::eps;

TEST_CASE("Ensemble: gives back the states it was made of, in the bodies' own axes") {
  const test::Bodies all = test::random_bodies(20, 3, 621);
  const Ensemble ensemble = all.ensemble();
  REQUIRE(ensemble.size() == 20);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const RigidBodyState<> given = all.states[i], back = ensemble.state(i);
    CHECK(back.x == given.x);
    CHECK(angle_between(back.q, given.q) <= 32 * eps);  // turned to the principal axes and back
    CHECK((back.P - given.P).norm() <= 2 * eps * given.P.norm());
    CHECK((back.L - given.L).norm() <= 64 * eps * given.L.norm());
  }
}

TEST_CASE("Ensemble: holds principal moments and what Euler's equations need, in every lane") {
  const test::Bodies all = test::random_bodies(11, 3, 622);
  Ensemble ensemble = all.ensemble();
  REQUIRE(ensemble.bodies().size() == 2);
  for (std::size_t i = 0; i < 2; ++i)
    for (int lane = 0; lane < ensembles::eight; ++lane) {
      const auto& moments = ensemble.bodies()[i].moments;
      const auto& asymmetry = ensemble.motions(i).spins.asymmetry;
      const double A = moments[0][lane], B = moments[1][lane], C = moments[2][lane];
      CHECK(A > 0);
      CHECK(A <= B);
      CHECK(B <= C);
      CHECK(std::abs(asymmetry[0][lane] - (B - C) / A) <= eps);
      CHECK(std::abs(asymmetry[1][lane] - (C - A) / B) <= eps);
      CHECK(std::abs(asymmetry[2][lane] - (A - B) / C) <= eps);
    }
}

TEST_CASE("Ensemble: a quaternion of any length is a rotation") {
  test::Bodies all = test::random_bodies(1, 3, 623);
  const RigidBodyState<> given = all.states[0];
  all.states[0].q.coeffs() *= 1e-200;
  const RigidBodyState<> back = all.ensemble().state(0);
  CHECK(angle_between(back.q, given.q) <= 32 * eps);
  CHECK((back.L - given.L).norm() <= 64 * eps * given.L.norm());
  CHECK(std::abs(back.q.norm() - 1) <= 4 * eps);
}

TEST_CASE("Ensemble: of no bodies is one, and there is nothing to lose") {
  Ensemble none({}, {});
  CHECK(none.size() == 0);
  CHECK(advance(none, {0.01, 10}, Weight{}).count == 0);
  CHECK_REFUSED(none.state(0), "no body 0");
}

TEST_CASE("Ensemble: refuses what it cannot move, and says which") {
  test::Bodies all = test::random_bodies(5, 3, 624);
  const auto with = [&](auto&& spoil) {
    test::Bodies some = all;
    spoil(some);
    return some;
  };
  CHECK_REFUSED(with([](auto& b) { b.states.pop_back(); }).ensemble(), "5 bodies", "4 states");
  CHECK_REFUSED(with([](auto& b) { b.states[3].x.y() = NAN; }).ensemble(), "body 3", "nan");
  CHECK_REFUSED(with([](auto& b) { b.states[2].P.x() = INFINITY; }).ensemble(), "body 2", "inf");
  CHECK_REFUSED(with([](auto& b) { b.states[4].L.z() = NAN; }).ensemble(), "body 4", "nan");
  CHECK_REFUSED(with([](auto& b) { b.states[1].q.coeffs().setZero(); }).ensemble(), "body 1",
                "quaternion");
  CHECK_REFUSED(all.ensemble().state(5), "no body 5", "of 5");
}

TEST_CASE("advance: refuses what makes no sense, with words") {
  Ensemble ensemble = test::random_bodies(5, 3, 625).ensemble();
  const auto go = [&](const FixedSteps& steps, const auto&... forces) {
    return advance(ensemble, steps, forces...).count;
  };
  CHECK_REFUSED(go({NAN, 1}), "step", "nan");
  CHECK_REFUSED(go({INFINITY, 1}), "step", "inf");
  for (const double h : {1e-320, -1e-320, 5e-324, 1e-151})
    CHECK_REFUSED(go({h, 3}, BodyDrag{1, 1}), "step is", "at least 1e-150 s");
  CHECK(go({-1e-150, 3}, BodyDrag{1, 1}, ForceAtBodyPoint{Vec3(1, 2, 3), Vec3(1, 0, 0)}) == 0);
  CHECK_REFUSED(go({0.1, 1, NAN}), "time", "nan");
  CHECK_REFUSED(go({0.1, -1}), "steps", "-1");
  CHECK_REFUSED(go({0.1, 1, 0, {0}}), "threads", "0");
  if (simd::best_instruction_set() != simd::InstructionSet::avx512)
    CHECK_REFUSED(go({0.1, 1, 0, {1, simd::InstructionSet::avx512}}), "instruction set");
  CHECK_REFUSED(go({0.1, 1}, Weight{Vec3(0, 0, NAN)}), "weight", "nan");
  CHECK_REFUSED(go({0.1, 1}, BodyDrag{-1, 0}), "drag", "-1");
  CHECK_REFUSED(go({0.1, 1}, ForceAtBodyPoint{Vec3(INFINITY, 0, 0), Vec3::Zero()}), "force", "inf");
  std::vector<BodyDrag> drags(4, BodyDrag{1, 1});
  CHECK_REFUSED(go({0.1, 1}, ensemble::PerBody{drags}), "4 forces", "5 bodies");
  drags.push_back({1, -2});
  CHECK_REFUSED(go({0.1, 1}, ensemble::PerBody{drags}), "body 4", "drag", "-2");
}

TEST_CASE("advance: no step, or steps of no length, change nothing") {
  const test::Bodies all = test::random_bodies(5, 3, 626);
  for (const FixedSteps& steps : {FixedSteps{0.1, 0}, FixedSteps{0, 10}}) {
    Ensemble ensemble = all.ensemble();
    CHECK(advance(ensemble, steps, Weight{}, BodyDrag{1, 1}).count == 0);
    for (std::size_t i = 0; i < all.size(); ++i) {
      const RigidBodyState<> before = all.ensemble().state(i), after = ensemble.state(i);
      CHECK(after.x == before.x);
      CHECK(after.P == before.P);
      CHECK(angle_between(after.q, before.q) <= 4 * eps);  // normalised once more
      CHECK((after.L - before.L).norm() <= 8 * eps * before.L.norm());
    }
  }
}

TEST_CASE("require_none: says how many bodies are lost, and the first of them") {
  require_none({});
  const auto lost = [] {
    LostBodies some;
    some.add(17);
    some.add(23);
    return some;
  };
  const std::string message = test::message_of<std::runtime_error>([&] { require_none(lost()); });
  CHECK(test::mentions(message, "2 of", "body 17"));
}

static_assert(std::is_same_v<ensembles::DefaultMethod<>, TaylorMagnus<4>>);
static_assert(
    std::is_same_v<ensembles::DefaultMethod<Weight, ensemble::PerBody<BodyDrag>>, TaylorMagnus<4>>);
static_assert(std::is_same_v<ensembles::DefaultMethod<Weight, test::Tether>, Rk4>);
static_assert(ensemble::PackForce<test::Tether> && !ensemble::PackForce<Weight> &&
              !ensemble::PackForce<SpringToWorld>);
