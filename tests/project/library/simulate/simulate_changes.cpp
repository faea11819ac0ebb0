#include "tumble/simulate/simulate_changes.hpp"
#include "tumble/body/forces_between.hpp"

#include <doctest/doctest.h>

#include "project/harness/refusal.hpp"

using namespace tumble;
using events::simulate_changes;

namespace {

const RigidBody<> dropped_ball(2, 0.01 * Mat3::Identity());
const RigidBodyState<> dropped{Vec3(0, 0, 5)};
const double gravity = 9.80665;

double height(double, const RigidBodyState<>& s) { return s.x.z(); }

auto bounce(double e) {
  return [e](double, RigidBodyState<> s) {
    s.P.z() = -e * s.P.z();
    return s;
  };
}

}  // namespace

TEST_CASE("simulate_changes: a ball that you turn back yourself, against the closed form") {
  for (const double e : {1.0, 0.8}) {
    const auto motion =
        simulate_changes(dropped_ball, dropped, {0, 8, 1e-9}, height, bounce(e), Weight{});
    REQUIRE(motion.events.size() >= 4);
    double t = std::sqrt(10 / gravity), v = gravity * t;
    for (const Event& event : motion.events) {
      // A rounding for each event before it, of times up to 8 s.
      CHECK(std::abs(event.t - t) < 1e-14);
      CHECK(std::abs(event.state.P.z() + 2 * v) < 1e-12);
      CHECK(motion.trajectory.at(event.t).P.z() == -e * event.state.P.z());
      v *= e;
      t += 2 * v / gravity;
    }
    CHECK(motion.trajectory.report().reached());
  }
}

TEST_CASE("simulate_changes: events that come to no end are an error, and may end the motion") {
  CHECK_THROWS_WITH_AS(
      simulate_changes(dropped_ball, dropped, {0, 80, 1e-9}, height, bounce(0.5), Weight{}),
      doctest::Contains("let the change return nothing"), std::runtime_error);
  const auto until_slow = [](double, const RigidBodyState<>& s) {
    return s.P.z() > -1e-2 ? std::nullopt : std::optional(bounce(0.5)(0, s));
  };
  const auto motion =
      simulate_changes(dropped_ball, dropped, {0, 80, 1e-9}, height, until_slow, Weight{});
  CHECK(motion.trajectory.t1() == motion.events.back().t);
  CHECK(motion.trajectory.t1() < 3 * std::sqrt(10 / gravity));  // Zeno's time
  CHECK_THROWS_AS(motion.trajectory.at(4), std::invalid_argument);
}

TEST_CASE("simulate_changes: of bodies whose events follow each other closely none is missed") {
  // Each falls from its own height, and is turned back at the floor; the second a little later than
  // the first, sooner than one looks again.
  const std::vector<RigidBody<>> balls(2, dropped_ball);
  const auto lowest = [](double, const std::vector<RigidBodyState<>>& all) {
    return std::min(all[0].x.z(), all[1].x.z());
  };
  const auto turn_lowest_back = [](double, std::vector<RigidBodyState<>> all) {
    RigidBodyState<>& lowest = all[0].x.z() < all[1].x.z() ? all[0] : all[1];
    lowest.P.z() = std::abs(lowest.P.z());
    return all;
  };
  for (const double later : {1e-2, 1e-4, 1e-6}) {
    CAPTURE(later);
    const double fall = 1 + later;
    const auto motion = simulate_changes(
        balls, {{Vec3(0, 0, gravity / 2)}, {Vec3(1, 0, gravity / 2 * fall * fall)}}, {0, 2.5, 1e-9},
        lowest, turn_lowest_back, Weight{});
    REQUIRE(motion.events.size() == 2);
    CHECK(std::abs(motion.events[1].t - fall) < 1e-14);
    CHECK(motion.trajectory.end()[1].x.z() > 0);
  }
}

TEST_CASE("simulate_changes: a fall counts where rounding gives 0 some times in turn") {
  // Just before some landings the height is 0, or below it, at the double before, too.
  const ForceAtBodyPoint push{Vec3(-0.4, -0.2, 0.3), Vec3(0.04, 0.2, -0.3)};
  int landings = 0;
  for (int i = 0; i < 300; ++i) {
    RigidBodyState<> start = dropped;
    start.x.z() = 1 + 0.01 * i;
    const auto motion =
        simulate_changes(dropped_ball, start, {0, 2.5, 1e-8}, height, bounce(0.9), Weight{}, push);
    landings += static_cast<int>(motion.events.size());
    CHECK(motion.trajectory.end().x.z() > -1e-9);
  }
  CHECK(landings > 300);
}

TEST_CASE("simulate_changes: the stated error holds what events make of errors") {
  const SpringToWorld spring{Vec3::Zero(), Vec3(0.3, 0, 3), 20, 1};
  const auto run = [&](double tolerance) {
    return simulate_changes(dropped_ball, dropped, {0, 10, tolerance}, height, bounce(0.9),
                            Weight{}, spring);
  };
  const auto truth = run(1e-11);
  REQUIRE(truth.events.size() > 3);
  for (const double tolerance : {1e-4, 1e-6}) {
    const auto motion = run(tolerance);
    CAPTURE(tolerance);
    REQUIRE(motion.events.size() == truth.events.size());
    CHECK(motion.trajectory.report().reached());
    const RigidBodyState<> end = motion.trajectory.end(), right = truth.trajectory.end();
    CHECK((end.x - right.x).norm() <= motion.trajectory.report().error_estimate * dropped.x.norm());
  }
}

TEST_CASE("simulate_changes: the stated error holds the rounding of late times") {
  // Thrown up at each landing as fast as it came. At 1000 s a time is rounded to 10⁻¹³ s.
  for (const double t0 : {172.25, 664.125, 1000.5}) {
    const double back = std::sqrt(2 * dropped.x.z() / gravity), t = 4.5;
    const auto motion =
        simulate_changes(dropped_ball, dropped, {t0, t0 + t, 1e-9}, height, bounce(1), Weight{});
    REQUIRE(motion.events.size() == 2);
    const double s = t - 4 * back;
    const double off =
        std::abs(motion.trajectory.end().x.z() - (dropped.x.z() - gravity / 2 * s * s)) /
        dropped.x.z();
    const SimulationReport& report = motion.trajectory.report();
    CAPTURE(t0);
    CAPTURE(off);
    CHECK(report.error_estimate > 1e-16 * t0);
    CHECK(off <= report.error_estimate);
    CHECK(report.error_estimate < 1e-11);
  }
}

TEST_CASE("simulate_changes: a spring between two bodies tears") {
  const std::vector<RigidBody<>> balls = {dropped_ball, dropped_ball};
  const std::vector<RigidBodyState<>> starts = {{Vec3(0, 0, 0), Quat::Identity(), Vec3(-4, 0, 0)},
                                                {Vec3(1, 0, 0), Quat::Identity(), Vec3(4, 0, 0)}};
  const SpringBetween spring{0, 1, Vec3::Zero(), Vec3::Zero(), 8, 1};
  using States = std::vector<RigidBodyState<>>;
  const auto strength = [](double, const States& s) { return 2 - (s[1].x - s[0].x).norm(); };
  const auto tear = [](double, const States&) { return std::optional<States>(); };
  const auto whole = simulate_changes(balls, starts, {0, 5, 1e-9}, strength, tear, spring);
  // Each dropped_ball is 2/√8 sin √8 t away from where it was; the spring has 1 m more at the end.
  const double t = whole.trajectory.t1();
  CHECK(std::abs(t - std::asin(std::sqrt(8.) / 4) / std::sqrt(8.)) < 1e-9);
  const States torn = whole.trajectory.end();
  const States end = simulate(balls, torn, {t, 5, 1e-9}).end();
  CHECK((end[1].x - torn[1].x - (5 - t) / 2 * torn[1].P).norm() < 1e-14);
}

TEST_CASE("simulate_changes refuses to run backwards") {
  CHECK_REFUSED(simulate_changes(dropped_ball, dropped, {1, 0, 1e-9}, height, bounce(1), Weight{}),
                "t1 = 0 is before t0 = 1");
}
