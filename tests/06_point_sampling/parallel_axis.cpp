/// @file
/// 6.4 parallel_axis: its laws, and what goes wrong.
#include "tumble/mass/parallel_axis.hpp"

#include <cmath>
#include <vector>

#include "06_point_sampling/contract.hpp"
#include "06_point_sampling/inputs.hpp"
#include "judge/spec/spec.hpp"

using namespace tumble::judge;
using tumble::Mat3, tumble::point_inertia, tumble::Vec3;

namespace student {
const Function<decltype(point_sampling::parallel_axis)> parallel_axis{TUMBLE_UNIT};
}

namespace {

Mat3 reference(const Mat3& I, double mass, const Vec3& centre, const Vec3& from, const Vec3& to) {
  const Mat3 I_centre = tumble::inertia_about_centre(I, mass, centre - from);
  return tumble::parallel_axis(I_centre, mass, centre - to);
}

/// What a question consists of: a body with the inertia about its centre that some body has.
struct Body {
  double mass = any_number(0.5, 5);
  Vec3 centre = any_vector(3);
  Mat3 I_centre = any_inertia();

  Mat3 about(const Vec3& point) const { return I_centre + point_inertia(mass, centre - point); }
};

/// A difference, a square, another one, their sum, a product and two sums: 8 eps of the tensor and
/// of m d² for either point; and for the inputs that a case has made, as much. Both sides together.
double rounding(const Mat3& I, double mass, const Vec3& centre, const Vec3& from, const Vec3& to) {
  return 32 * eps *
         (I.norm() + mass * ((centre - from).squaredNorm() + (centre - to).squaredNorm()));
}

/// The same for someone who goes by way of the origin: allowed as long as all is near it.
double rounding_near_origin(const Mat3& I, double mass, const Vec3& centre, const Vec3& from,
                            const Vec3& to) {
  const double squares = centre.squaredNorm() + from.squaredNorm() + to.squaredNorm();
  return 32 * eps * (I.norm() + 4 * mass * squares);
}

Mat3 diagonal_of(const Mat3& I) { return I.diagonal().asDiagonal(); }

/// The law with another tensor of a point mass in the place of m (dᵀd 1 − d dᵀ).
template <class Tensor>
auto with(const Tensor& tensor) {
  return [tensor](const Mat3& I, double mass, const Vec3& centre, const Vec3& from,
                  const Vec3& to) -> Mat3 {
    return I - tensor(mass, Vec3(centre - from)) + tensor(mass, Vec3(centre - to));
  };
}

}  // namespace

TEST_SUITE(TUMBLE_UNIT) {
  TEST_CASE("any body, from any point to any other one") {
    for (int n = 0; n < 20; ++n) {
      const Body body;
      const Vec3 from = any_vector(3), to = any_vector(3);
      const Mat3 I = body.about(from);
      REQUIRE(student::parallel_axis(I, body.mass, body.centre, from, to) ==
              close_to(reference(I, body.mass, body.centre, from, to),
                       rounding_near_origin(I, body.mass, body.centre, from, to)));
    }
  }

  TEST_CASE("away from the centre of mass it gets harder to turn by m d² across, by 0 along d") {
    for (int n = 0; n < 10; ++n) {
      const Body body;
      const double far = any_number(0.5, 3);
      const Vec3 along = any_direction(), across = along.unitOrthogonal();
      const Vec3 to = body.centre + far * along;
      const auto I = student::parallel_axis(body.I_centre, body.mass, body.centre, body.centre, to);
      const double bound =
          4 * rounding_near_origin(body.I_centre, body.mass, body.centre, body.centre, to);
      const auto gain = [&](const Vec3& u) { return u.dot((I.value() - body.I_centre) * u); };
      REQUIRE(I == obeys("along d nothing is added", std::abs(gain(along)), bound));
      REQUIRE(I == obeys("across d there is m d² more",
                         std::abs(gain(across) - body.mass * far * far), bound));
    }
  }

  TEST_CASE("moved back to the centre of mass, the tensor is the body's own one again") {
    for (int n = 0; n < 10; ++n) {
      const Body body;
      const Vec3 from = any_vector(3);
      const Mat3 I = body.about(from);
      REQUIRE(student::parallel_axis(I, body.mass, body.centre, from, body.centre) ==
              close_to(body.I_centre,
                       rounding_near_origin(I, body.mass, body.centre, from, body.centre)));
    }
  }

  TEST_CASE("two points equally far from the centre: not the same tensor, but the right one") {
    Body body;
    body.centre = Vec3(1, -2, 3);  // nothing is rounded: both distances are 2 m to the last bit
    for (int k = 0; k < 3; ++k) {
      const Vec3 from = body.centre + 2 * Vec3::Unit(k);
      const Vec3 to = body.centre - 2 * Vec3::Unit((k + 1) % 3);
      const Mat3 I = body.about(from);
      REQUIRE(student::parallel_axis(I, body.mass, body.centre, from, to) ==
              close_to(reference(I, body.mass, body.centre, from, to),
                       rounding_near_origin(I, body.mass, body.centre, from, to)));
    }
  }

  TEST_CASE("from a point to itself, and there and back, nothing changes") {
    for (int n = 0; n < 10; ++n) {
      const Body body;
      const Vec3 here = any_vector(3), there = any_vector(3);
      const Mat3 I = body.about(here);
      const double bound = rounding_near_origin(I, body.mass, body.centre, here, there);
      REQUIRE(student::parallel_axis(I, body.mass, body.centre, here, here) == close_to(I, bound));
      const auto away = student::parallel_axis(I, body.mass, body.centre, here, there);
      REQUIRE(student::parallel_axis(away, body.mass, body.centre, there, here) ==
              close_to(I, 3 * bound));
    }
  }

  TEST_CASE("a way in two legs leads to the same tensor as the direct one") {
    for (int n = 0; n < 10; ++n) {
      const Body body;
      const Vec3 a = any_vector(3), b = any_vector(3), c = any_vector(3);
      const Mat3 I = body.about(a);
      const auto direct = student::parallel_axis(I, body.mass, body.centre, a, c);
      const auto leg = student::parallel_axis(I, body.mass, body.centre, a, b);
      REQUIRE(
          student::parallel_axis(leg, body.mass, body.centre, b, c) ==
          close_to(direct.value(), 2 * rounding_near_origin(I, body.mass, body.centre, a, b) +
                                       2 * rounding_near_origin(I, body.mass, body.centre, b, c)));
    }
  }

  TEST_CASE("it agrees with the sum over the points of a body, about either point") {
    for (int n = 0; n < 10; ++n) {
      const auto points = any_points(6);
      const Vec3 from = any_vector(3), to = any_vector(3);
      Vec3 moment = Vec3::Zero();
      Mat3 I = Mat3::Zero(), expected = Mat3::Zero();
      for (const auto& [mass, position] : points) {
        moment += mass * position;
        I += point_inertia(mass, position - from);
        expected += point_inertia(mass, position - to);
      }
      const double mass = mass_of(points);
      const Vec3 centre = moment / mass;
      REQUIRE(student::parallel_axis(I, mass, centre, from, to) ==
              close_to(expected, 2 * rounding_near_origin(I, mass, centre, from, to)));
    }
  }

  TEST_CASE("far from the origin no digit is lost") {
    for (const double far : {1e4, 1e6, 1e8}) {
      for (int n = 0; n < 5; ++n) {
        Body body;
        const Vec3 place = far * any_direction();
        body.centre += place;
        const Vec3 from = place + any_vector(2), to = place + any_vector(2);
        const Mat3 I = body.about(from);
        REQUIRE(student::parallel_axis(I, body.mass, body.centre, from, to) ==
                close_to(reference(I, body.mass, body.centre, from, to),
                         rounding(I, body.mass, body.centre, from, to)));
      }
    }
  }

  TEST_CASE("points close together are not the same: the right tensor, also far from the origin") {
    for (const double apart : {1e-2, 1e-5, 1e-7}) {
      for (const double far : {0., 1e8}) {
        // On a grid: the differences are not rounded, and not zero.
        const double step = far > 0 ? std::ldexp(1, -26) : std::ldexp(1, -40);
        const auto near = [&, place = Vec3(far, -far, far)](const Vec3& way) -> Vec3 {
          return place + step * (apart / step * way).array().round().matrix();
        };
        const auto holds = [&](const Vec3& centre, const Vec3& from, const Vec3& to) {
          // So small a body that a shift of `apart` counts.
          const double mass = any_number(0.5, 5);
          const Mat3 I = mass * apart * apart * any_inertia() + point_inertia(mass, centre - from);
          return student::parallel_axis(I, mass, centre, from, to) ==
                 close_to(reference(I, mass, centre, from, to),
                          rounding(I, mass, centre, from, to));
        };
        const Vec3 here = near(Vec3::Zero()), close = near(any_direction());
        const Vec3 away = near(any_direction() / apart);
        REQUIRE(holds(away, here, close));
        REQUIRE(holds(here, close, away));
        REQUIRE(holds(here, away, close));
        REQUIRE(holds(here, close, near(any_direction())));
      }
    }
  }

  TEST_CASE("a body of one point, one without mass, tiny and huge ones") {
    const Vec3 centre = any_vector(3), from = any_vector(3), to = any_vector(3);
    const Mat3 I = point_inertia(2, centre - from);
    REQUIRE(student::parallel_axis(I, 2, centre, from, to) ==
            close_to(point_inertia(2, centre - to), rounding_near_origin(I, 2, centre, from, to)));
    REQUIRE(student::parallel_axis(Mat3::Zero(), 0, centre, from, to) ==
            close_to(Mat3(Mat3::Zero()), 0));
    for (const double size : {1e-50, 1e-8, 1e8, 1e50}) {
      for (const double mass : {1e-100, 1e-8, 1e8, 1e100}) {
        const Vec3 c = any_vector(size), a = any_vector(size), b = any_vector(size);
        const Mat3 tensor = mass * (size * size * any_inertia() + point_inertia(1, c - a));
        REQUIRE(student::parallel_axis(tensor, mass, c, a, b) ==
                close_to(reference(tensor, mass, c, a, b),
                         rounding_near_origin(tensor, mass, c, a, b)));
      }
    }
  }
}

const Misconceptions<decltype(point_sampling::parallel_axis)> misconceptions{
    TUMBLE_UNIT,
    {{"in one step from point to point",
      "You have used the arrow from one point to the other. The law holds between the "
      "centre of mass and a point: between two other points, go through the centre.",
      "Parallel axes",
      [](const Mat3& I, double mass, const Vec3&, const Vec3& from, const Vec3& to) -> Mat3 {
        return I + point_inertia(mass, to - from);
      }},
     {"taken for the one about the centre",
      "You have moved I as if it were about the centre of mass. Here it is about the "
      "point `from`, so take that part away first.",
      "Parallel axes",
      [](const Mat3& I, double mass, const Vec3& centre, const Vec3&, const Vec3& to) -> Mat3 {
        return I + point_inertia(mass, centre - to);
      }},
     {"added twice",
      "You have added something on both legs of the way. On the way to the centre of "
      "mass a body gets easier to turn: subtract there.",
      "Parallel axes",
      [](const Mat3& I, double mass, const Vec3& centre, const Vec3& from, const Vec3& to) -> Mat3 {
        return I + point_inertia(mass, centre - from) + point_inertia(mass, centre - to);
      }},
     {"added and taken away the wrong way round",
      "You have added what belongs to `from`, and taken away what belongs to `to`. "
      "About the centre of mass a body has the least: away from it, it has more.",
      "Parallel axes",
      [](const Mat3& I, double mass, const Vec3& centre, const Vec3& from, const Vec3& to) -> Mat3 {
        return I + point_inertia(mass, centre - from) - point_inertia(mass, centre - to);
      }},
     {"stopped at the centre",
      "This is the inertia about the centre of mass. The second leg of the way is "
      "missing, the one to the point `to`.",
      "Parallel axes",
      [](const Mat3& I, double mass, const Vec3& centre, const Vec3& from, const Vec3&) -> Mat3 {
        return I - point_inertia(mass, centre - from);
      }},
     {"products with a plus",
      "What you add off the diagonal has the wrong sign. Make it like the products of a "
      "point mass: those carry the minus sign.",
      "The discrete inertia sum", with([](double mass, const Vec3& d) -> Mat3 {
        const Mat3 tensor = point_inertia(mass, d);
        return 2 * diagonal_of(tensor) - tensor;
      })},
     {"distance of the points, not of the axes",
      "You have added m d² to the whole diagonal and nothing off it. For each axis take "
      "the distance to its parallel: for the axis along d that is zero.",
      "Parallel axes", with([](double mass, const Vec3& d) -> Mat3 {
        return mass * d.squaredNorm() * Mat3::Identity();
      })},
     {"only d dᵀ",
      "You have taken only m d dᵀ, with a plus. It is the smaller part of the law, and "
      "the one that you subtract.",
      "Parallel axes", with([](double mass, const Vec3& d) -> Mat3 { return mass * outer(d); })},
     {"diagonal only",
      "Your diagonal is right, but you have left the products as they were. They change "
      "as well, unless the arrow lies along an axis.",
      "Parallel axes",
      with([](double mass, const Vec3& d) -> Mat3 { return diagonal_of(point_inertia(mass, d)); })},
     {"mass forgotten",
      "You have added square metres to kg m²: the mass is missing. A heavy body gains "
      "more than a light one.",
      "Parallel axes", with([](double, const Vec3& d) -> Mat3 { return point_inertia(1, d); })},
     {"measured from the origin",
      "Your arrows begin at the origin of the world. Let them begin, or end, at the "
      "centre of mass.",
      "Parallel axes",
      [](const Mat3& I, double mass, const Vec3&, const Vec3& from, const Vec3& to) -> Mat3 {
        return I - point_inertia(mass, from) + point_inertia(mass, to);
      }},
     {"added to each number",
      "You have added m d² to all nine numbers of the tensor. What you add has to be a "
      "tensor itself, not a number.",
      "Parallel axes", with([](double mass, const Vec3& d) -> Mat3 {
        return mass * d.squaredNorm() * Mat3::Ones();
      })},
     {"points close together taken for one",
      "You return the tensor as it came where “from” and “to” are nearly equal. isApprox asks how "
      "far apart they are in comparison with their distance from the origin: 1e8 m away it takes "
      "0.1 mm for nothing. You need no such case: between equal points the law changes nothing.",
      "Far from the origin",
      [](const Mat3& I, double mass, const Vec3& centre, const Vec3& from, const Vec3& to) -> Mat3 {
        return from.isApprox(to) ? I : reference(I, mass, centre, from, to);
      }},
     {"a point near the centre taken for it",
      "You leave a leg of the way out where a point is nearly the centre of mass. isApprox asks "
      "how far apart they are in comparison with their distance from the origin: 1e8 m away it "
      "takes 0.1 mm for nothing. You need no such case: a leg without length changes nothing.",
      "Far from the origin",
      [](const Mat3& I, double mass, const Vec3& centre, const Vec3& from, const Vec3& to) {
        const auto leg_end = [&](const Vec3& p) { return p.isApprox(centre) ? centre : p; };
        return reference(I, mass, centre, leg_end(from), leg_end(to));
      }},
     {"digits lost on the way over the origin",
      "Near the origin this is right. Far from it you have added a huge tensor and "
      "taken it away again, and rounding has eaten the small one in it. Go by way of "
      "the centre of mass.",
      "Far from the origin",
      [](const Mat3& I, double mass, const Vec3& centre, const Vec3& from, const Vec3& to) -> Mat3 {
        const Mat3 about_origin =
            I - point_inertia(mass, centre - from) + point_inertia(mass, centre);
        return about_origin - point_inertia(mass, centre) + point_inertia(mass, centre - to);
      }}}};
