#include "tumble/simulate/first_event.hpp"

#include <doctest/doctest.h>

#include "tumble/simulate/simulate.hpp"

using namespace tumble;

namespace {

const RigidBody<> body(1, Mat3(Vec3(1, 2, 2.5).asDiagonal()));

}  // namespace

TEST_CASE("first_event: when a thrown body is back on the floor, to the last digits") {
  RigidBodyState<> start;
  start.x = Vec3(0, 0, 2);
  start.P = Vec3(1, 0, 3);
  const Weight weight;
  const double g = -weight.g.z(), truth = (3 + std::sqrt(9 + 2 * g * 2)) / g;
  const Trajectory flight = simulate(body, start, {0, 10, 1e-9}, weight);
  const auto landing =
      first_event(flight, [](double, const RigidBodyState<>& s) { return s.x.z(); });
  REQUIRE(landing);
  CHECK(std::abs(landing->t - truth) < 4e-15);
  CHECK(std::abs(landing->state.x.z()) < 1e-14);
}

TEST_CASE("first_event: within a step of an integration") {
  RigidBodyState<> start;
  start.L = Vec3(0, 0, 5);
  const ForceAtBodyPoint pull{Vec3(0, 0, -5), Vec3(0.3, 0, 1)};
  const Trajectory motion = simulate(body, start, {0, 5, 1e-10}, pull);
  const auto tilt = [](double, const RigidBodyState<>& s) {
    return (s.q * Vec3(0, 0, 1)).z() - 0.99;
  };
  const auto event = first_event(motion, tilt);
  REQUIRE(event);
  CHECK(std::abs(tilt(0, event->state)) < 1e-14);
  for (const double part : {0.1, 0.5, 0.999}) CHECK(tilt(0, motion.at(part * event->t)) > 0);
}

TEST_CASE("first_event: none, at once, and from zero on") {
  const Trajectory still = simulate(body, {}, {0, 4, 1e-9});
  CHECK_FALSE(first_event(still, [](double, const RigidBodyState<>&) { return 1.0; }));
  const auto clock = first_event(still, [](double t, const RigidBodyState<>&) { return t - 0.5; });
  REQUIRE(clock);
  CHECK(clock->t == 0.5);
  const auto jump =
      first_event(still, [](double t, const RigidBodyState<>&) { return t < 3.3 ? -1 : 1; });
  REQUIRE(jump);
  CHECK(jump->t == 3.3);
  CHECK_FALSE(first_event(still, [](double t, const RigidBodyState<>&) { return t; }));
}
