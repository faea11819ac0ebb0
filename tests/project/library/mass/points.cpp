#include "tumble/mass/points.hpp"

#include <doctest/doctest.h>

#include <vector>

#include "project/harness/inputs.hpp"
#include "project/harness/refusal.hpp"

using namespace tumble;
using test::eps;
using test::Random;

namespace {

using Points = std::vector<PointMass>;

Points random_points(Random& rng, int count) {
  Points points;
  for (int i = 0; i < count; ++i) points.push_back({rng.uniform(0.1, 2), rng.vector()});
  return points;
}

}  // namespace

TEST_CASE("mass_properties of points: a dumbbell: 1 kg and 3 kg, 4 m apart") {
  const Points dumbbell{{1, Vec3(0, 0, 0)}, {3, Vec3(4, 0, 0)}};
  const MassProperties body = mass_properties(dumbbell);
  CHECK(body.mass == 4);
  CHECK(body.centre == Vec3(3, 0, 0));
  // reduced mass 3/4 kg at 4 m
  CHECK(body.inertia == Vec3(0, 12, 12).asDiagonal().toDenseMatrix());
}

TEST_CASE("mass_properties of points: products have the minus sign") {
  const Points pair{{1, Vec3(1, 1, 0)}, {1, Vec3(-1, -1, 0)}};
  CHECK(mass_properties(pair).inertia(0, 1) == -2);
}

TEST_CASE(
    "mass_properties of points: each quadratic form is Σ m times the distance to the axis "
    "squared") {
  Random rng(71);
  for (int i = 0; i < 50; ++i) {
    const Points points = random_points(rng, 20);
    const MassProperties body = mass_properties(points);
    const Vec3 axis = rng.direction();
    double sum = 0;
    for (const PointMass& p : points)
      sum += p.mass * axis.cross(p.position - body.centre).squaredNorm();
    CHECK(std::abs(axis.dot(body.inertia * axis) - sum) <= 40 * eps * sum);
  }
}

TEST_CASE("mass_properties of points: far away they are the same body, whatever the first point") {
  Random rng(72);
  const Points near_origin = random_points(rng, 100);
  const MassProperties here = mass_properties(near_origin);
  for (const double distance : {1e3, 1e6, 1e8}) {
    Points there = near_origin;
    for (PointMass& p : there) p.position += Vec3(distance, -distance, distance);
    const MassProperties body = mass_properties(there);
    CAPTURE(distance);
    // Each position is rounded by up to eps · distance, at random: the sum over 100 moves less.
    CHECK((body.centre - here.centre - Vec3(distance, -distance, distance)).norm() <=
          2 * eps * distance);
    CHECK((body.inertia - here.inertia).norm() <=
          4 * (eps * distance + 10 * eps) * here.inertia.norm());
  }
}

TEST_CASE("centre_of_mass: of one point it is the point, to the bit") {
  const Points one{{0.1, Vec3(0.1, 0.2, 1e8)}};
  CHECK(centre_of_mass(one) == one[0].position);
  CHECK(mass_properties(one).inertia == Mat3::Zero());
}

TEST_CASE("mass_properties of points: refuses what has no centre, and says which point") {
  CHECK_REFUSED(mass_properties(Points{}), "no point masses");
  CHECK_REFUSED(mass_properties(Points{{0, Vec3(1, 2, 3)}}), "are 0 kg");
  for (const double bad : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    const Points mass{{1, Vec3(0, 0, 0)}, {bad, Vec3(1, 0, 0)}};
    CAPTURE(bad);
    CHECK_REFUSED(mass_properties(mass), "point mass 1");
  }
  const Points place{{1, Vec3(0, std::nan(""), 0)}};
  CHECK_REFUSED(centre_of_mass(place), "point mass 0");
}
