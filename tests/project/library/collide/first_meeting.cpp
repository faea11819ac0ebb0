#include "tumble/collide/first_meeting.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "project/harness/inputs.hpp"
#include "project/harness/refusal.hpp"
#include "tumble/contact/flight.hpp"
#include "tumble/mass/solids/box.hpp"

using namespace tumble;
using collide::Convex;
using contact::Flight;

namespace {

const Vec3 g(0, 0, -9.81);
constexpr double tolerance = 1e-10;

RigidBody<> brick(const Vec3& size) { return RigidBody<>(mass_properties(Box{size}, 1000)); }

/// A brick in flight.
struct Thrown {
  Convex shape;
  Flight flight;

  Thrown(const Vec3& size, const Vec3& x, const Quat& q, const Vec3& v, const Vec3& omega,
         const Vec3& gravity = g)
      : shape(Convex::box(size)),
        flight(brick(size), state_of_motion<double>(brick(size), x, q, v, omega), gravity, 0) {}
  collide::Moving<Flight> moving() const { return {shape, flight}; }
  collide::Pose pose(double t) const { return collide::pose_of(flight.at(t)); }
};

Thrown any_brick(test::Random& rng, const Vec3& x, const Vec3& v, const Vec3& gravity = g) {
  const Vec3 size(rng.uniform(0.02, 1), rng.uniform(0.02, 1), rng.uniform(0.02, 1));
  return {size, x, rng.rotation(), v, 10 * rng.vector(), gravity};
}

}  // namespace

TEST_CASE("first_meeting: a ball lands at the root of the quadratic, in one step") {
  test::Random rng(1131);
  for (int i = 0; i < 500; ++i) {
    const double r = rng.uniform(0.01, 1), m = 0.4 * 3 * r * r;
    const RigidBody<> body(3, Mat3(Mat3::Identity() * m));
    const Vec3 x(rng.uniform(), rng.uniform(), r + rng.uniform(0, 10)), v = 10 * rng.vector();
    const Flight flight(body, state_of_motion<double>(body, x, rng.rotation(), v, rng.vector()), g,
                        0);
    const Convex ball = Convex::ball(r);
    const auto meeting = collide::first_meeting(collide::Moving<Flight>{ball, flight},
                                                collide::HalfSpace{}, 0, 100, tolerance);
    REQUIRE(meeting.found);
    const double expected = collide::landing_time(x.z() - r, v.z(), g.z());
    // The step's end is where rounding leaves the ball: no more than the places' rounding off.
    CHECK(std::abs(meeting.t - expected) <= 1e-13 * (1 + expected));
    CHECK(meeting.queries <= 3);
    CHECK(meeting.points.size() == 1);
  }
}

TEST_CASE("first_meeting: bricks on floors and walls, as a fine look at all times sees it") {
  test::Random rng(1132);
  int found = 0, queries = 0;
  for (int i = 0; i < 200; ++i) {
    const Thrown thrown = any_brick(rng, Vec3(0, 0, 1.5 + rng.uniform()), 5 * rng.vector());
    const collide::HalfSpace wall{Vec3(0, 0, -1), (Vec3::UnitZ() + rng.vector(0.5)).normalized()};
    const auto meeting = collide::first_meeting(thrown.moving(), wall, 0, 0.8, tolerance);
    queries += meeting.queries;
    found += meeting.found;
    const auto gap = [&](double t) { return distance(thrown.shape, thrown.pose(t), wall).gap; };
    if (meeting.found) CHECK(std::abs(gap(meeting.t)) <= tolerance);
    if (meeting.found) CHECK(meeting.points.size() == 1);
    for (int k = 0; k < 300; ++k) CHECK(gap(meeting.t * k / 300) > 0);
  }
  CHECK(found > 80);
  CHECK(found < 195);
  CHECK(queries < 200 * 30);
}

TEST_CASE(
    "first_meeting: a plate that spins about the floor's normal lands as if it did not turn") {
  const Vec3 size(0.5, 0.5, 0.02);
  for (const double spin : {0., 10., 1000.}) {
    const Thrown plate(size, Vec3(0, 0, 1), Quat::Identity(), Vec3(1, 2, 0), Vec3(0, 0, spin));
    const auto meeting =
        collide::first_meeting(plate.moving(), collide::HalfSpace{}, 0, 10, tolerance);
    REQUIRE(meeting.found);
    CHECK(std::abs(meeting.t - collide::landing_time(1 - size.z() / 2, 0, g.z())) < 1e-6);
    CHECK(meeting.queries <= 4);
  }
}

TEST_CASE("first_meeting: two bricks in flight, as a fine look at all times sees it") {
  test::Random rng(1133);
  int found = 0, queries = 0;
  for (int i = 0; i < 200; ++i) {
    const Vec3 apart = 3 * rng.direction();
    const Thrown a = any_brick(rng, Vec3::Zero(), Vec3::Zero());
    const Thrown b = any_brick(rng, apart, -3 * apart + 1.5 * rng.vector());
    const auto meeting = collide::first_meeting(a.moving(), b.moving(), 0, 1, tolerance);
    queries += meeting.queries;
    found += meeting.found;
    const auto gap = [&](double t) { return distance(a.shape, a.pose(t), b.shape, b.pose(t)).gap; };
    if (meeting.found) CHECK(std::abs(gap(meeting.t)) <= tolerance);
    for (int k = 0; k < 200; ++k) CHECK(gap(meeting.t * k / 200) > 0);
    const auto swapped = collide::first_meeting(b.moving(), a.moving(), 0, 1, tolerance);
    CHECK(swapped.found == meeting.found);
    CHECK(std::abs(swapped.t - meeting.t) < 1e-8);
  }
  CHECK(found > 50);
  CHECK(found < 195);
  CHECK(queries < 200 * 60);
}

TEST_CASE("first_meeting: a plate of 1 mm stops what comes with 1e4 m/s") {
  test::Random rng(1134);
  const Thrown plate(Vec3(1, 1, 1e-3), Vec3::Zero(), Quat::Identity(), Vec3::Zero(), Vec3::Zero(),
                     Vec3::Zero());
  for (int i = 0; i < 50; ++i) {
    const Vec3 from = rng.vector(0.3) + Vec3(0, 0, 1000), to = rng.vector(0.3);
    const Thrown bullet({2e-3, 1e-3, 1e-3}, from, rng.rotation(),
                        1e4 * (Vec3(to.x(), to.y(), 0) - from).normalized(), 1e3 * rng.vector(),
                        Vec3::Zero());
    const auto meeting = collide::first_meeting(bullet.moving(), plate.moving(), 0, 1, tolerance);
    REQUIRE(meeting.found);
    CHECK(std::abs(meeting.distance.gap) <= tolerance);
    CHECK((meeting.distance.normal + Vec3::UnitZ()).norm() < 1e-6);
    CHECK(bullet.flight.at(meeting.t).x.z() > 0);
    CHECK(meeting.queries < 200);
  }
}

TEST_CASE("first_meeting: a rod that turns just past a wall, or just not") {
  // Its end passes the wall at the distance `clearance`.
  const auto meets = [](double clearance) {
    const Vec3 size(2, 1e-3, 1e-3);
    const Thrown rod(size, Vec3::Zero(), Quat::Identity(), Vec3::Zero(), Vec3(0, 0, 5),
                     Vec3::Zero());
    const double reach = std::hypot(1, 0.5e-3);
    return collide::first_meeting(rod.moving(),
                                  collide::HalfSpace{Vec3(0, -reach - clearance, 0), Vec3::UnitY()},
                                  0, 10, tolerance);
  };
  CHECK(!meets(1e-8).found);
  CHECK(meets(-1e-8).found);
  CHECK(meets(1e-8).queries < 2000);
}

TEST_CASE("first_meeting: what starts in touch meets if it comes together, not if it parts") {
  const Vec3 size(1, 1, 1);
  const auto start = [&](const Vec3& v, double until) {
    const Thrown brick(size, Vec3(0, 0, 0.5), Quat::Identity(), v, Vec3::Zero());
    return collide::first_meeting(brick.moving(), collide::HalfSpace{}, 0, until, tolerance);
  };
  const auto down = start(Vec3(1, 0, -1), 10);
  CHECK((down.found && down.t == 0));
  CHECK(down.points.size() == 4);
  CHECK(!start(Vec3(0, 0, 9.81), 1.99).found);
  const auto up = start(Vec3(0, 0, 9.81), 10);
  CHECK(up.found);
  CHECK(std::abs(up.t - 2) < 1e-9);
  // On the floor without any speed: it presses on it at once, and no search hangs.
  const auto resting = start(Vec3::Zero(), 10);
  CHECK(resting.found);
  CHECK(resting.t < 1e-9);
}

TEST_CASE("contact_points: a face on a face, an edge on a face, and edges along and across") {
  const Convex cube = Convex::box(Vec3(2, 2, 2)), plank = Convex::box(Vec3(6, 1, 1));
  const auto points = [&](const Convex& a, const collide::Pose& pa, const Convex& b,
                          const collide::Pose& pb) {
    return contact_points(a, pa, b, pb, distance(a, pa, b, pb), 1e-9);
  };
  const auto turned = [](double angle, const Vec3& axis) {
    return Mat3(Eigen::AngleAxisd(angle, axis));
  };
  const double quarter = std::acos(0.);
  const auto faces = points(cube, {}, plank, {Vec3(0.5, 0, 1.5), turned(0.3, Vec3::UnitZ())});
  CHECK(faces.size() == 4);
  for (const Vec3& p : faces) {
    CHECK(std::abs(p.z() - 1) < 8 * test::eps);
    CHECK(std::abs(std::abs(p.x()) - 1) < 1e-8);  // faces are taken by 1e-9 wider
  }
  const double half = std::sqrt(0.5);  // of a plank's diagonal
  const Mat3 on_edge = turned(quarter / 2, Vec3::UnitX());
  const auto edge = points(cube, {}, plank, {Vec3(0, 0.2, 1 + half), on_edge});
  CHECK(edge.size() >= 2);
  for (const Vec3& p : edge) CHECK(std::abs(p.y() - 0.2) < 1e-9);
  const auto along = points(plank, {Vec3::Zero(), on_edge}, plank, {Vec3(4, 0, 2 * half), on_edge});
  CHECK(along.size() >= 2);
  for (const Vec3& p : along) CHECK((p.x() > 1 - 1e-8 && p.x() < 3 + 1e-8));
  const auto across = points(plank, {Vec3::Zero(), on_edge}, plank,
                             {Vec3(0.3, 0, 2 * half), turned(quarter, Vec3::UnitZ()) * on_edge});
  REQUIRE(across.size() == 1);
  CHECK((across[0] - Vec3(0.3, 0, half)).norm() < 1e-9);
}

TEST_CASE("first_meeting: what comes from far away costs no more than what comes from near") {
  const auto queries = [](double height, const Vec3& omega) {
    const Thrown brick(Vec3(1, 1, 1), Vec3(0, 0, height), Quat::Identity(), Vec3::Zero(), omega, g);
    const auto meeting =
        collide::first_meeting(brick.moving(), collide::HalfSpace{}, 0, 1e6, tolerance);
    REQUIRE(meeting.found);
    CHECK(meeting.t > std::sqrt(2 * (height - 1) / g.norm()));
    return meeting.queries;
  };
  const Vec3 slow(1, 2, 1), fast(1e4, 2e4, 1e4);
  CHECK(queries(1e8, slow) <= queries(3, slow) + 5);
  CHECK(queries(1e8, fast) <= queries(3, fast) + 5);
}
