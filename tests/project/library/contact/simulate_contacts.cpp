#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>

#include "project/harness/inputs.hpp"
#include "project/harness/refusal.hpp"
#include "project/harness/sanitized.hpp"
#include "project/library/contact/contact_scenes.hpp"

using namespace tumble;
using contact::ContactBody;
using contact::ContactRun;
using contact::ContactScene;
using contact::Ending;
using test::balance;
using test::ball;
using test::box;
using test::down;
using test::gravity;
using test::over_floor;

namespace {

/// A room from −half to half.
std::vector<collide::HalfSpace> room(double half) {
  std::vector<collide::HalfSpace> walls;
  for (int k = 0; k < 3; ++k)
    for (const double side : {-1., 1.})
      walls.push_back({side * half * Vec3::Unit(k), -side * Vec3::Unit(k)});
  return walls;
}

double gap_of(const ContactScene& scene, const ContactRun& run, double t) {
  double least = std::numeric_limits<double>::infinity();
  const auto pose = [&](int i) {
    const RigidBodyState<> state = run.state(scene, i, t);
    return collide::Pose{state.x, to_matrix(state.q)};
  };
  for (int i = 0; i < static_cast<int>(scene.bodies.size()); ++i) {
    for (const auto& wall : scene.walls)
      least = std::min(least, distance(scene.body(i).shape, pose(i), wall).gap);
    for (int j = 0; j < i; ++j)
      least =
          std::min(least, distance(scene.body(i).shape, pose(i), scene.body(j).shape, pose(j)).gap);
  }
  return least;
}

Vec3 momentum(const ContactScene& scene, const ContactRun& run, double t) {
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < static_cast<int>(scene.bodies.size()); ++i) sum += run.state(scene, i, t).P;
  return sum;
}

/// About the origin.
Vec3 angular(const ContactScene& scene, const ContactRun& run, double t) {
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < static_cast<int>(scene.bodies.size()); ++i) {
    const RigidBodyState<> state = run.state(scene, i, t);
    sum += state.L + state.x.cross(state.P);
  }
  return sum;
}

/// How many random throws: TUMBLE_THROWS says another number, before a release some thousands.
int number_of_throws() {
  const char* wanted = std::getenv("TUMBLE_THROWS");
  return wanted ? std::stoi(wanted) : test::tries(100);
}

}  // namespace

TEST_CASE("simulate_contacts: bodies in touch that spin, slide or hardly part cost bounded work") {
  test::Random rng(1121);
  for (int i = 0; i < test::tries(20); ++i) {
    CAPTURE(i);
    const double gaps[] = {0, 1e-11, 5e-12}, ups[] = {0, 1e-9, -1e-9};
    const Vec3 slide = i % 2 ? Vec3(rng.uniform(-1, 1), rng.uniform(-1, 1), 0) : Vec3(Vec3::Zero());
    const Vec3 v = slide + ups[i % 3] * Vec3::UnitZ();
    ContactScene scene;
    scene.e = rng.uniform(0, 1);
    scene.mu = 0.3;
    const Vec3 x(0, 0, 0.5 + gaps[i / 3 % 3]), spin(0, 0, i % 5 ? rng.uniform(-5, 5) : 0);
    scene.bodies = {
        box("upper", Vec3::Ones(), x, Quat::Identity(), v, spin),
        box("lower", Vec3::Ones(), Vec3(0, 0, -0.5), Quat::Identity(), Vec3::Zero(), Vec3::Zero())};
    const ContactRun run = simulate_contacts(scene, {.until = 0.5, .max_impacts = 1000});
    CHECK(run.queries < 1'000'000);
    CHECK(run.energy.impacts <= 1e-12 * run.energy.start);
  }
}

TEST_CASE("simulate_contacts: a ball dropped 5 m, e = 1, bounces ten times in 20 s at its times") {
  const auto scene = over_floor(ball("ball", 0.1, Vec3(0, 0, 5.1), Vec3::Zero()), 1);
  const ContactRun run = simulate_contacts(scene, {.until = 20});
  const double fall = std::sqrt(10 / gravity);
  REQUIRE(run.impacts.size() == 10);
  for (int k = 0; k < 10; ++k)
    CHECK(std::abs(run.impacts[static_cast<std::size_t>(k)].t - (2 * k + 1) * fall) < 1e-13);
  CHECK(run.ending == Ending::time);
  CHECK(std::abs(run.energy.end / run.energy.start - 1) < 1e-13);
  CHECK(run.queries < 100);
}

TEST_CASE("simulate_contacts: bounces that add up end at rest at t0 (1 + e)/(1 − e)") {
  for (const double e : {0.2, 0.5, 0.8, 0.95, 0.99, 0.999}) {
    CAPTURE(e);
    const auto scene = over_floor(ball("ball", 0.1, Vec3(3, 0, 1.1), Vec3::Zero()), e);
    const ContactRun run = simulate_contacts(scene, {.until = 1000});
    const double fall = std::sqrt(2 / gravity);
    CHECK(run.ending == Ending::all_at_rest);
    CHECK(std::abs(run.rest_since[0] / (fall * (1 + e) / (1 - e)) - 1) < 1e-12);
    CHECK(run.state(scene, 0, run.t).P.isZero(0));
    CHECK(std::abs(run.state(scene, 0, run.t).x.z() - 0.1) <= contact::ContactSettings{}.tolerance);
    for (std::size_t k = 1; k < 5; ++k) {  // heights e^2k h
      const double top = (run.impacts[k - 1].t + run.impacts[k].t) / 2;
      const double height = run.state(scene, 0, top).x.z() - 0.1;
      CHECK(std::abs(height / std::pow(e, 2. * static_cast<double>(k)) - 1) < 1e-11);
    }
    CHECK(std::abs(balance(run.energy)) < 1e-13 * run.energy.start);
  }
}

TEST_CASE("simulate_contacts: bounces end at any tolerance, at the same time") {
  const double fall = std::sqrt(2 / gravity), end = fall * 1.8 / 0.2;
  for (const double tolerance : {1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-13}) {
    CAPTURE(tolerance);
    const auto scene = over_floor(ball("ball", 0.1, Vec3(0, 0, 1.1), Vec3::Zero()), 0.8);
    const ContactRun run = simulate_contacts(scene, {.until = 10, .tolerance = tolerance});
    REQUIRE(run.ending == Ending::all_at_rest);
    CHECK(std::abs(run.rest_since[0] - end) < 1e-12);
    CHECK(std::abs(run.state(scene, 0, run.t).x.z() - 0.1) <= tolerance);
  }
}

TEST_CASE("simulate_contacts: what stands on the floor is at rest, what rolls is said to") {
  const auto still = over_floor(ball("ball", 0.1, Vec3(0, 0, 0.1), Vec3::Zero()), 0.5, 0.3);
  const ContactRun at_rest = simulate_contacts(still, {.until = 1});
  CHECK(at_rest.ending == Ending::all_at_rest);
  CHECK(at_rest.rest_since[0] < 1e-9);
  const auto cube = over_floor(
      box("cube", Vec3(1, 1, 1), Vec3(0, 0, 0.5), Quat::Identity(), Vec3::Zero(), Vec3::Zero()),
      0.5, 0.3);
  CHECK(simulate_contacts(cube, {.until = 1}).ending == Ending::all_at_rest);
  const auto thrown = over_floor(ball("ball", 0.1, Vec3(0, 0, 1), Vec3(2, 0, 0)), 0.5, 0.9);
  const ContactRun rolls = simulate_contacts(thrown, {.until = 100});
  CHECK(rolls.ending == Ending::time);
  CHECK(rolls.flights[0].back().on_wall == 0);
  const Derived<> now = derived(thrown.body(0).body, rolls.state(thrown, 0, rolls.t));
  CHECK(now.v.x() == doctest::Approx(2 * 5. / 7).epsilon(1e-10));
  const double since = rolls.flights[0].back().t, from = rolls.state(thrown, 0, since).x.x();
  CHECK(std::abs(now.x.x() - from - now.v.x() * (100 - since)) < 1e-10);
  CHECK(now.omega.y() == doctest::Approx(now.v.x() / 0.1).epsilon(1e-10));
}

TEST_CASE("simulate_contacts: a cube that lands flat leaves flat") {
  const auto flat = over_floor(
      box("cube", Vec3(1, 1, 1), Vec3(0, 0, 2), Quat::Identity(), Vec3(1, 0, 0), Vec3::Zero()),
      0.5);
  const ContactRun run = simulate_contacts(flat, {.until = 0.6});
  REQUIRE(run.impacts.size() == 1);
  CHECK(run.state(flat, 0, 0.6).L.norm() < 1e-9);
  const auto dropped = over_floor(
      box("cube", Vec3(1, 1, 1), Vec3(0, 0, 2), Quat::Identity(), Vec3::Zero(), Vec3::Zero()), 0.5);
  const double end = std::sqrt(2 * 1.5 / gravity) * 1.5 / 0.5;  // of bounces without end
  CHECK(simulate_contacts(dropped, {.until = 5}).rest_since[0] ==
        doctest::Approx(end).epsilon(1e-6));
}

TEST_CASE("simulate_contacts: Newton's cradle, and a ball that is hit at its side") {
  ContactScene cradle{{}, {}, Vec3::Zero(), 1, 0};
  for (int i = 0; i < 5; ++i)
    cradle.bodies.push_back(ball("ball", 0.5, Vec3(i ? i : -1, 0, 0), Vec3(i ? 0 : 1, 0, 0)));
  const ContactRun run = simulate_contacts(cradle, {.until = 3});
  CHECK(run.impacts.size() == 4);
  for (int i = 0; i < 5; ++i) {
    const double v = run.state(cradle, i, 3).P.x() / cradle.body(i).body.mass();
    CHECK(std::abs(v - (i == 4)) < 1e-12);
  }
  // At 45° the struck ball leaves along the line of centres, the other one at right angles.
  const double half = std::sqrt(0.5);
  const ContactScene side{{ball("cue", 0.5, Vec3(-3, half, 0), Vec3(1, 0, 0)),
                           ball("eight", 0.5, Vec3::Zero(), Vec3::Zero())},
                          {},
                          Vec3::Zero(),
                          1,
                          0};
  const ContactRun hit = simulate_contacts(side, {.until = 5});
  REQUIRE(hit.impacts.size() == 1);
  CHECK(std::abs(hit.impacts[0].t - (3 - half)) < 1e-10);
  const double m = side.body(0).body.mass();
  CHECK((hit.state(side, 1, 5).P / m - Vec3(0.5, -0.5, 0)).norm() < 1e-9);
  CHECK((hit.state(side, 0, 5).P / m - Vec3(0.5, 0.5, 0)).norm() < 1e-9);
}

TEST_CASE("simulate_contacts: many bodies in a room keep their energy, and never overlap") {
  test::Random rng(1152);
  ContactScene scene{{}, room(2), Vec3::Zero(), 1, 0};
  for (int i = 0; i < 40; ++i) {
    const Vec3 x(-1.5 + i % 4, -1.5 + i / 4 % 4, -1.5 + i / 16);
    const std::string name = "body " + std::to_string(i);
    if (i % 2)
      scene.bodies.push_back(ball(name, 0.3, x, rng.vector()));
    else
      scene.bodies.push_back(
          box(name, Vec3(0.2, 0.3, 0.4), x, rng.rotation(), rng.vector(), rng.vector()));
  }
  constexpr int until = test::tries(3);
  const ContactRun run = simulate_contacts(scene, {.until = until});
  CHECK(run.ending == Ending::time);
  CHECK(run.impacts.size() > 30u * until);
  CHECK(std::abs(run.energy.end / run.energy.start - 1) < 1e-11);
  for (int k = 0; k <= 60; ++k) CHECK(gap_of(scene, run, k * until / 60.) > -2e-11);
  MESSAGE(run.impacts.size() << " impacts, " << run.queries << " distances");
}

TEST_CASE("simulate_contacts: random throws: no NaN, no hang, no overlap, no energy gained") {
  test::Random rng(1153);
  const int throws = number_of_throws();
  int endings[4] = {};
  std::size_t impacts = 0;
  for (int i = 0; i < throws; ++i) {
    CAPTURE(i);
    const bool room_only = i % 3 == 0, two = i % 4 == 1, free = i % 5 == 2;
    ContactScene scene{{}, {}, free ? Vec3(Vec3::Zero()) : down, 0, 0};
    scene.e = i % 7 == 0 ? 1 : rng.uniform(0, 1);
    scene.mu = i % 2 ? 0 : rng.uniform(0, 1.5);
    if (room_only) scene.walls = room(2);
    if (!room_only && !two)
      scene.walls = {{Vec3(0, 0, -1), (Vec3::UnitZ() + rng.vector(0.4)).normalized()}};
    const auto body = [&](const Vec3& x, const Vec3& v) {
      if (i % 8 == 5) return ball("thrown", rng.uniform(0.1, 0.4), x, v, 10 * rng.vector());
      const Vec3 size = rng.vector(0.05, 0.5);
      return box("thrown", size, x, rng.rotation(), v, 10 * rng.vector());
    };
    scene.bodies.push_back(body(Vec3(-0.6, 0, 0), rng.vector() + Vec3(two, 0, 0)));
    if (two) scene.bodies.push_back(body(Vec3(0.6, 0, 0), rng.vector(0.3) - Vec3(two, 0, 0)));
    const ContactRun run = simulate_contacts(scene, {.until = 3, .hop = 1e-3, .max_impacts = 2000});
    ++endings[static_cast<int>(run.ending)];
    impacts += run.impacts.size();
    double scale = 0;  // of the energies
    for (const ContactBody& b : scene.bodies)
      scale += b.body.mass() * (10 + gravity * 3 * (3 + 4.5 * gravity)) +
               kinetic_energy(b.body, b.start);
    for (const contact::ImpactEvent& impact : run.impacts) {
      CHECK(impact.impulse.allFinite());
      CHECK(impact.energy <= 1e-13 * scale);
    }
    CHECK(std::abs(balance(run.energy)) < 1e-12 * scale);
    CHECK(run.energy.end <= run.energy.start + 1e-12 * scale);
    for (int k = 0; k <= 20; ++k) CHECK(gap_of(scene, run, run.t * k / 20) > -2e-11);
    if (!scene.walls.empty() || !free) continue;
    const double p = momentum(scene, run, 0).norm() + scale, all = run.t;
    CHECK((momentum(scene, run, all) - momentum(scene, run, 0)).norm() < 1e-13 * p);
    CHECK((angular(scene, run, all) - angular(scene, run, 0)).norm() < 1e-13 * p);
  }
  MESSAGE(impacts << " impacts; ended at the time " << endings[0] << ", at rest " << endings[1]
                  << ", in lasting contact " << endings[2] << ", by the cap " << endings[3]);
  CHECK(impacts > 2u * static_cast<unsigned>(throws));
  CHECK(10 * endings[3] < throws);
}

TEST_CASE(
    "simulate_contacts: scenes that are none are refused, overlaps with names and by how much") {
  const ContactBody first = ball("first", 1, Vec3(0, 0, 1), Vec3::Zero());
  const ContactBody second = ball("second", 1, Vec3(1.5, 0, 1), Vec3::Zero());
  const ContactScene good{{first}, {collide::HalfSpace{}}, down, 0.5, 0.5};
  const auto with = [&](auto change) {
    ContactScene scene = good;
    change(scene);
    return simulate_contacts(scene, {.until = 1});
  };
  CHECK_REFUSED(with([&](ContactScene& s) { s.bodies.push_back(second); }), "first", "second",
                "0.5");
  CHECK_REFUSED(with([](ContactScene& s) { s.bodies[0].start.x.z() = 0.75; }), "first", "wall 0",
                "0.25");
  CHECK_REFUSED(with([](ContactScene& s) { s.e = 1.5; }), "restitution");
  CHECK_REFUSED(with([](ContactScene& s) { s.mu = -1; }), "friction");
  CHECK_REFUSED(with([](ContactScene& s) { s.walls[0].normal *= 2; }), "normal");
  CHECK_REFUSED(with([](ContactScene& s) { s.bodies[0].start.P.x() = NAN; }), "first");
  CHECK_REFUSED(simulate_contacts(good, {.until = -1}), "until");
  CHECK_REFUSED(simulate_contacts(good, {.until = 1, .tolerance = 0}), "tolerance");
  CHECK_REFUSED(simulate_contacts(good, {.until = 1, .hop = NAN}), "hop", "nan");
  const auto capped =
      simulate_contacts(over_floor(ball("ball", 0.1, Vec3(0, 0, 1), Vec3::Zero()), 0.9),
                        {.until = 100, .max_impacts = 7});
  CHECK(capped.ending == Ending::too_many_events);
  CHECK(capped.impacts.size() == 7);
}
