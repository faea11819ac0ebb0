/// @file
/// 7.3 fit_oriented_box: its laws, and what goes wrong.
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "07_bounding_boxes/contract.hpp"
#include "07_bounding_boxes/inputs.hpp"
#include "judge/spec/spec.hpp"
#include "tumble/mass/bounding_box.hpp"
#include "tumble/mass/principal_axes.hpp"
#include "tumble/rotation/orthonormality.hpp"

using namespace tumble::judge;
using tumble::Mat3, tumble::Vec3;

namespace student {
const Function<decltype(bounding_boxes::fit_oriented_box)> fit_oriented_box{TUMBLE_UNIT};
}

namespace {

// ── Boxes, whatever their edges are called ──

/// Which edge comes first and which way it points is left open: R diag(size) Rᵀ does not know.
struct SameBox {
  Vec3 centre;
  Mat3 extent;
};

Value nameless(const Value& value) {
  const Box box = from_value<Box>(value);
  return to_value(SameBox{box.centre, box.R * box.size.asDiagonal() * box.R.transpose()});
}

double difference_of_boxes(const Value& a, const Value& b) {
  return largest_difference(nameless(a), nameless(b));
}

/// The box with its edges in the order, and in the directions, that come nearest to the answer's.
Value named_alike(const Value& demanded, const Value& answer) {
  const Box box = from_value<Box>(demanded);
  const Mat3 alike = from_value<Box>(answer).R.transpose() * box.R;
  Eigen::Vector3i order(0, 1, 2), best = order;
  double most = 0;
  do {
    const double sum =
        std::abs(alike(0, order[0])) + std::abs(alike(1, order[1])) + std::abs(alike(2, order[2]));
    if (sum > most) most = sum, best = order;
  } while (std::next_permutation(order.begin(), order.end()));
  Box named = box;
  for (int k = 0; k < 3; ++k) {
    named.R.col(k) = std::copysign(1., alike(k, best[k])) * box.R.col(best[k]);
    named.size[k] = box.size[best[k]];
  }
  return to_value(named);
}

CloseTo same_box(const Box& box, double tolerance) {
  return {to_value(box), tolerance, difference_of_boxes, named_alike};
}

// ── The right answer ──

Mat3 scatter(const Points& points, const Vec3& about) {
  Mat3 S = Mat3::Zero();
  for (const Vec3& p : points) S += (p - about) * (p - about).transpose();
  return S;
}

Box reference(const Points& points) { return to_box(tumble::boxes::principal_box(points)); }

/// The smallest box with these directions.
Box around(const Points& points, const Mat3& R) {
  return to_box(tumble::boxes::box_around(points, R));
}

Mat3 axes_of(const Mat3& S) { return tumble::principal_axes(S).R; }

/// How far two of the axes may be turned by an error of the scatter matrix of this size: it is
/// divided by how much they differ in scatter. Where the points are on a line only one axis counts;
/// what they scatter across it is no more than that error.
double turned_by(double error, const Points& points) {
  const Vec3 spread = tumble::principal_axes(scatter(points, mean(points))).moments;
  const double gap =
      spread.y() <= error ? spread.z() : std::min(spread.y() - spread.x(), spread.z() - spread.y());
  return gap > 0 ? error / gap : 0;
}

/// What rounding may do to a number of the box. The coordinates along its axes are off by some eps
/// of the places; the sums of n terms by n eps, the turns of the matrix by some 100, and that turns
/// the box.
double rounding(const Points& points) {
  const double n = static_cast<double>(points.size()), size = reference(points).size.norm();
  const double mean_off = (n + 4) * eps * reach(points);
  const double scatter_off =
      (128 + 4 * n) * eps * scatter(points, mean(points)).norm() + n * mean_off * mean_off;
  return (32 + n) * eps * reach(points) + 4 * size * turned_by(scatter_off, points);
}

/// The same for someone who sums about the origin: allowed as long as the points are near it.
double rounding_near_origin(const Points& points) {
  const double n = static_cast<double>(points.size()), size = reference(points).size.norm();
  const double scatter_off = (128 + 8 * n) * eps * scatter(points, Vec3::Zero()).norm();
  return rounding(points) + 4 * size * turned_by(scatter_off, points);
}

/// Whether the points scatter by clearly different amounts along the axes.
bool has_clear_axes(const Points& points) {
  const Vec3 spread = tumble::principal_axes(scatter(points, mean(points))).moments;
  return spread.y() > 1.3 * spread.x() && spread.z() > 1.3 * spread.y();
}

/// A slanted cloud with clear axes.
Points any_cloud(int n, double size = 2) {
  for (;;) {
    const Mat3 shape = any_rotation() * Vec3(1, 0.6, 0.3).asDiagonal();
    const Points cloud = any_points(n, size);
    const Points points = mapped(cloud, shape, any_vector(1.5 * size));
    if (has_clear_axes(points)) return points;
  }
}

/// The same with many more points near one of them.
Points any_crowd(int n) {
  for (;;) {
    Points points = any_cloud(n);
    const Points crowd = mapped(points, 0.1 * Mat3::Identity(), 0.9 * points.front());
    for (int k = 0; k < 3; ++k) points.insert(points.end(), crowd.begin(), crowd.end());
    if (has_clear_axes(points)) return points;
  }
}

Points corners(const Box& box) {
  Points points;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 signs(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
    points.push_back(box.centre + box.R * box.size.cwiseProduct(signs) / 2);
  }
  return points;
}

// ── Wrong answers ──

/// The box with the axes of another matrix.
template <class Matrix>
auto along(const Matrix& matrix) {
  return [matrix](const Points& points) {
    return around(points, axes_of(matrix(points, mean(points))));
  };
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
  TEST_CASE("any cloud of points: the box along the axes of its scatter") {
    for (const int n : {8, 5, 4, 12, 40}) {
      for (int k = 0; k < 3; ++k) {
        const Points points = any_cloud(n);
        REQUIRE(student::fit_oriented_box(points) ==
                same_box(reference(points), rounding_near_origin(points)));
      }
    }
  }

  TEST_CASE("the corners of a box give back the box, however it is turned") {
    for (int n = 0; n < 10; ++n) {
      const double a = any_number(0.5, 1), b = any_number(1.2, 1.5) * a;
      const Box box{any_vector(3), any_rotation(), {a, b, any_number(1.2, 1.5) * b}};
      const Points points = corners(box);
      // The corners are rounded, which turns the box like the errors of a sum.
      REQUIRE(student::fit_oriented_box(points) == same_box(box, 2 * rounding_near_origin(points)));
    }
  }

  TEST_CASE("no point sticks out, and no face stands off") {
    for (int n = 0; n < 10; ++n) {
      const Points points = any_cloud(12);
      const auto box = student::fit_oriented_box(points);
      REQUIRE(box == obeys("no point sticks out", sticks_out(box, points), 2 * rounding(points)));
      REQUIRE(box == obeys("no face stands off", loose_by(box, points), 2 * rounding(points)));
    }
  }

  TEST_CASE("points turned and moved take the right box along") {
    for (int n = 0; n < 10; ++n) {
      const Points points = any_cloud(10);
      const Mat3 turn = any_rotation();
      const Vec3 shift = any_vector(4);
      const Box box = reference(points);
      const Points there = mapped(points, turn, shift);
      REQUIRE(student::fit_oriented_box(there) ==
              same_box({turn * box.centre + shift, turn * box.R, box.size},
                       2 * rounding_near_origin(there)));
    }
  }

  TEST_CASE(
      "where points crowd they turn the box, but its centre stays halfway between its faces") {
    for (int n = 0; n < 5; ++n) {
      const Points points = any_crowd(8);
      REQUIRE(student::fit_oriented_box(points) ==
              same_box(reference(points), rounding_near_origin(points)));
    }
  }

  TEST_CASE("points in a plane, on a line, two points and one") {
    for (const Vec3& flat : {Vec3(1, 0.5, 0), Vec3(1, 0, 0)}) {
      const Mat3 R = any_rotation();
      const Points points =
          mapped(corners({Vec3::Zero(), Mat3::Identity(), flat}), R, any_vector(3));
      REQUIRE(student::fit_oriented_box(points) ==
              same_box(reference(points), rounding_near_origin(points)));
    }
    const Points two{any_vector(3), any_vector(3)};
    REQUIRE(student::fit_oriented_box(two) == same_box(reference(two), rounding_near_origin(two)));
    for (const Points& one : {Points{two[0]}, Points{Vec3::Zero()}, Points{two[0], two[0]}})
      REQUIRE(student::fit_oriented_box(one) ==
              same_box({one[0], Mat3::Identity(), Vec3::Zero()}, rounding_near_origin(one)));
  }

  TEST_CASE("tiny and huge boxes; far from the origin only the rounding of the places counts") {
    for (const double size : {1e-50, 1e-8, 1e8, 1e50}) {
      const Points points = any_cloud(8, size);
      REQUIRE(student::fit_oriented_box(points) ==
              same_box(reference(points), rounding_near_origin(points)));
    }
    for (const double far : {1e3, 1e5, 1e7}) {
      const Points cloud = any_cloud(8);
      const Points points = mapped(cloud, Mat3::Identity(), far * any_direction());
      REQUIRE(student::fit_oriented_box(points) == same_box(reference(points), rounding(points)));
    }
  }

  TEST_CASE("R is a rotation, and right-handed; no edge is negative") {
    for (int n = 0; n < 20; ++n) {
      const auto box = student::fit_oriented_box(any_cloud(10));
      // 24 turns, each of which rounds by 6 eps a number, and the products made here.
      const double bound = 512 * eps;
      REQUIRE(box == obeys("RᵀR = 1", tumble::rotation::orthonormality_error(box->R), bound));
      REQUIRE(box == obeys("det R = 1", std::abs(box->R.determinant() - 1), bound));
      REQUIRE(box == obeys("size ≥ 0", -box->size.minCoeff<Eigen::PropagateNaN>(), 0));
    }
  }
}

const Misconceptions<decltype(bounding_boxes::fit_oriented_box)> misconceptions{
    TUMBLE_UNIT,
    {{"along the world's axes", "Your edges lie along x, y and z. Let the box lie along the body.",
      "A box that lies along the body",
      [](const Points& points) { return around(points, Mat3::Identity()); }},
     {"scatter about the origin",
      "You have taken the scatter about the origin of the world. Then the axes depend "
      "on how far away the points are: subtract their mean first.",
      "A box that lies along the body",
      along([](const Points& points, const Vec3&) { return scatter(points, Vec3::Zero()); })},
     {"scatter about the middle of the upright box",
      "You have taken the scatter about the middle of the box along x, y and z. Take it "
      "about the mean of the points.",
      "A box that lies along the body", along([](const Points& points, const Vec3&) {
        return scatter(points, around(points, Mat3::Identity()).centre);
      })},
     {"products with a minus",
      "The numbers off the diagonal of your scatter matrix have the wrong sign. The "
      "minus belongs to the inertia tensor, which has other numbers on its diagonal as "
      "well.",
      "A box that lies along the body", along([](const Points& points, const Vec3& c) -> Mat3 {
        const Mat3 S = scatter(points, c), diagonal = S.diagonal().asDiagonal();
        return 2 * diagonal - S;
      })},
     {"mean for the centre",
      "Your axes and size are right, but you have returned the mean of the points as "
      "the centre. The centre is halfway between the faces.",
      "A box that lies along the body",
      changed([](Box& box, const Points& points) { box.centre = mean(points); })},
     {"centre left in box axes",
      "Your centre is halfway between the faces, but in coordinates along the axes of "
      "the box. Turn it back into world axes.",
      "A box that lies along the body",
      [](const Points& points) {
        // As someone gets it who uses the axes that are given.
        Box box = around(points, bounding_boxes::principal_axes(scatter(points, mean(points))));
        box.centre = box.R.transpose() * box.centre;
        return box;
      }},
     {"measured from the mean",
      "You have measured the centre from the mean of the points. Add the mean again.",
      "A box that lies along the body",
      changed([](Box& box, const Points& points) { box.centre -= mean(points); })},
     {"points turned the wrong way",
      "You have turned the points by R, which takes box axes to world axes. You want "
      "their coordinates along the box's axes: turn the other way.",
      "A box that lies along the body",
      [](const Points& points) {
        const Mat3 R = bounding_boxes::principal_axes(scatter(points, mean(points)));
        const Box box = around(points, R.transpose());
        return Box{R * (R * box.centre), R, box.size};
      }},
     {"R transposed",
      "You have returned the transpose of R: its rows are the directions of the edges. "
      "They should be its columns.",
      "A box that lies along the body",
      [](const Points& points) {
        const Mat3 R = bounding_boxes::principal_axes(scatter(points, mean(points)));
        const Box box = around(points, R);
        return Box{box.centre, R.transpose(), box.size};
      }},
     {"half the size",
      "These are the distances from the middle to the faces. Return the full lengths of "
      "the edges.",
      "The box along the axes", changed([](Box& box, const Points&) { box.size /= 2; })},
     {"the scatter for the size",
      "You have made the size from how much the points scatter along the axes, the root "
      "of their mean square. The box has to hold all of them: go by the outermost ones.",
      "A box that lies along the body", changed([](Box& box, const Points& points) {
        const Mat3 S = box.R.transpose() * scatter(points, mean(points)) * box.R;
        const Vec3 squares = S.diagonal() / static_cast<double>(points.size());
        box.size = squares.cwiseMax(0).cwiseSqrt();
      })},
     {"edges sorted without their axes",
      "You have sorted the lengths of the edges, but left the columns of R in their "
      "order. Each length belongs to one column.",
      "A box turned and moved",
      [](const Points& points) {
        Box box = around(points, bounding_boxes::principal_axes(scatter(points, mean(points))));
        std::sort(box.size.begin(), box.size.end(), std::greater<>());
        return box;
      }},
     {"left-handed",
      "Your box is right, but R is a reflection: one of its columns points the wrong "
      "way. Make the third the cross product of the first two.",
      "A box that lies along the body",
      changed([](Box& box, const Points&) { box.R.col(2) *= -1; })},
     {"digits lost far from the origin",
      "Near the origin this is right. Far from it you have found the scatter as a "
      "difference of two huge matrices: subtract the mean from each point first, and "
      "square afterwards.",
      "Far from the origin", along([](const Points& points, const Vec3& c) -> Mat3 {
        return scatter(points, Vec3::Zero()) -
               static_cast<double>(points.size()) * (c * c.transpose());
      })}}};
