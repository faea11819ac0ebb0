/// @file
/// 7.2 box_inertia: its laws, and what goes wrong.
#include <cmath>
#include <utility>

#include "07_bounding_boxes/contract.hpp"
#include "07_bounding_boxes/inputs.hpp"
#include "judge/spec/spec.hpp"
#include "tumble/mass/oriented_box.hpp"
#include "tumble/mass/parallel_axis.hpp"
#include "tumble/mass/transform.hpp"

using namespace tumble::judge;
using tumble::Mat3, tumble::point_inertia, tumble::Vec3;

namespace student {
const Function<decltype(bounding_boxes::box_inertia)> box_inertia{TUMBLE_UNIT};
}

namespace {

/// In its own axes, about its own centre.
Mat3 own_inertia(double mass, const Vec3& size) {
  const Vec3 squares = size.cwiseAbs2();
  return mass / 12 * Mat3((Vec3::Constant(squares.sum()) - squares).asDiagonal());
}

/// Turned and moved: a box that has `own` in its own axes.
Mat3 placed(const Mat3& own, double mass, const Box& box, const Vec3& about) {
  return tumble::parallel_axis(tumble::rotate_inertia(box.R, own), mass, box.centre - about);
}

Mat3 reference(double mass, const Box& box, const Vec3& about) {
  if (!(mass > 0 && box.size.minCoeff() > 0))  // which the library refuses
    return placed(own_inertia(mass, box.size), mass, box, about);
  return tumble::inertia_about(
      tumble::boxes::box_mass_properties({box.centre, box.R, box.size}, mass), about);
}

/// Some 5 eps for the moments, 6 for the turn and 4 for what is added by the move; an R that is a
/// rotation up to rounding adds some. Both sides together.
double rounding(double mass, const Box& box, const Vec3& about) {
  return 48 * eps * mass * (box.size.squaredNorm() + (box.centre - about).squaredNorm());
}

/// The same for someone who goes by way of the origin: allowed as long as all is near it.
double rounding_near_origin(double mass, const Box& box, const Vec3& about) {
  return 48 * eps * mass *
         (box.size.squaredNorm() + 4 * box.centre.squaredNorm() + 4 * about.squaredNorm());
}

Box any_box() {
  return {
      any_vector(3), any_rotation(), {any_number(0.5, 3), any_number(0.5, 3), any_number(0.5, 3)}};
}

/// The answer of someone who has other moments in the box's own axes.
template <class Own>
auto with(const Own& own) {
  return [own](double mass, const Box& box, const Vec3& about) -> Mat3 {
    return placed(own(mass, box.size), mass, box, about);
  };
}

}  // namespace

TEST_SUITE(TUMBLE_UNIT) {
  TEST_CASE("any box, turned in any way, about any point") {
    for (int n = 0; n < 20; ++n) {
      const double mass = any_number(0.5, 5);
      const Box box = any_box();
      const Vec3 about = any_vector(3);
      REQUIRE(student::box_inertia(mass, box, about) ==
              close_to(reference(mass, box, about), rounding_near_origin(mass, box, about)));
    }
  }

  TEST_CASE("12 kg in an upright box of 1 m, 2 m and 3 m, about its centre: 13, 10, 5 kg m²") {
    const Box box{any_vector(3), Mat3::Identity(), {1, 2, 3}};
    const Mat3 expected = Vec3(13, 10, 5).asDiagonal();
    REQUIRE(student::box_inertia(12, box, box.centre) ==
            close_to(expected, rounding_near_origin(12, box, box.centre)));
  }

  TEST_CASE("a rod about its middle m l²/12, about its end m l²/3; along itself nothing") {
    for (int n = 0; n < 5; ++n) {
      const double mass = any_number(0.5, 5), length = any_number(0.5, 3);
      const Box rod{any_vector(3), any_rotation(), {length, 0, 0}};
      const Vec3 u = rod.R.col(0), end = rod.centre + length / 2 * u;
      const Mat3 across = mass * length * length * (Mat3::Identity() - u * u.transpose());
      REQUIRE(student::box_inertia(mass, rod, rod.centre) ==
              close_to(Mat3(across / 12), rounding_near_origin(mass, rod, rod.centre)));
      REQUIRE(student::box_inertia(mass, rod, end) ==
              close_to(Mat3(across / 3), rounding_near_origin(mass, rod, end)));
    }
  }

  TEST_CASE("a box cut in two anywhere: the inertias of the pieces add up") {
    for (int n = 0; n < 9; ++n) {
      const double mass = any_number(0.5, 5), share = any_number(0.1, 0.9);
      const Box box = any_box();
      const Vec3 about = any_vector(3), edge = box.size[n % 3] * box.R.col(n % 3);
      Box first = box, second = box;
      first.size[n % 3] *= share;
      first.centre -= (1 - share) / 2 * edge;
      second.size[n % 3] *= 1 - share;
      second.centre += share / 2 * edge;
      const auto whole = student::box_inertia(mass, box, about);
      const auto a = student::box_inertia(share * mass, first, about);
      // The places of the pieces are rounded as well.
      const Mat3 rest = whole.value() - a.value();
      REQUIRE(student::box_inertia((1 - share) * mass, second, about) ==
              close_to(rest, 4 * rounding_near_origin(mass, box, about)));
    }
  }

  TEST_CASE(
      "eight point masses, each 1/√3 of the way from the centre to a corner, resist like a box") {
    for (int n = 0; n < 5; ++n) {
      const double mass = any_number(0.5, 5);
      const Box box = any_box();
      const Vec3 about = any_vector(3);
      Mat3 expected = Mat3::Zero();
      for (int corner = 0; corner < 8; ++corner) {
        const Vec3 signs(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
        const Vec3 r = box.R * box.size.cwiseProduct(signs) / std::sqrt(12);
        expected += point_inertia(mass / 8, box.centre + r - about);
      }
      REQUIRE(student::box_inertia(mass, box, about) ==
              close_to(expected, 2 * rounding_near_origin(mass, box, about)));
    }
  }

  TEST_CASE("a cube about its centre, however it is turned: m a²/6 in all directions") {
    for (int n = 0; n < 5; ++n) {
      const double mass = any_number(0.5, 5), edge = any_number(0.5, 3);
      const Box cube{any_vector(3), any_rotation(), Vec3::Constant(edge)};
      const Mat3 expected = mass * edge * edge / 6 * Mat3::Identity();
      REQUIRE(student::box_inertia(mass, cube, cube.centre) ==
              close_to(expected, rounding_near_origin(mass, cube, cube.centre)));
    }
  }

  TEST_CASE("which edge is called the first one, and which way it points, does not matter") {
    for (int n = 0; n < 5; ++n) {
      const double mass = any_number(0.5, 5);
      const Box box = any_box();
      const Vec3 about = any_vector(3);
      Box renamed = box;
      renamed.R << box.R.col(1), -box.R.col(0), box.R.col(2);
      std::swap(renamed.size.x(), renamed.size.y());
      const auto I = student::box_inertia(mass, box, about);
      REQUIRE(student::box_inertia(mass, renamed, about) ==
              close_to(I.value(), 2 * rounding_near_origin(mass, box, about)));
      renamed.R << box.R.col(1), -box.R.col(2), -box.R.col(0);
      renamed.size = Vec3(box.size.y(), box.size.z(), box.size.x());
      REQUIRE(student::box_inertia(mass, renamed, about) ==
              close_to(I.value(), 2 * rounding_near_origin(mass, box, about)));
    }
  }

  TEST_CASE(
      "plates, points and boxes without mass, tiny and huge ones; far away no digit is lost") {
    for (const double size : {1e-50, 1e-8, 1e8, 1e50}) {
      for (const Vec3& shape : {Vec3(1, 1, 1), Vec3(2, 1, 0), Vec3(0, 0, 0), Vec3(1e-6, 1, 1)}) {
        for (const double mass : {0., 1e-100, 1e100}) {
          Box box = any_box();
          box.size = size * box.size.cwiseProduct(shape);
          box.centre *= size;
          const Vec3 about = any_vector(size);
          REQUIRE(student::box_inertia(mass, box, about) ==
                  close_to(reference(mass, box, about), rounding_near_origin(mass, box, about)));
        }
      }
    }
    for (const double far : {1e4, 1e6, 1e8}) {
      Box box = any_box();
      box.centre += far * any_direction();
      const Vec3 about = box.centre + any_vector(2);
      REQUIRE(student::box_inertia(2, box, about) ==
              close_to(reference(2, box, about), rounding(2, box, about)));
    }
  }

  TEST_CASE("close to the centre is not at it: the right tensor there, also far from the origin") {
    for (const double apart : {1e-2, 1e-5, 1e-7}) {
      for (const double far : {0., 1e8}) {
        Box box = any_box();
        box.size *= apart;  // so small that a shift of `apart` counts
        box.centre = Vec3(far, -far, far);
        // On a grid: the difference is not rounded, and not zero.
        const double step = far > 0 ? std::ldexp(1, -26) : std::ldexp(1, -40);
        const Vec3 shift = step * (apart / step * any_direction()).array().round().matrix();
        const Vec3 about = box.centre + shift;
        REQUIRE(student::box_inertia(2, box, about) ==
                close_to(reference(2, box, about), rounding(2, box, about)));
      }
    }
  }
}

const Misconceptions<decltype(bounding_boxes::box_inertia)> misconceptions{
    TUMBLE_UNIT,
    {{"half lengths for lengths",
      "You have halved the edges, and still divided their squares by 12. The twelfth "
      "belongs to full lengths, and those are in `size`.",
      "The inertia of a box",
      with([](double mass, const Vec3& size) { return own_inertia(mass, size / 2); })},
     {"a third for a twelfth",
      "You have divided the squares of the edges by 3. That is for half lengths, or for "
      "a rod about its end. Here the edges are full lengths, and the first step is "
      "about the centre.",
      "The inertia of a box",
      with([](double mass, const Vec3& size) -> Mat3 { return 4 * own_inertia(mass, size); })},
     {"each axis with its own edge",
      "About each axis you have the square of the edge along it. That edge is the one "
      "that does not count: a pencil is easy to turn about its length.",
      "The inertia of a box", with([](double mass, const Vec3& size) -> Mat3 {
        return mass / 12 * Mat3(size.cwiseAbs2().asDiagonal());
      })},
     {"edges in the wrong place",
      "Your three moments are right, but they are one place too far on. About the first "
      "axis the second and the third edge count.",
      "The inertia of a box", with([](double mass, const Vec3& size) {
        return own_inertia(mass, {size.z(), size.x(), size.y()});
      })},
     {"square of the sum",
      "You have added the two edges before you squared them. Square each by itself.",
      "The inertia of a box", with([](double mass, const Vec3& size) -> Mat3 {
        return mass / 12 * Mat3((Vec3::Constant(size.sum()) - size).cwiseAbs2().asDiagonal());
      })},
     {"mass in the corners",
      "This is a box with all its mass in the eight corners, three times as hard to turn. A full "
      "box has most of its mass nearer to the middle.",
      "The inertia of a box",
      with([](double mass, const Vec3& size) -> Mat3 { return 3 * own_inertia(mass, size); })},
     {"an ellipsoid",
      "These are the moments of an ellipsoid that just fits into the box. It lacks the corners, "
      "which count most.",
      "The inertia of a box",
      with([](double mass, const Vec3& size) -> Mat3 { return 0.6 * own_inertia(mass, size); })},
     {"mass taken for density",
      "You have multiplied the mass with the volume of the box, as if it were a "
      "density. It is in kg already.",
      "The inertia of a box",
      [](double mass, const Box& box, const Vec3& about) {
        return reference(mass * box.size.prod(), box, about);
      }},
     {"not turned",
      "You have left the tensor in the box's own axes. Turn it into world axes with R.",
      "A box turned and moved",
      [](double mass, const Box& box, const Vec3& about) {
        return reference(mass, {box.centre, Mat3::Identity(), box.size}, about);
      }},
     {"turned the wrong way",
      "You have turned the tensor from world axes to box axes, where it already was. R "
      "takes the box's axes to the world's.",
      "A box turned and moved",
      [](double mass, const Box& box, const Vec3& about) {
        return reference(mass, {box.centre, box.R.transpose(), box.size}, about);
      }},
     {"turned from the left only",
      "You have R on the left of the tensor, and nothing on its right. A tensor takes a "
      "vector and gives one, and both have to be in world axes.",
      "A box turned and moved",
      [](double mass, const Box& box, const Vec3& about) -> Mat3 {
        return box.R * own_inertia(mass, box.size) + point_inertia(mass, box.centre - about);
      }},
     {"edges turned like a vector",
      "You have multiplied R with the three lengths. They are not the components of an "
      "arrow: turn the tensor, not the edges.",
      "A box turned and moved",
      [](double mass, const Box& box, const Vec3& about) {
        return reference(mass, {box.centre, Mat3::Identity(), (box.R * box.size).cwiseAbs()},
                         about);
      }},
     {"about the centre only",
      "This is the inertia about the centre of the box. Move it to the point `about`.",
      "A box turned and moved",
      [](double mass, const Box& box, const Vec3&) { return reference(mass, box, box.centre); }},
     {"moved the wrong way",
      "You have taken away what belongs to the move: add it. About its centre a box has "
      "the least inertia.",
      "A box turned and moved",
      [](double mass, const Box& box, const Vec3& about) -> Mat3 {
        return reference(mass, box, box.centre) - point_inertia(mass, box.centre - about);
      }},
     {"about the world's origin",
      "You have moved the tensor to the origin of the world. Move it to the point "
      "`about`.",
      "A box turned and moved",
      [](double mass, const Box& box, const Vec3&) { return reference(mass, box, Vec3::Zero()); }},
     {"moved before it was turned",
      "You have added the move in box axes, but with an arrow in world axes, and then "
      "turned it together with the box. Turn first, or bring the arrow into box axes.",
      "A box turned and moved",
      [](double mass, const Box& box, const Vec3& about) {
        const Mat3 moved = own_inertia(mass, box.size) + point_inertia(mass, box.centre - about);
        return tumble::rotate_inertia(box.R, moved);
      }},
     {"a point mass",
      "This is what all the mass would have in the centre of the box. Its extent makes "
      "it harder to turn.",
      "The inertia of a box",
      [](double mass, const Box& box, const Vec3& about) {
        return point_inertia(mass, box.centre - about);
      }},
     {"a point near the centre taken for it",
      "You don't move the tensor where “about” is nearly the centre of the box. isApprox asks how "
      "far apart they are in comparison with their distance from the origin: 1e8 m away it takes "
      "0.1 mm for nothing. You need no such case: a move by nothing adds nothing.",
      "Far from the origin",
      [](double mass, const Box& box, const Vec3& about) {
        return reference(mass, box, about.isApprox(box.centre) ? box.centre : about);
      }},
     {"digits lost far from the origin",
      "Near the origin this is right. Far from it you have formed a huge tensor about "
      "the origin on the way, and rounding has eaten the small one in it.",
      "Far from the origin", [](double mass, const Box& box, const Vec3& about) -> Mat3 {
        const Mat3 about_origin = reference(mass, box, Vec3::Zero());
        return about_origin - point_inertia(mass, box.centre) +
               point_inertia(mass, box.centre - about);
      }}}};
