/// @file
/// 5.1 centre_of_mass: its laws, and what goes wrong.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "05_momentum/contract.hpp"
#include "judge/spec/spec.hpp"
#include "tumble/mass/points.hpp"

using namespace tumble::judge;
using momentum::PointMass;
using tumble::Mat3, tumble::Vec3;

namespace student {
const Function<decltype(momentum::centre_of_mass)> centre_of_mass{TUMBLE_UNIT};
}

namespace {

using Points = std::vector<PointMass>;

Vec3 reference(const Points& points) {
  std::vector<tumble::PointMass> list;
  for (const PointMass& point : points) list.push_back({point.mass, point.position});
  return tumble::centre_of_mass(list);
}

/// Two sums of n terms and a division round by 2n eps of the farthest place; a mean that is
/// corrected point by point by up to 8n; the reference by a few.
double rounding(const Points& points) {
  double farthest = 0;
  for (const PointMass& point : points)
    farthest = std::fmax(farthest, point.position.lpNorm<Eigen::Infinity>());
  return 8 * (static_cast<double>(points.size()) + 1) * eps * farthest;
}

Points any_points(int n, double size = 3) {
  Points points;
  for (int i = 0; i < n; ++i) points.push_back({any_number(0.1, 5), any_vector(size)});
  return points;
}

/// Of all points, what `each(point)` gives.
template <class T, class Each>
T sum(const Points& points, T zero, Each each) {
  return std::accumulate(
      points.begin(), points.end(), std::move(zero),
      [&](const T& so_far, const PointMass& p) -> T { return so_far + each(p); });
}

double mass_of(const Points& points) {
  return sum(points, 0., [](const PointMass& p) { return p.mass; });
}

/// Σ m x
Vec3 moment_of(const Points& points) {
  return sum(points, Vec3(0, 0, 0), [](const PointMass& p) -> Vec3 { return p.mass * p.position; });
}

/// Σ x
Vec3 sum_of_places(const Points& points) {
  return sum(points, Vec3(0, 0, 0), [](const PointMass& p) { return p.position; });
}

}  // namespace

TEST_SUITE(TUMBLE_UNIT) {
  TEST_CASE("any masses at any places: each place counts as much as its mass") {
    for (const int n : {5, 2, 3, 10, 30}) {
      const Points points = any_points(n);
      REQUIRE(student::centre_of_mass(points) == close_to(reference(points), rounding(points)));
    }
  }

  TEST_CASE("one mass has its centre where it is, two equal ones halfway, 3 to 1 at a quarter") {
    const Vec3 a = any_vector(3), b = any_vector(3);
    const auto demand = [](const Points& points, const Vec3& centre) {
      REQUIRE(student::centre_of_mass(points) == close_to(centre, rounding(points)));
    };
    demand({{2.5, a}}, a);
    demand({{0.7, a}, {0.7, b}}, (a + b) / 2);
    demand({{3, a}, {1, b}}, a + (b - a) / 4);
  }

  TEST_CASE("seen from the centre, mass times place adds up to zero") {
    for (int n = 0; n < 10; ++n) {
      const Points points = any_points(6);
      const auto centre = student::centre_of_mass(points);
      Vec3 moment = Vec3::Zero();
      for (const auto& [mass, position] : points) moment += mass * (position - centre.value());
      // Three numbers that are each off by `rounding`, and the sum that is made here.
      REQUIRE(centre ==
              obeys("Σ m (x − c) = 0", moment.norm(), 4 * mass_of(points) * rounding(points)));
    }
  }

  TEST_CASE("moved and turned all together, the points take their centre along") {
    for (int n = 0; n < 10; ++n) {
      const Points points = any_points(4);
      const Mat3 R = any_rotation();
      const Vec3 shift = any_vector(10);
      Points moved = points;
      for (PointMass& point : moved) point.position = R * point.position + shift;
      const auto before = student::centre_of_mass(points);
      const Vec3 expected = R * before.value() + shift;
      // √3 of what the first answer may be off, and as much as that for the second.
      REQUIRE(student::centre_of_mass(moved) ==
              close_to(expected, 2 * rounding(points) + 2 * rounding(moved)));
    }
  }

  TEST_CASE("a group of masses counts like all its mass in its own centre") {
    for (int n = 0; n < 10; ++n) {
      const Points group = any_points(5), rest = any_points(3);
      Points all = group;
      all.insert(all.end(), rest.begin(), rest.end());
      const auto centre = student::centre_of_mass(group);
      Points grouped = rest;
      grouped.push_back({mass_of(group), centre.value()});
      REQUIRE(student::centre_of_mass(grouped) == close_to(reference(all), 2 * rounding(all)));
    }
  }

  TEST_CASE("with a point without mass, and in another order: still the right centre") {
    for (int n = 0; n < 5; ++n) {
      Points points = any_points(4);
      const Vec3 centre = reference(points);
      points.insert(points.begin() + n % 5, PointMass{0, any_vector(3)});
      REQUIRE(student::centre_of_mass(points) == close_to(centre, rounding(points)));
      std::reverse(points.begin(), points.end());
      REQUIRE(student::centre_of_mass(points) == close_to(centre, rounding(points)));
    }
  }

  TEST_CASE("tiny and huge masses, light ones among heavy ones, places near the origin and far") {
    for (const double size : {0., 1e-100, 1e-8, 1e8, 1e100}) {
      for (const double mass : {1e-98, 1e-8, 1e8, 1e98}) {
        Points points = any_points(4, size);
        for (PointMass& point : points) point.mass *= mass;
        REQUIRE(student::centre_of_mass(points) == close_to(reference(points), rounding(points)));
        points[0].mass = 1;  // next to it the others are dust, or it is dust next to them
        REQUIRE(student::centre_of_mass(points) == close_to(reference(points), rounding(points)));
      }
    }
  }

  TEST_CASE("a thousand points far away from the origin") {
    Points points = any_points(1000);
    const Vec3 far = 1e6 * any_direction();
    for (PointMass& point : points) point.position += far;
    REQUIRE(student::centre_of_mass(points) == close_to(reference(points), rounding(points)));
  }
}

const Misconceptions<decltype(momentum::centre_of_mass)> misconceptions{
    TUMBLE_UNIT,
    {{"masses ignored",
      "You have taken the middle of the places, each counted once. A heavy point pulls the "
      "centre towards itself: count a place as much as its mass.",
      "Centre of mass",
      [](const Points& points) -> Vec3 {
        return sum_of_places(points) / static_cast<double>(points.size());
      }},
     {"divided by the number of points",
      "You have divided the sum of mass times place by the number of points. The result is not "
      "even a length: look at its unit.",
      "Centre of mass",
      [](const Points& points) -> Vec3 {
        return moment_of(points) / static_cast<double>(points.size());
      }},
     {"not divided",
      "This is the sum of mass times place, in kg m. If you double all masses, the centre must "
      "not move.",
      "Centre of mass", [](const Points& points) -> Vec3 { return moment_of(points); }},
     {"masses counted twice",
      "You have multiplied by the mass twice, so that heavy points pull harder than they should. "
      "Look at the unit of your result.",
      "Centre of mass",
      [](const Points& points) -> Vec3 {
        return sum(points, Vec3(0, 0, 0),
                   [](const PointMass& p) -> Vec3 { return p.mass * p.mass * p.position; }) /
               mass_of(points);
      }},
     {"divided by the mass twice",
      "You have divided by the total mass twice. Look at the unit of your result.",
      "Centre of mass",
      [](const Points& points) -> Vec3 { return reference(points) / mass_of(points); }},
     {"weighted by the square of the mass",
      "You have counted each place as much as the square of its mass, so that heavy points pull "
      "harder than they should.",
      "Centre of mass",
      [](Points points) {
        for (PointMass& point : points) point.mass *= point.mass;
        return reference(points);
      }},
     {"middle of the bounding box",
      "You are halfway between the smallest and the largest coordinates. That point does not "
      "feel how many points there are on either side, nor how heavy they are.",
      "Centre of mass",
      [](const Points& points) -> Vec3 {
        Vec3 low = points.front().position, high = low;
        for (const PointMass& point : points) {
          low = low.cwiseMin(point.position);
          high = high.cwiseMax(point.position);
        }
        return (low + high) / 2;
      }},
     {"last point left out",
      "You have left out the last of the points: check where your loop ends.", "Centre of mass",
      [](const Points& points) -> Vec3 {
        const Points some(points.begin(), points.end() - 1);
        return moment_of(some) / mass_of(some);
      }},
     {"only the last point",
      "You return the place of the last point: each point has replaced the one before it. Add up "
      "the masses, and masses times places.",
      "Centre of mass", [](const Points& points) { return points.back().position; }},
     {"only the last moment",
      "You have divided the last point's mass times place by the mass of all points: each product "
      "has replaced the one before it. Add them up.",
      "Centre of mass",
      [](const Points& points) -> Vec3 {
        return points.back().mass * points.back().position / mass_of(points);
      }},
     {"only the last mass",
      "You have divided by the mass of the last point: each mass has replaced the one before it. "
      "Add them up.",
      "Centre of mass",
      [](const Points& points) -> Vec3 { return moment_of(points) / points.back().mass; }},
     {"first point left out",
      "You have left out the first of the points: check where your loop begins.", "Centre of mass",
      [](const Points& points) -> Vec3 {
        const Points some(points.begin() + 1, points.end());
        return moment_of(some) / mass_of(some);
      }},
     {"whole kilograms only",
      "Your total mass has lost its fractions, as happens in a sum whose type is int. In "
      "std::accumulate the type is that of the starting value.",
      "Centre of mass",
      [](const Points& points) -> Vec3 {
        double mass = 0;
        for (const PointMass& point : points) mass = std::trunc(mass + point.mass);
        return moment_of(points) / mass;
      }},
     {"measured from the first point",
      "You return the offset from the first point to the centre. The centre itself is a point, "
      "measured from the world's origin.",
      "Frames of reference",
      [](const Points& points) -> Vec3 { return reference(points) - points.front().position; }},
     {"halfway to each next point",
      "You have given the centre so far and the next point equal weight, one point after the "
      "other. What you have gathered so far is heavier than one point.",
      "Centre of mass", [](const Points& points) -> Vec3 {
        Vec3 centre = points.front().position;
        for (std::size_t i = 1; i < points.size(); ++i) centre = (centre + points[i].position) / 2;
        return centre;
      }}}};
