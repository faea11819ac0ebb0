/// @file
/// 6.1 inertia_of_points: its laws, and what goes wrong.
#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include "06_point_sampling/contract.hpp"
#include "06_point_sampling/inputs.hpp"
#include "judge/spec/spec.hpp"
#include "tumble/mass/parallel_axis.hpp"
#include "tumble/mass/points.hpp"

using namespace tumble::judge;
using momentum::PointMass;
using tumble::Mat3, tumble::Vec3;

namespace student {
const Function<decltype(point_sampling::inertia_of_points)> inertia_of_points{TUMBLE_UNIT};
}

namespace {

using Points = std::vector<PointMass>;

const Vec3 origin = Vec3::Zero();

Mat3 reference(const Points& points, const Vec3& about) {
  Mat3 sum = Mat3::Zero();
  for (const auto& [mass, position] : points) sum += tumble::point_inertia(mass, position - about);
  return sum;
}

/// Σ m |r|²
double size_of(const Points& points, const Vec3& about) {
  double sum = 0;
  for (const auto& [mass, position] : points) sum += mass * (position - about).squaredNorm();
  return sum;
}

/// A difference, a square, another one, their sum and a product: 6 eps of m |r|² a number; and one
/// eps for each point added. Both sides together.
double rounding(const Points& points, const Vec3& about) {
  return (16 + 2 * static_cast<double>(points.size())) * eps * size_of(points, about);
}

/// The same for someone who has gone by way of the centre of mass or of the origin: allowed as long
/// as all are near it. Three such tensors are added then.
double rounding_near_origin(const Points& points, const Vec3& about) {
  return 3 * (rounding(points, origin) + rounding({{mass_of(points), about}}, origin));
}

Vec3 centre(const Points& points) {
  std::vector<tumble::PointMass> list;
  for (const auto& [mass, position] : points) list.push_back({mass, position});
  return tumble::centre_of_mass(list);
}

/// The sum over the points of what `term` makes of a mass and of the arrow r to it.
template <class Term>
Mat3 sum_of(const Points& points, const Vec3& about, const Term& term) {
  Mat3 sum = Mat3::Zero();
  for (const auto& [mass, position] : points) sum += term(mass, Vec3(position - about));
  return sum;
}

Mat3 diagonal_of(const Mat3& I) { return I.diagonal().asDiagonal(); }

}  // namespace

TEST_SUITE(TUMBLE_UNIT) {
  TEST_CASE("any masses at any places, about any point") {
    for (const int n : {4, 1, 2, 3, 10, 30}) {
      const Points points = any_points(n);
      const Vec3 about = any_vector(3);
      REQUIRE(student::inertia_of_points(points, about) ==
              close_to(reference(points, about), rounding_near_origin(points, about)));
    }
  }

  TEST_CASE("2 kg at 3 m on an axis: 18 kg m² about the two other axes, nothing about its own") {
    for (int k = 0; k < 3; ++k) {
      const Points points = {{2, 3 * Vec3::Unit(k)}};
      Vec3 moments = Vec3::Constant(18);
      moments[k] = 0;
      const Mat3 expected = moments.asDiagonal();
      REQUIRE(student::inertia_of_points(points, origin) ==
              close_to(expected, rounding(points, origin)));
    }
  }

  TEST_CASE("the products carry the minus sign: 1 kg at (1, 2, 3) m") {
    const Points points = {{1, Vec3(1, 2, 3)}};
    Mat3 expected;
    expected << 13, -2, -3,  //
        -2, 10, -6,          //
        -3, -6, 5;
    REQUIRE(student::inertia_of_points(points, origin) ==
            close_to(expected, rounding(points, origin)));
  }

  TEST_CASE("about any axis: mass times the square of the distance from that axis, summed up") {
    for (int n = 0; n < 10; ++n) {
      const Points points = any_points(5);
      const Vec3 about = any_vector(3), u = any_direction();
      double moment = 0;
      for (const auto& [mass, position] : points)
        moment += mass * u.cross(position - about).squaredNorm();
      const auto I = student::inertia_of_points(points, about);
      // Nine numbers, weighted by products of two components of u: at most 3 times the error.
      REQUIRE(I == obeys("uᵀ I u = Σ m d²", std::abs(u.dot(I.value() * u) - moment),
                         4 * rounding_near_origin(points, about)));
    }
  }

  TEST_CASE("L = I ω is what the points' own momenta add up to, when all turn about the point") {
    for (int n = 0; n < 10; ++n) {
      const Points points = any_points(5);
      const Vec3 about = any_vector(3), omega = any_vector(4);
      Vec3 L = Vec3::Zero();
      for (const auto& [mass, position] : points) {
        const Vec3 r = position - about;
        L += mass * r.cross(omega.cross(r));
      }
      const auto I = student::inertia_of_points(points, about);
      REQUIRE(I == obeys("I ω = Σ m r × (ω × r)", (I.value() * omega - L).norm(),
                         4 * rounding_near_origin(points, about) * omega.norm()));
    }
  }

  TEST_CASE("points and pivot moved and turned together: the tensor turns, the move is not felt") {
    for (int n = 0; n < 10; ++n) {
      const Points points = any_points(4);
      const Mat3 R = any_rotation();
      const Vec3 about = any_vector(3), shift = any_vector(5);
      Points moved = points;
      for (PointMass& point : moved) point.position = R * point.position + shift;
      const Vec3 pivot = R * about + shift;
      const auto before = student::inertia_of_points(points, about);
      const Mat3 expected = R * before.value() * R.transpose();
      // At most 3 times what the first answer may be off, and as much as that for the second.
      REQUIRE(student::inertia_of_points(moved, pivot) ==
              close_to(expected, 4 * (rounding_near_origin(points, about) +
                                      rounding_near_origin(moved, pivot))));
    }
  }

  TEST_CASE("the tensors of two groups add up, in any order; a point without mass adds nothing") {
    for (int n = 0; n < 5; ++n) {
      const Points group = any_points(3), rest = any_points(4);
      const Vec3 about = any_vector(3);
      Points all = group;
      all.insert(all.end(), rest.begin(), rest.end());
      all.insert(all.begin() + n, PointMass{0, any_vector(3)});
      std::reverse(all.begin(), all.end());
      const auto a = student::inertia_of_points(group, about);
      const auto b = student::inertia_of_points(rest, about);
      const Mat3 sum = a.value() + b.value();
      REQUIRE(student::inertia_of_points(all, about) ==
              close_to(sum, 2 * rounding_near_origin(all, about)));
    }
  }

  TEST_CASE("far from the origin no digit is lost") {
    for (const double far : {1e4, 1e6, 1e8}) {
      for (int n = 0; n < 3; ++n) {
        Points points = any_points(5);
        const Vec3 place = far * any_direction(), about = place + any_vector(2);
        for (PointMass& point : points) point.position += place;
        REQUIRE(student::inertia_of_points(points, about) ==
                close_to(reference(points, about), rounding(points, about)));
      }
    }
  }

  TEST_CASE("no points, points in the pivot, tiny and huge masses and distances") {
    const Vec3 about = any_vector(3);
    REQUIRE(student::inertia_of_points({}, about) == close_to(Mat3(Mat3::Zero()), 0));
    REQUIRE(student::inertia_of_points({{2, about}}, about) == close_to(Mat3(Mat3::Zero()), 0));
    for (const double size : {1e-50, 1e-8, 1e8, 1e50}) {
      for (const double mass : {1e-98, 1e-8, 1e8, 1e98}) {
        Points points = any_points(4, size);
        for (PointMass& point : points) point.mass *= mass;
        const Vec3 near = any_vector(size);
        REQUIRE(student::inertia_of_points(points, near) ==
                close_to(reference(points, near), rounding_near_origin(points, near)));
      }
    }
  }
}

const Misconceptions<decltype(point_sampling::inertia_of_points)> misconceptions{
    TUMBLE_UNIT,
    {{"products with a plus",
      "The numbers off the diagonal have the wrong sign. Try a single point: with ω along x, what "
      "does L = m r × (ω × r) have along y?",
      "The discrete inertia sum",
      [](const Points& points, const Vec3& about) -> Mat3 {
        const Mat3 I = reference(points, about);
        return 2 * diagonal_of(I) - I;
      }},
     {"along the axis instead of across",
      "On your diagonal is the square of each axis's own coordinate. How hard a "
      "turn about x is depends on how far the mass is from the axis x: take the two "
      "other coordinates.",
      "The discrete inertia sum",
      [](const Points& points, const Vec3& about) {
        return sum_of(points, about, [](double mass, const Vec3& r) -> Mat3 {
          return mass * (2 * diagonal_of(outer(r)) - outer(r));
        });
      }},
     {"only r rᵀ",
      "This is the sum of m r rᵀ: how the mass is spread along the axes. You want how "
      "far it is from them, and this sum is only the part that you take away.",
      "The discrete inertia sum",
      [](const Points& points, const Vec3& about) {
        return sum_of(points, about,
                      [](double mass, const Vec3& r) -> Mat3 { return mass * outer(r); });
      }},
     {"r rᵀ added",
      "You have added r rᵀ. Subtract it: a point on the x axis does not resist a turn about x.",
      "The discrete inertia sum",
      [](const Points& points, const Vec3& about) {
        return sum_of(points, about, [](double mass, const Vec3& r) -> Mat3 {
          return mass * (r.squaredNorm() * Mat3::Identity() + outer(r));
        });
      }},
     {"distance from the point, not from the axis",
      "Each number on your diagonal holds the square of the whole distance, and there "
      "are no products. A point on the axis x does not resist a turn about x, however "
      "far away it is.",
      "The discrete inertia sum",
      [](const Points& points, const Vec3& about) {
        return sum_of(points, about, [](double mass, const Vec3& r) -> Mat3 {
          return mass * r.squaredNorm() * Mat3::Identity();
        });
      }},
     {"whole distance on the diagonal",
      "Your products are right, but each number on the diagonal holds the square of the "
      "whole distance. The coordinate along the axis itself does not count.",
      "The discrete inertia sum",
      [](const Points& points, const Vec3& about) {
        return sum_of(points, about, [](double mass, const Vec3& r) -> Mat3 {
          return mass * (r.squaredNorm() * Mat3::Identity() - outer(r) + diagonal_of(outer(r)));
        });
      }},
     {"products forgotten",
      "Your diagonal is right, but the numbers off it are zero. They vanish only if these axes "
      "are principal axes.",
      "The discrete inertia sum",
      [](const Points& points, const Vec3& about) {
        return diagonal_of(reference(points, about));
      }},
     {"one half left empty",
      "You have filled only the diagonal and what is above it. The tensor is symmetric: "
      "each product appears in two places.",
      "The discrete inertia sum",
      [](const Points& points, const Vec3& about) -> Mat3 {
        return reference(points, about).triangularView<Eigen::Upper>();
      }},
     {"masses ignored",
      "You have counted each point as if it had 1 kg. What is heavy is hard to turn: "
      "multiply each term by its mass.",
      "The discrete inertia sum",
      [](Points points, const Vec3& about) {
        for (PointMass& point : points) point.mass = 1;
        return reference(points, about);
      }},
     {"distance not squared",
      "Your distances are not squared: look at the unit, kg m². A point twice as far "
      "away is four times as hard to turn.",
      "The discrete inertia sum",
      [](const Points& points, const Vec3& about) {
        return sum_of(points, about, [](double mass, const Vec3& r) -> Mat3 {
          const double length = r.norm();
          return length > 0 ? Mat3(mass / length * tumble::point_inertia(1, r)) : Mat3::Zero();
        });
      }},
     {"distance not squared on the diagonal",
      "Your products are right. On the diagonal you have |r| where |r|² belongs: look at the unit, "
      "kg "
      "m².",
      "The discrete inertia sum",
      [](const Points& points, const Vec3& about) {
        return sum_of(points, about, [](double mass, const Vec3& r) -> Mat3 {
          return mass * (r.norm() * Mat3::Identity() - outer(r));
        });
      }},
     {"divided by the mass",
      "You have divided the sum by the total mass, as for a centre of mass. An inertia "
      "is not a mean: twice as much mass is twice as hard to turn.",
      "The discrete inertia sum",
      [](const Points& points, const Vec3& about) -> Mat3 {
        return points.empty() ? Mat3::Zero() : Mat3(reference(points, about) / mass_of(points));
      }},
     {"about the world's origin",
      "Your arrows begin at the origin of the world. Let them begin at the point "
      "`about`.",
      "Parallel axes", [](const Points& points, const Vec3&) { return reference(points, origin); }},
     {"about the centre of mass",
      "Your arrows begin at the centre of mass. Here you are given a point, and it need "
      "not be the centre.",
      "Parallel axes",
      [](const Points& points, const Vec3&) -> Mat3 {
        return points.empty() ? Mat3::Zero() : reference(points, centre(points));
      }},
     {"all mass in the centre",
      "This is the inertia of all the mass gathered in the centre of mass. The points around it "
      "resist too, even if the body turns about that very centre.",
      "Parallel axes",
      [](const Points& points, const Vec3& about) -> Mat3 {
        if (points.empty()) return Mat3::Zero();
        return tumble::point_inertia(mass_of(points), centre(points) - about);
      }},
     {"only the last point", "Each point has replaced the one before it: add them up.",
      "The discrete inertia sum",
      [](const Points& points, const Vec3& about) -> Mat3 {
        return points.empty() ? Mat3::Zero() : reference({points.back()}, about);
      }},
     {"digits lost far from the origin",
      "Near the origin this is right. Far from it you subtract huge numbers that were "
      "rounded before. Take the difference of the places first, and square afterwards.",
      "Far from the origin", [](const Points& points, const Vec3& about) -> Mat3 {
        Vec3 moment = Vec3::Zero();
        for (const auto& [mass, position] : points) moment += mass * position;
        const double mixed = 2 * about.dot(moment);
        const Mat3 cross =
            mixed * Mat3::Identity() - about * moment.transpose() - moment * about.transpose();
        return reference(points, origin) - cross + tumble::point_inertia(mass_of(points), about);
      }}}};
