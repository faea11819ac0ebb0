#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "objects/objects.hpp"
#include "project/harness/inputs.hpp"
#include "project/harness/sanitized.hpp"
#include "project/library/contact/contact_scenes.hpp"
#include "tumble/mass.hpp"

using namespace tumble;
using contact::ContactRun;
using contact::Ending;
using test::balance;
using test::ball;
using test::box;
using test::down;
using test::gravity;
using test::over_floor;

TEST_CASE("lasting contact: every die comes to rest on a face, rough or smooth") {
  test::Random rng(1151);
  std::size_t impacts = 0;
  constexpr int dice = test::tries(8, 4);
  for (int i = 0; i < dice; ++i) {
    CAPTURE(i);
    const double e = i % 2 ? 0.4 : 0.8, mu = i % 4 < 2 ? 0.5 : 0.1;
    const auto die = over_floor(box("die", Vec3(0.02, 0.02, 0.02), Vec3(0, 0, 0.1), rng.rotation(),
                                    rng.vector(), 20 * rng.vector()),
                                e, mu);
    const ContactRun thrown = simulate_contacts(die, {.until = 100});
    impacts += thrown.impacts.size();
    REQUIRE(thrown.ending == Ending::all_at_rest);
    const Mat3 R = to_matrix(thrown.state(die, 0, thrown.t).q);
    CHECK(R.row(2).cwiseAbs().maxCoeff() > 1 - 1e-5);
    CHECK(std::abs(thrown.state(die, 0, thrown.t).x.z() - 0.01) < 1e-6);
    CHECK(std::abs(balance(thrown.energy)) < 1e-13 * thrown.energy.start);
  }
  MESSAGE("impacts of all dice: " << impacts);
}

TEST_CASE("lasting contact: T-handle, mug and wing nut come to rest, as their hulls") {
  test::Random rng(1154);
  for (const PolygonMesh& mesh : {objects::t_handle(1), objects::mug(1), objects::wing_nut(1)}) {
    const MassProperties mass = mesh_mass_properties(mesh, 2000);
    const contact::ContactBody thrown{
        "thrown", RigidBody<>(mass), collide::Convex::hull(mesh, mass.centre),
        state_of_motion<double>(RigidBody<>(mass), Vec3(0, 0, 0.3), rng.rotation(), rng.vector(),
                                10 * rng.vector())};
    const auto scene = over_floor(thrown, 0.4, 0.5);
    const ContactRun run = simulate_contacts(scene, {.until = 20});
    CHECK(run.ending == Ending::all_at_rest);
    CHECK(std::abs(balance(run.energy)) < 1e-12 * run.energy.start);
    CHECK(run.energy.impacts < 0);
    CHECK(run.energy.settled <= 0);
  }
}

TEST_CASE("lasting contact: a ball that lands with slip slides on until it rolls") {
  constexpr double r = 0.1, mu = 0.05;
  const Vec3 v(3, 1, 0), omega(0, -40, 5), arm(0, 0, r);
  const auto scene = over_floor(ball("ball", r, Vec3(0, 0, 0.3), v, omega), 0.4, mu);
  const ContactRun run = simulate_contacts(scene, {.until = 8});
  REQUIRE(run.ending == Ending::time);
  REQUIRE(run.flights[0].back().on_wall == 0);
  // About a point of the floor friction has no moment, and the weight's is taken by the floor.
  const Vec3 rolls = (5 * v + 2 * omega.cross(arm)) / 7;
  const Derived<> now = derived(scene.body(0).body, run.state(scene, 0, 8));
  const double hop = 1e-6 * r * gravity;  // energy per mass
  CHECK((now.v - rolls).norm() < hop / v.norm());
  CHECK((now.v - now.omega.cross(arm)).norm() < 1e-12);
  // The floor gives the momentum m g t, however the ball bounces; 7/2 of friction's slows the slip.
  const double until = (v - omega.cross(arm)).norm() / (3.5 * mu * gravity);
  const double hop_time = 2 * std::sqrt(2 * hop) / gravity;
  CHECK(std::abs(run.flights[0].back().t - until) < 2 * hop_time);
  CHECK(std::abs(balance(run.energy)) < 1e-12 * run.energy.start);
}

TEST_CASE("lasting contact: a ball on a slope slides down without friction, and rolls with it") {
  constexpr double tilt = 0.1, from = 4, until = 5;
  for (const double mu : {0., 0.5}) {
    CAPTURE(mu);
    auto scene = over_floor(ball("ball", 0.1, Vec3(0, 0, 0.3), Vec3::Zero()), 0.4, mu);
    scene.walls[0].normal = Vec3(std::sin(tilt), 0, std::cos(tilt));
    const ContactRun run = simulate_contacts(scene, {.until = until});
    REQUIRE(run.ending == Ending::time);
    const auto along = [&](double t) {
      return Vec3(std::cos(tilt), 0, -std::sin(tilt)).dot(run.state(scene, 0, t).P) /
             scene.body(0).body.mass();
    };
    const double pull = gravity * std::sin(tilt), acceleration = along(until) - along(from);
    CHECK(acceleration == doctest::Approx(mu > 0 ? 5 * pull / 7 : pull).epsilon(1e-3));
  }
}

TEST_CASE("lasting contact: a ball that rolls or slides slowly goes on for ever") {
  constexpr double r = 0.1, v = 1e-5, until = 100;
  for (const double mu : {0., 0.3}) {
    CAPTURE(mu);
    const Vec3 omega(0, mu > 0 ? v / r : 0, 0);
    const auto scene = over_floor(ball("ball", r, Vec3(0, 0, 0.3), Vec3(v, 0, 0), omega), 0.4, mu);
    const ContactRun run = simulate_contacts(scene, {.until = until});
    REQUIRE(run.ending == Ending::time);
    CHECK(run.state(scene, 0, until).x.x() == doctest::Approx(v * until).epsilon(1e-9));
    CHECK(run.hops(0) == 0);
  }
  const auto still = over_floor(ball("ball", r, Vec3(0, 0, 0.3), Vec3::Zero()), 0.4, 0.3);
  CHECK(simulate_contacts(still, {.until = until}).ending == Ending::all_at_rest);
  const auto spins =
      over_floor(ball("ball", r, Vec3(0, 0, 0.3), Vec3::Zero(), Vec3(0, 0, 0.5)), 0.4, 0.3);
  const ContactRun top = simulate_contacts(spins, {.until = until});
  CHECK(derived(spins.body(0).body, top.state(spins, 0, until)).omega.z() == 0.5);
}

TEST_CASE("lasting contact: without friction a box slides on, however slowly; with it, it stops") {
  const Vec3 size(0.1, 0.1, 0.1), v(0.01, 0, 0);
  const auto run_with = [&](double mu) {
    const auto scene =
        over_floor(box("box", size, Vec3(0, 0, 0.06), Quat::Identity(), v, {0, 0, 0}), 0, mu);
    const ContactRun run = simulate_contacts(scene, {.until = 5, .hop = 1e-4});
    return std::pair(run.ending, run.state(scene, 0, run.t).x.x());
  };
  const auto [slides, where] = run_with(0);
  CHECK(slides == Ending::time);
  CHECK(where == doctest::Approx(5 * v.x()).epsilon(1e-9));
  CHECK(run_with(0.3).first == Ending::all_at_rest);
  CHECK(run_with(1e-4).first != Ending::all_at_rest);  // friction needs ten seconds
}

TEST_CASE("lasting contact: on smooth ground a box spins for ever, on a face and as it slides") {
  const Vec3 v(0.2, -0.1, 0), omega(0, 0, 2);
  const auto scene = over_floor(
      box("box", Vec3(0.2, 0.2, 0.1), Vec3(0, 0, 0.05), Quat::Identity(), v, omega), 0.5);
  const ContactRun run = simulate_contacts(scene, {.until = 10, .hop = 1e-4});
  const Derived<> end = derived(scene.body(0).body, run.state(scene, 0, 10));
  CHECK((end.omega - omega).norm() < 1e-12);
  CHECK((end.x - Vec3(0, 0, 0.05) - 10 * v).norm() < 1e-9);
  CHECK(run.hops(0) == 0);
}

TEST_CASE("lasting contact: a box slides to its end, or up a slope and back, as a formula says") {
  constexpr double mu = 0.3, v = 1.5;
  const auto sliding = [&](double tilt, double until) {
    auto scene = over_floor(box("box", Vec3(0.2, 0.2, 0.1), Vec3(0, 0, 0.05), Quat::Identity(),
                                Vec3(-v, 0, 0), Vec3::Zero()),
                            0.5, mu);
    scene.gravity = gravity * Vec3(std::sin(tilt), 0, -std::cos(tilt));
    const ContactRun run = simulate_contacts(scene, {.until = until, .hop = 1e-4});
    CHECK(std::abs(balance(run.energy)) < 1e-12);
    CHECK(run.energy.sliding < 0);
    return std::pair(run.state(scene, 0, until).x.x(), run.rest_since[0]);
  };
  const double stops = v / (mu * gravity);
  CHECK(sliding(0, 2).first == doctest::Approx(-v * stops / 2).epsilon(1e-9));
  CHECK(sliding(0, 2).second == doctest::Approx(stops).epsilon(1e-9));
  constexpr double tilt = 0.4;  // friction holds it up to 0.29
  const double slows = gravity * (std::sin(tilt) + mu * std::cos(tilt)), turns = v / slows;
  const double gains = gravity * (std::sin(tilt) - mu * std::cos(tilt));
  const double back = gains * (1 - turns) * (1 - turns) / 2;
  CHECK(sliding(tilt, 1).first == doctest::Approx(back - v * turns / 2).epsilon(1e-8));
  CHECK(sliding(0.25, 2).second ==
        doctest::Approx(v / (gravity * (std::sin(0.25) + mu * std::cos(0.25)))).epsilon(1e-9));
}

TEST_CASE("lasting contact: what starts at rest in touch with a slope slides or rolls down it") {
  constexpr double tilt = 0.35, mu = 0.2, until = 1;
  const double pull = gravity * std::sin(tilt);
  const double slides = pull - mu * gravity * std::cos(tilt), rolls = 5 * pull / 7;
  const auto way_of = [&](const contact::ContactBody& body, double friction) {
    auto scene = over_floor(body, 0.3, friction);
    scene.gravity = {pull, 0, -gravity * std::cos(tilt)};
    const ContactRun run = simulate_contacts(scene, {.until = until, .hop = 1e-4});
    CHECK(run.ending == (friction < 1 ? Ending::time : Ending::all_at_rest));
    CHECK(run.energy.impacts <= 0);
    return run.state(scene, 0, run.t).x.x();
  };
  const auto flat = box("box", Vec3(0.2, 0.2, 0.1), Vec3(0, 0, 0.05), Quat::Identity(),
                        Vec3::Zero(), Vec3::Zero());
  const auto rolling = ball("ball", 0.1, Vec3(0, 0, 0.1), Vec3::Zero());
  CHECK(way_of(flat, mu) == doctest::Approx(slides / 2).epsilon(1e-9));
  CHECK(way_of(rolling, 0.5) == doctest::Approx(rolls / 2).epsilon(0.01));
  CHECK(std::abs(way_of(flat, 1)) < 1e-12);  // friction holds it
}

TEST_CASE("lasting contact: a cylinder that lands on its side comes to rest there") {
  constexpr int sides = 128;
  constexpr double r = 0.05, half = 0.1, turn = 2 * std::numbers::pi / sides;
  std::vector<Vec3> corners;
  for (int i = 0; i < sides; ++i)
    for (const double z : {-half, half})
      corners.emplace_back(r * std::cos(i * turn), r * std::sin(i * turn), z);
  const RigidBody<> body(mass_properties(Cylinder{r, 2 * half}, 1000));
  for (const double lean : {0., 0.02, 0.2}) {
    CAPTURE(lean);
    const contact::ContactBody cylinder{
        "cylinder", body, collide::Convex::hull(corners),
        state_of_motion<double>(body, Vec3(0, 0, 0.3),
                                from_axis_angle(Vec3(1, 0, 0), std::numbers::pi / 2 - lean),
                                Vec3::Zero(), Vec3::Zero())};
    const ContactRun run =
        simulate_contacts(over_floor(cylinder, 0.3, 0.5), {.until = 5, .hop = 1e-4});
    REQUIRE(run.ending == Ending::all_at_rest);
    CHECK(run.flights[0].back().state.x.z() == doctest::Approx(r).epsilon(1e-3));
  }
}
