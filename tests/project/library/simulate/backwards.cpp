#include <doctest/doctest.h>

#include "tumble/simulate/first_event.hpp"
#include "tumble/simulate/held.hpp"
#include "tumble/simulate/simulate_bodies.hpp"

using namespace tumble;

namespace {

const RigidBody<> block(2, Mat3(Vec3(1, 2, 2.5).asDiagonal()));
const RigidBodyState<> thrown_block{Vec3(0, 0, 1), Quat(1, 0.2, 0.3, 0.1).normalized(),
                                    Vec3(1, 2, 3), Vec3(1, 2.1, 0.4)};
const SpringToWorld damped_spring{Vec3(0.1, 0.2, 0), Vec3(0, 0, 2), 30, 0.3, 0.5};

/// How far the way back ends from where the way began, by the sizes of this motion (about 10).
double gap(const RigidBodyState<>& a, const RigidBodyState<>& b) {
  return (pack(a) - pack(b)).norm();
}

template <class... Forces>
void there_and_back(double t0, double t1, double tolerance, double allowed,
                    const Forces&... forces) {
  const Trajectory there = simulate(block, thrown_block, {t0, t1, tolerance}, forces...);
  const Trajectory back = simulate(block, there.end(), {t1, t0, tolerance}, forces...);
  CAPTURE(back.report().method);
  CHECK(back.report().reached());
  CHECK(gap(back.end(), thrown_block) < allowed);
  const double middle = 0.3 * t0 + 0.7 * t1;
  CHECK(gap(back.at(middle), there.at(middle)) < allowed);
  CHECK(back.t0() == t1);
  CHECK(back.t1() == t0);
  const std::vector<double> times = back.times();
  CHECK(times.front() == t1);
  CHECK(times.back() == t0);
  CHECK(std::is_sorted(times.rbegin(), times.rend()));
}

}  // namespace

TEST_CASE("simulate backwards in time leads back to the start") {
  SUBCASE("nothing turns it: in closed form") { there_and_back(-1, 4, 1e-9, 1e-12, Weight{}); }
  SUBCASE("steady forces") {
    there_and_back(0, 5, 1e-9, 1e-7, ForceAtBodyPoint{Vec3(0, 1, -3), Vec3(0.1, 0, 0.3)});
  }
  SUBCASE("drag, which pushes where time runs backwards") {
    there_and_back(0, 5, 1e-9, 1e-7, Weight{}, BodyDrag{0.3, 0.2});
  }
  SUBCASE("a spring with a damper") { there_and_back(0, 5, 1e-9, 1e-7, Weight{}, damped_spring); }
  SUBCASE("a force that knows the time and has a break") {
    const auto push = [](double t, const RigidBody<>&, const Derived<>&) {
      return Wrench<>{.force = Vec3(t < 2 ? 1 : -3, 0, std::sin(t))};
    };
    SimulationTask task{0, 5, 1e-9};
    task.breaks = {2};
    const Trajectory there = simulate(block, thrown_block, task, push);
    std::swap(task.t0, task.t1);
    CHECK(gap(simulate(block, there.end(), task, push).end(), thrown_block) < 1e-7);
  }
}

TEST_CASE("simulate backwards: a block that is held") {
  const HeldBody held(block, Vec3(0, 0, -0.4));
  const RigidBodyState<> from =
      held.state(Vec3::Zero(), Quat(1, 0.2, 0.1, 0).normalized(), Vec3(0.2, 0.1, 3));
  const Trajectory there = simulate(held, from, {0, 3, 1e-9}, Weight{});
  CHECK(gap(simulate(held, there.end(), {3, 0, 1e-9}, Weight{}).end(), from) < 1e-7);
}

TEST_CASE("first_event of a motion backwards in time is the latest, to the last digits") {
  const Weight weight;
  const double g = -weight.g.z();
  const RigidBodyState<> thrown{Vec3(0, 0, 2), Quat::Identity(), Vec3(0, 0, 6)};  // at 3 m/s
  const Trajectory back = simulate(block, thrown, {1, -9, 1e-9}, weight);
  const auto from_floor =
      first_event(back, [](double, const RigidBodyState<>& s) { return s.x.z(); });
  REQUIRE(from_floor);
  CHECK(std::abs(from_floor->t - (1 + (3 - std::sqrt(9 + 4 * g)) / g)) < 4e-15);
}

// At its final speed a body has fallen for ever, but the next double beside that speed has not:
// backwards in time the difference grows as e^(k t/m).
TEST_CASE("simulate backwards against drag says what rounding leaves of the path") {
  const RigidBody<> body(1, Mat3::Identity());
  const Vec3 speed(0, 0, -9.80665);
  const RigidBodyState<> falls{Vec3::Zero(), Quat::Identity(), speed, Vec3::Zero()};
  const SteadyForces turned{.at_point = {{Vec3(0.1, 0, 0), Vec3(0, 0.1, 0)}}};
  const SteadyForces weight_and_drag{.force = speed, .linear_drag = 1};
  const auto holds = [&](const SimulationTask& task, const SteadyForces& forces) {
    const Trajectory past = simulate(body, falls, task, forces);
    CAPTURE(task.t1);
    CAPTURE(past.report().method);
    double error = 0;
    for (const double t : {0.3 * task.t1, task.t1}) {
      error = std::max({error, (past.at(t).P - speed).norm() / speed.norm(),
                        (past.at(t).x - t * speed).norm() / (task.t1 * speed).norm()});
    }
    CHECK(error <= 10 * past.report().error_estimate);
    CHECK(past.report().reached() == (task.t1 > -20));
  };
  for (const double t1 : {-1., -10., -25., -30., -40.}) {
    holds({.t1 = t1, .tolerance = 1e-9}, weight_and_drag);
    holds({.t1 = t1, .tolerance = 1e-9}, weight_and_drag + turned);
    holds({.t1 = t1, .tolerance = 1e-9, .wanted = Wanted::path_only}, weight_and_drag);
  }
}
