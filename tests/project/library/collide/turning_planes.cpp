#include "tumble/collide/turning_planes.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <utility>

#include "project/harness/inputs.hpp"
#include "tumble/collide/first_meeting.hpp"
#include "tumble/contact/flight.hpp"
#include "tumble/mass/solids/box.hpp"

using namespace tumble;
using collide::Convex;
using contact::Flight;

namespace {

/// A brick in flight.
struct FlyingBrick {
  Convex shape;
  Flight flight;

  FlyingBrick(const Vec3& size, const Vec3& x, const Quat& q, const Vec3& v, const Vec3& omega)
      : shape(Convex::box(size)),
        flight(body_of(size), state_of_motion<double>(body_of(size), x, q, v, omega),
               Vec3(0, 0, -9.81), 0) {}

  static RigidBody<> body_of(const Vec3& size) {
    return RigidBody<>(mass_properties(Box{size}, 1000));
  }
  collide::Moving<Flight> moving() const { return {shape, flight}; }
  collide::Pose pose(double t) const { return collide::pose_of(flight.at(t)); }
};

double gap(const FlyingBrick& a, const FlyingBrick& b, double t) {
  return distance(a.shape, a.pose(t), b.shape, b.pose(t)).gap;
}

/// Edges of 0.7 m and 0.5 m, across each other and `apart`, that slide and turn, and part slowly.
std::pair<FlyingBrick, FlyingBrick> crossing_edges(test::Random& rng, double apart,
                                                   double parting) {
  const auto on_edge = [](const Vec3& axis) {
    return Quat(Eigen::AngleAxisd(std::atan(1.0), axis));
  };
  const double half = std::sqrt(0.5);
  return {{Vec3(0.7, 0.01, 0.01), Vec3(0, 0, half * 0.01 + apart), on_edge(Vec3::UnitX()),
           Vec3(rng.uniform(-2, 2), rng.uniform(-2, 2), parting), Vec3(0, 0, rng.uniform(2, 9))},
          {Vec3(0.2, 0.5, 0.2), Vec3(rng.uniform(-0.3, 0.3), 0, -half * 0.2),
           on_edge(Vec3::UnitY()), Vec3::Zero(), Vec3(rng.uniform(3, 6), 0, rng.uniform(-5, 0))}};
}

FlyingBrick any_brick(test::Random& rng, const Vec3& x) {
  const Vec3 size(rng.uniform(0.02, 1), rng.uniform(0.02, 1), rng.uniform(0.02, 1));
  return {size, x, rng.rotation(), 3 * rng.vector(), 10 * rng.vector()};
}

/// How long planes that turn keep them apart.
double time_apart_turning(const FlyingBrick& a, const FlyingBrick& b, const Vec3& n, double most) {
  const collide::detail::TurningPlanes planes(a.moving(), a.flight.at(0), b.moving(),
                                              b.flight.at(0), n);
  return collide::detail::time_apart(planes, n, most);
}

}  // namespace

TEST_CASE("TurningPlanes: two bricks in flight stay apart as long as they say") {
  test::Random rng(4127);
  int said = 0;
  for (int i = 0; i < 2000; ++i) {
    FlyingBrick a = any_brick(rng, Vec3::Zero()), b = any_brick(rng, 2 * rng.direction());
    const auto found = distance(a.shape, a.pose(0), b.shape, b.pose(0));
    if (found.gap <= 0) continue;
    const double most = std::pow(10, rng.uniform(-3, 0));
    const double apart = time_apart_turning(a, b, found.normal, most);
    said += apart > 0;
    for (int k = 1; k <= 50; ++k) REQUIRE(gap(a, b, apart * k / 50) >= -1e-12);
  }
  CHECK(said > 1000);
}

TEST_CASE("TurningPlanes: edges that slide on each other and hardly part take few looks") {
  test::Random rng(4128);
  for (int i = 0; i < 20; ++i) {
    const auto [a, b] = crossing_edges(rng, 4e-10, std::pow(10, rng.uniform(-6, -3)));
    const auto meeting = collide::first_meeting(a.moving(), b.moving(), 0, 1e-3, 1e-10);
    CHECK(meeting.queries < 1000);
    for (int k = 1; k <= 200; ++k) CHECK(gap(a, b, meeting.t * k / 200) > 0);
  }
}
