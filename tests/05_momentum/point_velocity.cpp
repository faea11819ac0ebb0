/// @file
/// 5.2 point_velocity: its laws, and what goes wrong.
#include <cmath>

#include "05_momentum/contract.hpp"
#include "judge/spec/spec.hpp"
#include "tumble/body/derived.hpp"
#include "tumble/rotation/exp.hpp"

using namespace tumble::judge;
using tumble::Mat3, tumble::Vec3;

namespace student {
const Function<decltype(momentum::point_velocity)> point_velocity{TUMBLE_UNIT};
}

namespace {

Vec3 reference(const Vec3& x, const Mat3& R, const Vec3& v, const Vec3& omega, const Vec3& p_body) {
  return tumble::point_velocity<double>({x, R, v, omega}, p_body);
}

/// Turning the point and the cross product round by 8 eps of |ω| |p_body|, the sum by one of |v|
/// and of that; the way through the body's axes and back, with an R that is a rotation to rounding,
/// by up to 45 of either. Both sides together, with room.
double rounding(const Vec3& v, const Vec3& omega, const Vec3& p_body) {
  return 64 * eps * (omega.norm() * p_body.norm() + v.norm());
}

/// A body somewhere, in motion.
struct Motion {
  Vec3 x = any_vector(5);
  Mat3 R = any_rotation();
  Vec3 v = any_vector(3), omega = any_vector(4);
};

}  // namespace

TEST_SUITE(TUMBLE_UNIT) {
  TEST_CASE("any point of any body that moves and turns") {
    for (int n = 0; n < 20; ++n) {
      const auto [x, R, v, omega] = Motion();
      const Vec3 p_body = any_vector(2);
      REQUIRE(student::point_velocity(x, R, v, omega, p_body) ==
              close_to(reference(x, R, v, omega, p_body), rounding(v, omega, p_body)));
    }
  }

  TEST_CASE("the centre of mass moves with v, and without spin so does every point") {
    for (int n = 0; n < 5; ++n) {
      const auto [x, R, v, omega] = Motion();
      const Vec3 zero = Vec3::Zero(), p_body = any_vector(2);
      REQUIRE(student::point_velocity(x, R, v, omega, zero) ==
              close_to(v, rounding(v, omega, zero)));
      REQUIRE(student::point_velocity(x, R, v, zero, p_body) ==
              close_to(v, rounding(v, zero, p_body)));
      REQUIRE(student::point_velocity(x, R, zero, zero, p_body) == close_to(zero, 0));
    }
  }

  TEST_CASE("spinning about z, a point at x moves along y; turned by a quarter turn, along −x") {
    const Vec3 X = Vec3::UnitX(), Y = Vec3::UnitY(), Z = Vec3::UnitZ(), zero = Vec3::Zero();
    Mat3 quarter;
    quarter << Y, -X, Z;
    const double tolerance = rounding(zero, 2 * Z, 3 * X);
    REQUIRE(student::point_velocity(zero, Mat3::Identity(), zero, 2 * Z, 3 * X) ==
            close_to(Vec3(6 * Y), tolerance));
    REQUIRE(student::point_velocity(zero, quarter, zero, 2 * Z, 3 * X) ==
            close_to(Vec3(-6 * X), tolerance));
  }

  TEST_CASE("it is the slope of the way that the point takes") {
    for (int n = 0; n < 10; ++n) {
      const auto [x, R, v, omega] = Motion();
      const Vec3 p_body = any_vector(2);
      const double h = 0x1p-13, speed = omega.norm();
      const Vec3 way = 2 * h * v + (tumble::exp_rotation<double>(h * omega) * R * p_body -
                                    tumble::exp_rotation<double>(-h * omega) * R * p_body);
      // A central difference misses h²/6 times the third derivative, and rounds by 32 eps / h.
      REQUIRE(student::point_velocity(x, R, v, omega, p_body) ==
              close_to(Vec3(way / (2 * h)), h * h / 6 * speed * speed * speed * p_body.norm() +
                                                32 * eps * (p_body.norm() + h * v.norm()) / h));
    }
  }

  TEST_CASE("no two points of the body come nearer to each other, or part") {
    for (int n = 0; n < 10; ++n) {
      const auto [x, R, v, omega] = Motion();
      const Vec3 a = any_vector(2), b = any_vector(2);
      const auto va = student::point_velocity(x, R, v, omega, a);
      const auto vb = student::point_velocity(x, R, v, omega, b);
      const Vec3 between = R * (a - b);
      // √3 times what the numbers of either answer may be off, and 8 eps for what is made here.
      const double bound = 2 * rounding(v, omega, a) + 2 * rounding(v, omega, b) +
                           8 * eps * (va->norm() + vb->norm());
      REQUIRE(vb == obeys("(ṗ − ṗ′) · (p − p′) = 0",
                          std::abs((va.value() - vb.value()).dot(between)),
                          bound * between.norm()));
    }
  }

  TEST_CASE("points on the axis of the spin, through the centre, move with v alone") {
    for (int n = 0; n < 10; ++n) {
      const auto [x, R, v, omega] = Motion();
      const Vec3 p_body = any_number(-2, 2) * (R.transpose() * omega);
      REQUIRE(student::point_velocity(x, R, v, omega, p_body) ==
              close_to(v, rounding(v, omega, p_body)));
    }
  }

  TEST_CASE("the right velocity wherever the body is: far from the origin no digit is lost") {
    for (const double far : {0., 1., 1e4, 1e8}) {
      for (int n = 0; n < 3; ++n) {
        const auto [x, R, v, omega] = Motion();
        const Vec3 p_body = any_vector(2);
        REQUIRE(student::point_velocity(far * x, R, v, omega, p_body) ==
                close_to(reference(x, R, v, omega, p_body), rounding(v, omega, p_body)));
      }
    }
  }

  TEST_CASE("tiny and huge bodies, slow and fast spins") {
    for (const double size : {1e-100, 1e-8, 1e8, 1e100}) {
      for (const double spin : {1e-100, 1e-8, 1e8, 1e100}) {
        const Mat3 R = any_rotation();
        const Vec3 v = any_vector(spin * size), omega = any_vector(spin), p_body = any_vector(size);
        REQUIRE(student::point_velocity(Vec3::Zero(), R, v, omega, p_body) ==
                close_to(reference(Vec3::Zero(), R, v, omega, p_body), rounding(v, omega, p_body)));
      }
    }
  }
}

const Misconceptions<decltype(momentum::point_velocity)> misconceptions{
    TUMBLE_UNIT,
    {{"point not turned",
      "You have multiplied p_body with ω as it is. It is in body axes, and ω is in world axes: "
      "a cross product needs both in the same frame.",
      "Frames of reference",
      [](const Vec3&, const Mat3&, const Vec3& v, const Vec3& omega, const Vec3& p_body) -> Vec3 {
        return v + omega.cross(p_body);
      }},
     {"turned the wrong way",
      "You have turned the point from world axes to body axes, where it already was. R takes "
      "body axes to world axes.",
      "Frames of reference",
      [](const Vec3& x, const Mat3& R, const Vec3& v, const Vec3& omega, const Vec3& p_body) {
        return reference(x, R.transpose(), v, omega, p_body);
      }},
     {"circling the other way",
      "Your point moves against the spin: the factors of the cross product are swapped.",
      "Velocity of a point",
      [](const Vec3& x, const Mat3& R, const Vec3& v, const Vec3& omega, const Vec3& p_body) {
        return reference(x, R, v, -omega, p_body);
      }},
     {"arm from the world's origin",
      "Your point circles around the origin of the world. It circles around the centre of mass: "
      "the arm begins there, wherever that is.",
      "Velocity of a point",
      [](const Vec3& x, const Mat3& R, const Vec3& v, const Vec3& omega,
         const Vec3& p_body) -> Vec3 { return v + omega.cross(x + R * p_body); }},
     {"velocity of the centre left out",
      "This is what the spin does alone. The point also moves along with the centre of mass.",
      "Velocity of a point",
      [](const Vec3& x, const Mat3& R, const Vec3&, const Vec3& omega, const Vec3& p_body) {
        return reference(x, R, Vec3::Zero(), omega, p_body);
      }},
     {"spin left out",
      "This is the velocity of the centre of mass. Only if a body does not spin do all its "
      "points move like that.",
      "Velocity of a point",
      [](const Vec3&, const Mat3&, const Vec3& v, const Vec3&, const Vec3&) { return v; }},
     {"ω taken in body axes",
      "You have turned ω by R, as if it came in body axes; or you have computed the cross "
      "product in body axes, with an ω in world axes. Here ω is in world axes already.",
      "Frames of reference",
      [](const Vec3& x, const Mat3& R, const Vec3& v, const Vec3& omega, const Vec3& p_body) {
        return reference(x, R, v, R * omega, p_body);
      }},
     {"ω turned into body axes",
      "You have turned ω into body axes, and the arm into world axes. A cross product needs "
      "both in the same frame, and ω was in world axes already.",
      "Frames of reference",
      [](const Vec3& x, const Mat3& R, const Vec3& v, const Vec3& omega, const Vec3& p_body) {
        return reference(x, R, v, R.transpose() * omega, p_body);
      }},
     {"left in body axes",
      "You have worked out in body axes what the spin does, and added it to v, which is in "
      "world axes. You have not turned it back.",
      "Frames of reference",
      [](const Vec3&, const Mat3& R, const Vec3& v, const Vec3& omega, const Vec3& p_body) -> Vec3 {
        return v + (R.transpose() * omega).cross(p_body);
      }},
     {"place added",
      "You have added the position of the centre of mass to a velocity: metres to metres per "
      "second. How fast a point moves does not depend on where its body is.",
      "Velocity of a point",
      [](const Vec3& x, const Mat3& R, const Vec3& v, const Vec3& omega,
         const Vec3& p_body) -> Vec3 { return x + reference(x, R, v, omega, p_body); }},
     {"digits lost on the way through the world",
      "You have found the arm as the place of the point minus that of the centre. Far from the "
      "origin that difference has few digits left, though you know the arm itself to all of "
      "them.",
      "Far from the origin",
      [](const Vec3& x, const Mat3& R, const Vec3& v, const Vec3& omega,
         const Vec3& p_body) -> Vec3 {
        const Vec3 p = x + R * p_body;
        return v + omega.cross(p - x);
      }}}};
