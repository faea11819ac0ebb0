/// @file
/// 7.1 bounding_box: its laws, and what goes wrong.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "07_bounding_boxes/contract.hpp"
#include "07_bounding_boxes/inputs.hpp"
#include "judge/spec/spec.hpp"
#include "tumble/mass/oriented_box.hpp"

using namespace tumble::judge;
using tumble::Mat3, tumble::Vec3;

namespace student {
const Function<decltype(bounding_boxes::bounding_box)> bounding_box{TUMBLE_UNIT};
}

namespace {

Box reference(const Points& points) { return to_box(tumble::boxes::aligned_box(points)); }

/// A sum or a difference, and a half that is exact: 2 eps of a place on either side.
double rounding(const Points& points) { return 4 * eps * reach(points); }

Vec3 smallest(const Points& points) {
  return std::accumulate(points.begin(), points.end(), points.front(),
                         [](const Vec3& a, const Vec3& b) -> Vec3 { return a.cwiseMin(b); });
}

Vec3 largest(const Points& points) {
  return std::accumulate(points.begin(), points.end(), points.front(),
                         [](const Vec3& a, const Vec3& b) -> Vec3 { return a.cwiseMax(b); });
}

/// The box between two corners, as someone has found them.
Box between(const Vec3& low, const Vec3& high) {
  const Vec3 middle = 0.5 * (low + high), size = high - low;
  return {middle, Mat3::Identity(), size};
}

/// Of a search that begins above and below all numbers, and tries each coordinate by `look`.
template <class Look>
Box searched(const Points& points, const Look& look) {
  constexpr double far = std::numeric_limits<double>::max();
  Vec3 low = Vec3::Constant(far), high = -low;
  for (const Vec3& point : points)
    for (int k = 0; k < 3; ++k) look(point[k], low[k], high[k]);
  return between(low, high);
}

/// The answer after `change(box, points)`.
template <class Change>
auto changed(const Change& change) {
  return [change](const Points& points) {
    Box box = reference(points);
    change(box, points);
    return box;
  };
}

}  // namespace

TEST_SUITE(TUMBLE_UNIT) {
  TEST_CASE("any points, on either side of the origin or on one side of it") {
    for (const int n : {6, 2, 3, 10, 40}) {
      const double x = any_number(3, 5), y = any_number(3, 5), z = any_number(3, 5);
      const Vec3 corner(x, y, z);
      for (const Vec3& place : {corner, Vec3(-corner), Vec3(0, 0, 0), any_vector(5)}) {
        const Points points = any_points(n, 2, place);
        REQUIRE(student::bounding_box(points) == close_to(reference(points), rounding(points)));
      }
    }
  }

  TEST_CASE("the corners (1, 2, 3) and (5, 4, 9): the middle at (3, 3, 6), edges of 4, 2 and 6") {
    const Box expected{{3, 3, 6}, Mat3::Identity(), {4, 2, 6}};
    for (const Points& points : {Points{{1, 2, 3}, {5, 4, 9}}, Points{{5, 2, 9}, {1, 4, 3}},
                                 Points{{3, 4, 3}, {1, 3, 9}, {5, 2, 6}}})
      REQUIRE(student::bounding_box(points) == close_to(expected, rounding(points)));
  }

  TEST_CASE("all points are in the box, and on each of its six faces lies one") {
    for (int n = 0; n < 10; ++n) {
      const Points points = any_points(12, 2, any_vector(5));
      const auto box = student::bounding_box(points);
      // Centre and size may be off, and the places are subtracted here.
      REQUIRE(box == obeys("no point sticks out", sticks_out(box, points), 4 * rounding(points)));
      REQUIRE(box == obeys("no face stands off", loose_by(box, points), 4 * rounding(points)));
    }
  }

  TEST_CASE("many points on one side pull nothing, in any order: the box is the right one") {
    for (int n = 0; n < 5; ++n) {
      Points points = any_points(5, 3);
      const Box box = reference(points);
      for (int i = 0; i < 50; ++i) {
        const double x = any_number(0.5, 0.9), y = any_number(0.5, 0.9);
        points.push_back(box.centre + 0.5 * box.size.cwiseProduct(Vec3(x, y, -0.7)));
      }
      REQUIRE(student::bounding_box(points) == close_to(box, rounding(points)));
      std::reverse(points.begin(), points.end());
      REQUIRE(student::bounding_box(points) == close_to(box, rounding(points)));
    }
  }

  TEST_CASE("points moved, mirrored and turned: each time the smallest box along x, y and z") {
    for (int n = 0; n < 5; ++n) {
      const Points points = any_points(8);
      const Vec3 shift = any_vector(10);
      const Box box = reference(points);
      const Points there = mapped(points, Mat3::Identity(), shift);
      REQUIRE(student::bounding_box(there) ==
              close_to(Box{box.centre + shift, box.R, box.size}, 2 * rounding(there)));
      REQUIRE(student::bounding_box(mapped(points, -Mat3::Identity())) ==
              close_to(Box{-box.centre, box.R, box.size}, rounding(points)));
      const Points turned = mapped(points, any_rotation());
      REQUIRE(student::bounding_box(turned) == close_to(reference(turned), rounding(turned)));
    }
  }

  TEST_CASE("one point, equal points, points on a line and in a plane: edges of length zero") {
    const Vec3 place = any_vector(5);
    for (const Points& points : {Points{place}, Points{place, place, place}})
      REQUIRE(student::bounding_box(points) ==
              close_to(Box{place, Mat3::Identity(), Vec3::Zero()}, rounding(points)));
    for (const Vec3& flat : {Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0), Vec3(0, 0, 1),
                             Vec3(0, 1, 1), Vec3(1, 0, 1)}) {
      const Points points = mapped(any_points(7), flat.asDiagonal(), place);
      REQUIRE(student::bounding_box(points) == close_to(reference(points), rounding(points)));
    }
  }

  TEST_CASE("all coordinates negative, tiny and huge boxes, near the origin and far from it") {
    for (const double size : {1e-150, 1e-8, 1e8, 1e150}) {
      for (const double far : {0., -3., 1e6}) {
        const Points points = any_points(6, size, far * size * Vec3::Ones());
        REQUIRE(student::bounding_box(points) == close_to(reference(points), rounding(points)));
      }
    }
  }
}

const Misconceptions<decltype(bounding_boxes::bounding_box)> misconceptions{
    TUMBLE_UNIT,
    {{"half the size",
      "These are the distances from the middle to the faces. Return the full lengths of "
      "the edges.",
      "The box along the axes", changed([](Box& box, const Points&) { box.size /= 2; })},
     {"corner for the centre",
      "You have returned the corner with the smallest coordinates as the centre. The "
      "centre is halfway to the opposite corner.",
      "The box along the axes",
      changed([](Box& box, const Points& points) { box.centre = smallest(points); })},
     {"the two corners",
      "You have returned the corners with the smallest and with the largest "
      "coordinates. Return the point halfway between them, and how far they are apart.",
      "The box along the axes", changed([](Box& box, const Points& points) {
        box.centre = smallest(points);
        box.size = largest(points);
      })},
     {"mean of the points",
      "You have taken the mean of the points for the middle of the box. Where many "
      "points crowd they pull the mean, but not the box.",
      "The box along the axes",
      changed([](Box& box, const Points& points) { box.centre = mean(points); })},
     {"not halved",
      "You have taken the sum of the smallest and the largest coordinates for the "
      "middle. That is twice as far away from the origin: halve it.",
      "The box along the axes", changed([](Box& box, const Points&) { box.centre *= 2; })},
     {"middle as if the box began at the origin",
      "You have taken half of the size for the middle. That is right only for a box "
      "that has one corner in the origin.",
      "The box along the axes",
      changed([](Box& box, const Points&) { box.centre = box.size / 2; })},
     {"started at the origin",
      "You have counted the origin as one of the points: your search for the smallest "
      "and the largest begins with zero. Begin with a point that is there.",
      "The box along the axes",
      [](const Points& points) {
        return between(smallest(points).cwiseMin(Vec3::Zero()),
                       largest(points).cwiseMax(Vec3::Zero()));
      }},
     {"smallest positive double for the lowest",
      "Your search for the largest coordinates begins with "
      "numeric_limits<double>::min(). That is the smallest positive number, so negative "
      "coordinates never count.",
      "The box along the axes",
      [](const Points& points) {
        const Vec3 tiny = Vec3::Constant(std::numeric_limits<double>::min());
        return between(smallest(points), largest(points).cwiseMax(tiny));
      }},
     {"else if, smallest first",
      "You do not compare a coordinate with the largest if it is a new smallest one. If the first "
      "point "
      "has the largest, you lose it: write two ifs, and no else.",
      "The box along the axes",
      [](const Points& points) {
        return searched(points, [](double x, double& low, double& high) {
          if (x < low)
            low = x;
          else if (x > high)
            high = x;
        });
      }},
     {"else if, largest first",
      "You do not compare a coordinate with the smallest if it is a new largest one. If the first "
      "point has the smallest, you lose it: write two ifs, and no else.",
      "The box along the axes",
      [](const Points& points) {
        return searched(points, [](double x, double& low, double& high) {
          if (x > high)
            high = x;
          else if (x < low)
            low = x;
        });
      }},
     {"symmetric about the origin",
      "Your box reaches as far to either side of the origin: you have compared the "
      "absolute values of the coordinates.",
      "The box along the axes",
      [](const Points& points) {
        const Vec3 most = smallest(points).cwiseAbs().cwiseMax(largest(points).cwiseAbs());
        return between(-most, most);
      }},
     {"a cube",
      "All your three edges are as long as the longest. Each axis has its own smallest "
      "and largest coordinate.",
      "The box along the axes",
      changed([](Box& box, const Points&) { box.size = Vec3::Constant(box.size.maxCoeff()); })},
     {"last point left out",
      "You have left out the last of the points: check where your loop ends.",
      "The box along the axes",
      [](const Points& points) {
        const Points some(points.begin(), points.end() - (points.size() > 1 ? 1 : 0));
        return reference(some);
      }},
     {"first and last point",
      "You have put the box between the first and the last point. The others may stick "
      "out of it.",
      "The box along the axes",
      [](const Points& points) {
        return between(points.front().cwiseMin(points.back()),
                       points.front().cwiseMax(points.back()));
      }},
     {"no orientation",
      "Your R is not the identity. A box along the axes is not turned: the columns of R are x, y "
      "and z.",
      "A box turned and moved", changed([](Box& box, const Points&) { box.R = Mat3::Zero(); })}}};
