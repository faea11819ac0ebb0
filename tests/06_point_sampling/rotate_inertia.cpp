/// @file
/// 6.5 rotate_inertia: its laws, and what goes wrong.
#include <Eigen/LU>
#include <cmath>
#include <utility>

#include "06_point_sampling/contract.hpp"
#include "06_point_sampling/inputs.hpp"
#include "judge/spec/spec.hpp"
#include "tumble/mass/parallel_axis.hpp"
#include "tumble/mass/transform.hpp"

using namespace tumble::judge;
using tumble::Mat3, tumble::Vec3;

namespace student {
const Function<decltype(point_sampling::rotate_inertia)> rotate_inertia{TUMBLE_UNIT};
}

namespace {

Mat3 reference(const Mat3& R, const Mat3& I_body) { return tumble::rotate_inertia(R, I_body); }

/// Two products of matrices round by 3 eps of ‖I‖ and √3 ‖I‖ a number; an R that is a rotation up
/// to rounding adds as much on either side.
double rounding(const Mat3& I) { return 32 * eps * I.norm(); }

/// A tensor with something on either side.
Mat3 between(const Mat3& left, const Mat3& tensor, const Mat3& right) {
  return left * tensor * right;
}

}  // namespace

TEST_SUITE(TUMBLE_UNIT) {
  TEST_CASE("any body, turned in any way") {
    for (int n = 0; n < 20; ++n) {
      const Mat3 R = any_rotation(), I_body = any_inertia();
      REQUIRE(student::rotate_inertia(R, I_body) ==
              close_to(reference(R, I_body), rounding(I_body)));
    }
  }

  TEST_CASE("a quarter turn about one axis exchanges the moments about the two others") {
    const Mat3 I_body = any_moments().asDiagonal();
    for (int k = 0; k < 3; ++k) {
      const int i = (k + 1) % 3, j = (k + 2) % 3;
      Mat3 quarter = Mat3::Zero();
      quarter(k, k) = quarter(j, i) = 1;
      quarter(i, j) = -1;
      Mat3 exchanged = I_body;
      std::swap(exchanged(i, i), exchanged(j, j));
      REQUIRE(student::rotate_inertia(quarter, I_body) == close_to(exchanged, rounding(I_body)));
    }
  }

  TEST_CASE("a stick along its own x axis, turned upwards by 30 degrees: the product is negative") {
    // 1 kg at each end, 1 m from the middle: about its own axis there is no inertia at all.
    const Mat3 I_body = Vec3(0, 2, 2).asDiagonal();
    const double c = std::sqrt(3) / 2, s = 0.5;
    Mat3 R, expected;
    R << c, 0, -s,  //
        0, 1, 0,    //
        s, 0, c;
    expected << 2 * s * s, 0, -2 * s * c,  //
        0, 2, 0,                           //
        -2 * s * c, 0, 2 * c * c;
    REQUIRE(student::rotate_inertia(R, I_body) == close_to(expected, rounding(I_body)));
  }

  TEST_CASE("about a principal axis, wherever it points now, the moment is what it was") {
    for (int n = 0; n < 10; ++n) {
      const Vec3 moments = any_moments();
      const Mat3 R = any_rotation(), axes = any_rotation(), I_body = symmetric(moments, axes);
      const auto I = student::rotate_inertia(R, I_body);
      for (int k = 0; k < 3; ++k) {
        const Vec3 axis = R * axes.col(k);
        // Nine numbers may be off, three of them meet in each component.
        REQUIRE(I == obeys("I u = moment · u", (I.value() * axis - moments[k] * axis).norm(),
                           4 * rounding(I_body)));
      }
    }
  }

  TEST_CASE("the points of a body turned, or its tensor turned: the same") {
    for (int n = 0; n < 10; ++n) {
      const Mat3 R = any_rotation();
      Mat3 I_body = Mat3::Zero(), expected = Mat3::Zero();
      for (const auto& [mass, position] : any_points(5)) {
        I_body += tumble::point_inertia(mass, position);
        expected += tumble::point_inertia(mass, R * position);
      }
      REQUIRE(student::rotate_inertia(R, I_body) == close_to(expected, 2 * rounding(I_body)));
    }
  }

  TEST_CASE("one turn after the other is the turn by the product; and back, nothing has changed") {
    for (int n = 0; n < 10; ++n) {
      const Mat3 first = any_rotation(), second = any_rotation(), I_body = any_inertia();
      const auto once = student::rotate_inertia(first, I_body);
      REQUIRE(student::rotate_inertia(second, once) ==
              close_to(reference(second * first, I_body), 6 * rounding(I_body)));
      REQUIRE(student::rotate_inertia(first.transpose(), once) ==
              close_to(I_body, 6 * rounding(I_body)));
    }
  }

  TEST_CASE("an upright body keeps its tensor, and a ball its own however it is turned") {
    for (int n = 0; n < 10; ++n) {
      const Mat3 I_body = any_inertia(), ball = any_number(0.1, 5) * Mat3::Identity();
      REQUIRE(student::rotate_inertia(Mat3::Identity(), I_body) ==
              close_to(I_body, rounding(I_body)));
      REQUIRE(student::rotate_inertia(any_rotation(), ball) == close_to(ball, rounding(ball)));
    }
  }

  TEST_CASE("needles, specks of dust and planets") {
    for (const double size : {0., 1e-100, 1e-8, 1e8, 1e100}) {
      const Mat3 R = any_rotation();
      for (const Vec3& moments : {any_moments(), Vec3(1e-6, 1, 1), Vec3(0, 1, 1)}) {
        const Mat3 I_body = symmetric(size * moments, any_rotation());
        REQUIRE(student::rotate_inertia(R, I_body) ==
                close_to(reference(R, I_body), rounding(I_body)));
      }
    }
  }
}

const Misconceptions<decltype(point_sampling::rotate_inertia)> misconceptions{
    TUMBLE_UNIT,
    {{"turned the wrong way",
      "You have the transpose of R on the left and R on the right. That takes a tensor "
      "from world axes to body axes; yours comes in body axes.",
      "Turning a tensor",
      [](const Mat3& R, const Mat3& I_body) { return reference(R.transpose(), I_body); }},
     {"turned from the left only",
      "You have turned the columns of the tensor, but not its rows. It takes a vector "
      "and gives a vector, and both have to be in world axes.",
      "Turning a tensor", [](const Mat3& R, const Mat3& I_body) -> Mat3 { return R * I_body; }},
     {"turned from the right only",
      "You have turned the rows of the tensor, but not its columns. It takes a vector "
      "and gives a vector, and both have to be in world axes.",
      "Turning a tensor",
      [](const Mat3& R, const Mat3& I_body) -> Mat3 { return (R * I_body).transpose(); }},
     {"R on both sides",
      "You have R on both sides. One side has to undo what the other one does: on the "
      "right, go from world axes to body axes.",
      "Turning a tensor", [](const Mat3& R, const Mat3& I_body) { return between(R, I_body, R); }},
     {"transposed on both sides",
      "You have the transpose of R on both sides. One side has to undo what the other "
      "one does: on the left, go from body axes to world axes.",
      "Turning a tensor",
      [](const Mat3& R, const Mat3& I_body) {
        return between(R.transpose(), I_body, R.transpose());
      }},
     {"not turned",
      "This is the tensor in body axes. In world axes its numbers change while the body turns.",
      "Turning a tensor", [](const Mat3&, const Mat3& I_body) { return I_body; }},
     {"diagonal only",
      "You have turned only the three numbers on the diagonal. The body's axes need not "
      "be its principal axes: turn the products too.",
      "Turning a tensor",
      [](const Mat3& R, const Mat3& I_body) {
        return reference(R, I_body.diagonal().asDiagonal());
      }},
     {"products dropped",
      "You have turned the tensor correctly, but kept only its diagonal. In world axes "
      "even a box has products, as soon as it is not upright.",
      "Turning a tensor",
      [](const Mat3& R, const Mat3& I_body) -> Mat3 {
        return reference(R, I_body).diagonal().asDiagonal();
      }},
     {"moments turned like a vector",
      "You have turned the three moments by R as if they were a vector, which can even "
      "make them negative. Turn a tensor from both sides.",
      "Turning a tensor",
      [](const Mat3& R, const Mat3& I_body) -> Mat3 {
        return (R * I_body.diagonal()).asDiagonal();
      }},
     {"inverted",
      "This is the inverse of the tensor, turned. It takes L to ω; you want what takes "
      "ω to L.",
      "Turning a tensor",
      [](const Mat3& R, const Mat3& I_body) -> Mat3 { return reference(R, I_body.inverse()); }}}};
