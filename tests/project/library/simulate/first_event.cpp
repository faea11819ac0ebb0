#include "tumble/simulate/first_event.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

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

TEST_CASE(
    "first_event and every_event: a function that is not a number is refused, with the time") {
  const Trajectory still = simulate(body, {}, {0, 4, 1e-9});
  const auto root = [](double t, const RigidBodyState<>&) { return std::sqrt(2 - t); };
  const char* why = "the function of an event is not a number at t = ";
  CHECK_THROWS_WITH_AS((void)every_event(still, root), doctest::Contains(why), std::runtime_error);
  const auto never = [](double, const RigidBodyState<>&) { return std::nan(""); };
  CHECK_THROWS_WITH_AS((void)first_event(still, never), doctest::Contains(why), std::runtime_error);
  const auto infinite = [](double t, const RigidBodyState<>&) { return 1 / (t - 2); };
  CHECK(first_event(still, infinite)->t == 2);
}

TEST_CASE("first_event: a short crossing at the top of a flight, between the moments looked at") {
  const Weight weight;
  const double g = -weight.g.z();
  for (const double speed : {2.9, 3.3, 3.7, 4.1})
    for (const double above : {1e-3, 1e-6, 1e-9}) {
      RigidBodyState<> start;
      start.P = Vec3(1, 0, speed);
      const double top = speed * speed / (2 * g), level = top - above;
      const auto height = [=](double, const RigidBodyState<>& s) { return s.x.z() - level; };
      CAPTURE(speed);
      CAPTURE(above);
      const Trajectory flight = simulate(body, start, {.t1 = 1.3}, weight);
      const auto passes = every_event(flight, height);
      REQUIRE(passes.size() == 2);
      const double half = std::sqrt(2 * above / g);
      CHECK(std::abs(passes[0].t - (speed / g - half)) < 1e-15 / half);
      CHECK(std::abs(passes[1].t - (speed / g + half)) < 1e-15 / half);
      CHECK(first_event(flight, height)->t == passes[0].t);
      const Trajectory back = simulate(body, flight.end(), {.t0 = 1.3, .t1 = 0}, weight);
      CHECK(every_event(back, height).size() == 2);
      CHECK(every_event(flight, [=](double, const RigidBodyState<>& s) {
              return s.x.z() - (top + above);
            }).empty());
    }
}

TEST_CASE("every_event: tops that are reached again and again, each crossing once") {
  const Trajectory still = simulate(body, {}, {0, 4, 1e-9});
  for (const double level : {0.0, 0.5, 0.9, 0.9999, 0.999999}) {
    const auto wave = [=](double t, const RigidBodyState<>&) { return std::sin(5 * t) - level; };
    std::size_t truth = 0;
    for (int k = 0; k < 4; ++k)
      for (const double phase : {std::asin(level), std::numbers::pi - std::asin(level)})
        truth += (phase + 2 * std::numbers::pi * k) / 5 < 4 && phase + 2 * std::numbers::pi * k > 0;
    CAPTURE(level);
    const auto found = every_event(still, wave);
    CHECK(found.size() == truth);
    for (std::size_t i = 1; i < found.size(); ++i) CHECK(found[i].t > found[i - 1].t);
  }
}
