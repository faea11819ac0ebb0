/// @file
/// 5.3 torque: its laws, and what goes wrong.
#include <cmath>
#include <tuple>

#include "05_momentum/contract.hpp"
#include "judge/spec/spec.hpp"
#include "tumble/body/wrench.hpp"

using namespace tumble::judge;
using tumble::Vec3;

namespace student {
const Function<decltype(momentum::torque)> torque{TUMBLE_UNIT};
}

namespace {

Vec3 reference(const Vec3& force, const Vec3& p, const Vec3& x) {
  return tumble::force_at_point(force, p, x).torque;
}

/// A difference, two products and another difference a number: 3 eps of at most |p − x| |F| on
/// either side.
double rounding(const Vec3& force, const Vec3& p, const Vec3& x) {
  return 8 * eps * (p - x).norm() * force.norm();
}

/// The same for someone who has subtracted later: allowed as long as p and x are near the origin.
double rounding_near_origin(const Vec3& force, const Vec3& p, const Vec3& x) {
  return 8 * eps * (p.norm() + x.norm()) * force.norm();
}

Vec3 any_place() { return any_vector(3); }
Vec3 any_force() { return any_vector(20); }

}  // namespace

TEST_SUITE(TUMBLE_UNIT) {
  TEST_CASE("any force at any point of a body anywhere") {
    for (int n = 0; n < 20; ++n) {
      const Vec3 F = any_force(), p = any_place(), x = any_place();
      REQUIRE(student::torque(F, p, x) ==
              close_to(reference(F, p, x), rounding_near_origin(F, p, x)));
    }
  }

  TEST_CASE("right hand: arm x and force y turn about z, y and z about x, z and x about y") {
    const Vec3 X = Vec3::UnitX(), Y = Vec3::UnitY(), Z = Vec3::UnitZ(), origin = Vec3::Zero();
    for (const auto& [arm, force, axis] :
         {std::tuple(X, Y, Z), std::tuple(Y, Z, X), std::tuple(Z, X, Y)}) {
      REQUIRE(student::torque(3 * force, 2 * arm, origin) == close_to(Vec3(6 * axis), 0));
      REQUIRE(student::torque(3 * arm, 2 * force, origin) == close_to(Vec3(-6 * axis), 0));
    }
  }

  TEST_CASE("the torque is at right angles to the arm and to the force") {
    for (int n = 0; n < 10; ++n) {
      const Vec3 F = any_force(), p = any_place(), x = any_place();
      const auto tau = student::torque(F, p, x);
      // √3 times what a number may be off, and as much again for the products made here.
      const double bound = 4 * rounding_near_origin(F, p, x);
      REQUIRE(tau == obeys("τ · (p − x) = 0", std::abs(tau->dot(p - x)), bound * (p - x).norm()));
      REQUIRE(tau == obeys("τ · F = 0", std::abs(tau->dot(F)), bound * F.norm()));
    }
  }

  TEST_CASE("a force whose line goes through the centre of mass does not turn the body") {
    for (const double stretch : {-30., -1., 0., 1e-3, 7.}) {
      const Vec3 x = any_place(), arm = any_vector(2), p = x + arm, F = stretch * arm;
      // p is rounded: the arm is off by eps of its numbers.
      REQUIRE(student::torque(F, p, x) ==
              close_to(Vec3(Vec3::Zero()), rounding_near_origin(F, p, x)));
    }
    const Vec3 F = any_force(), x = any_place();
    REQUIRE(student::torque(F, x, x) ==
            close_to(Vec3(Vec3::Zero()), rounding_near_origin(F, x, x)));
  }

  TEST_CASE("a force may slide along its own line: the torque stays") {
    for (int n = 0; n < 10; ++n) {
      const Vec3 F = any_force(), p = any_place(), x = any_place();
      const Vec3 slid = p + any_number(-1, 1) * F;
      const auto tau = student::torque(F, p, x);
      REQUIRE(student::torque(F, slid, x) ==
              close_to(tau.value(),
                       rounding_near_origin(F, p, x) + 2 * rounding_near_origin(F, slid, x)));
    }
  }

  TEST_CASE("two opposite forces turn a body as they should, wherever its centre of mass is") {
    for (int n = 0; n < 10; ++n) {
      const Vec3 F = any_force(), p = any_place(), other = any_place(), x = any_place();
      const auto one = student::torque(F, p, x);
      // τ + τ′ = (p − p′) × F, in which x is no longer contained.
      const Vec3 expected = (p - other).cross(F) - one.value();
      const double bound = 2 * (rounding_near_origin(F, p, x) + rounding_near_origin(F, other, x));
      REQUIRE(student::torque(-F, other, x) == close_to(expected, bound));
    }
  }

  TEST_CASE("far from the origin no digit is lost") {
    for (const double far : {1e4, 1e6, 1e8}) {
      for (int n = 0; n < 5; ++n) {
        const Vec3 F = any_force(), x = far * any_direction(), p = x + any_vector(2);
        REQUIRE(student::torque(F, p, x) == close_to(reference(F, p, x), rounding(F, p, x)));
      }
    }
  }

  TEST_CASE("no force, tiny and huge forces, short and long arms") {
    for (const double size : {1e-100, 1e-8, 1e8, 1e100}) {
      for (const double strength : {0., 1e-100, 1e-8, 1e8, 1e100}) {
        const Vec3 F = any_vector(strength), p = any_vector(size), x = any_vector(size);
        REQUIRE(student::torque(F, p, x) ==
                close_to(reference(F, p, x), rounding_near_origin(F, p, x)));
      }
    }
  }
}

const Misconceptions<decltype(momentum::torque)> misconceptions{
    TUMBLE_UNIT,
    {{"turned the other way",
      "Your torque has the wrong sign. Either the factors of the cross product are swapped, or "
      "your arm points from the point to the centre instead of from the centre to the point.",
      "Force and torque",
      [](const Vec3& F, const Vec3& p, const Vec3& x) -> Vec3 { return -reference(F, p, x); }},
     {"about the world's origin",
      "This is the torque about the origin of the world. A free body turns about its centre of "
      "mass, so let the arm begin there.",
      "Force and torque",
      [](const Vec3& F, const Vec3& p, const Vec3&) { return reference(F, p, Vec3::Zero()); }},
     {"centre added to the point",
      "You have added the centre of mass to the point, as if p were measured from the centre. "
      "Here p is a place in the world already.",
      "Frames of reference",
      [](const Vec3& F, const Vec3& p, const Vec3& x) { return reference(F, p, -x); }},
     {"component by component",
      "You have multiplied each component of the arm with the same one of the force. But a "
      "force along the arm does not turn anything: what counts is the part perpendicular to it.",
      "Force and torque",
      [](const Vec3& F, const Vec3& p, const Vec3& x) -> Vec3 { return (p - x).cwiseProduct(F); }},
     {"minus signs forgotten",
      "Each component of a cross product is a difference. You have added the two products.",
      "Force and torque",
      [](const Vec3& F, const Vec3& p, const Vec3& x) -> Vec3 {
        const Vec3 r = p - x;
        return {r.y() * F.z() + r.z() * F.y(), r.z() * F.x() + r.x() * F.z(),
                r.x() * F.y() + r.y() * F.x()};
      }},
     {"sign of y",
      "Your components along x and z are right, and the one along y has the wrong sign. It "
      "begins with z: in a cross product the order is x, y, z, x, y.",
      "Force and torque",
      [](const Vec3& F, const Vec3& p, const Vec3& x) -> Vec3 {
        return reference(F, p, x).cwiseProduct(Vec3(1, -1, 1));
      }},
     {"arm normalised",
      "You have scaled the arm to length 1. A lever twice as long turns twice as hard, so its "
      "length counts.",
      "Force and torque",
      [](const Vec3& F, const Vec3& p, const Vec3& x) -> Vec3 {
        return (p - x).stableNormalized().cross(F);
      }},
     {"digits lost far from the origin",
      "Near the origin you are right. Far from it you subtract two huge numbers that were "
      "rounded before: subtract first to get the arm, and multiply afterwards.",
      "Far from the origin", [](const Vec3& F, const Vec3& p, const Vec3& x) -> Vec3 {
        return p.cross(F) - x.cross(F);
      }}}};
