/// @file
/// 10.2 free_symmetric_top: its laws, and what goes wrong.
#include "tumble/free_body/free_symmetric_top.hpp"

#include <cmath>

#include "10_only_what_a_scene_needs/contract.hpp"
#include "judge/spec/shared/quaternion_reference.hpp"
#include "judge/spec/spec.hpp"

using namespace tumble::judge;
using only_what_a_scene_needs::Quaternion;
using tumble::Vec3;

namespace student {
const Function<decltype(only_what_a_scene_needs::free_symmetric_top)> free_symmetric_top{
    TUMBLE_UNIT};
}

namespace {

const Vec3 z_axis = Vec3::UnitZ();

/// The turn by the angle |w| about w.
Quaternion turn(const Vec3& w) { return tumble::coefficients(tumble::exp_quaternion<double>(w)); }

/// The body's axis of symmetry in the world.
Vec3 axis_of(const Quaternion& q) { return reference::rotate(q, z_axis); }

Quaternion product(const Quaternion& a, const Quaternion& q, const Quaternion& b) {
  return reference::product(reference::product(a, q), b);
}

/// (1/C − 1/A) L·n: how fast the body turns about its own axis, besides the turn about L.
double own_rate(double A, double C, const Quaternion& q0, const Vec3& L) {
  return (1 / C - 1 / A) * L.dot(axis_of(q0));
}

Quaternion right(double A, double C, const Quaternion& q0, const Vec3& L, double t) {
  const Quaternion about_z = turn(t * own_rate(A, C, q0, L) * z_axis);
  return product(turn(t / A * L), q0, about_z);
}

/// The angle of turning about L takes 8 roundings of itself, that about the axis 60 of the largest
/// that it can be: L·n and 1/C − 1/A may nearly cancel. Half of it goes into the quaternion. The
/// products take 32 roundings of 1. All on either side.
double rounding(double A, double C, const Vec3& L, double t) {
  return (64 + 64 * std::abs(t) * L.norm() * (1 / A + 1 / C)) * eps;
}

/// A top, and how it starts.
struct Top {
  double A = any_number(1, 2);
  double C = any_number(0.4, 0.8) * A;
  Quaternion q0 = any_unit_quaternion();
  Vec3 L = any_vector(3);

  Vec3 omega(const Quaternion& q) const { return L / A + own_rate(A, C, q, L) * axis_of(q); }
};

/// One that is flat.
Top any_disc() {
  Top top;
  top.C = any_number(1.3, 2) * top.A;
  return top;
}

Answer<Quaternion> ask(const Top& top, double t) {
  return student::free_symmetric_top(top.A, top.C, top.q0, top.L, t);
}
Quaternion right(const Top& top, double t) { return right(top.A, top.C, top.q0, top.L, t); }
double rounding(const Top& top, double t) { return rounding(top.A, top.C, top.L, t); }

/// −q where that is nearer to `other`.
Quaternion nearer(const Quaternion& q, const Quaternion& other) {
  return q.dot(other) < 0 ? Quaternion(-q) : q;
}

}  // namespace

TEST_SUITE(TUMBLE_UNIT) {
  TEST_CASE("any top, long or flat, at any time") {
    for (int n = 0; n < 30; ++n) {
      const Top top = n % 2 ? any_disc() : Top{};
      const double time = any_number(0.5, 3);
      const double t = n < 10 ? time : -time;  // so that who forgets the sign is right at first
      REQUIRE(ask(top, t) == same_rotation(right(top, t), rounding(top, t)));
    }
  }

  TEST_CASE("as the library has it, which finds the axis and the moments by itself") {
    for (int n = 0; n < 10; ++n) {
      const Top top = n % 2 ? any_disc() : Top{};
      const double t = any_number(-3, 3);
      const tumble::RigidBody<> body(1, Vec3(top.A, top.A, top.C).asDiagonal());
      const tumble::RigidBodyState<> start{
          Vec3::Zero(), reference::from_coefficients<double>(top.q0), Vec3::Zero(), top.L};
      const auto end = tumble::free_symmetric_top(body, start, t);
      // Its moments are off by up to 6 roundings.
      REQUIRE(ask(top, t) == same_rotation(tumble::coefficients(end.q), 2 * rounding(top, t)));
    }
  }

  TEST_CASE("the right turn: the axis goes round L at the rate |L|/A and keeps its angle to L") {
    for (int n = 0; n < 10; ++n) {
      const Top top = n % 2 ? any_disc() : Top{};
      const double t = any_number(-5, 5);
      const auto q = ask(top, t);
      REQUIRE(q == same_rotation(right(top, t), rounding(top, t)));
      const Vec3 before = axis_of(top.q0), now = axis_of(q);
      // A quaternion off by δ in each number turns a point by up to 4 δ.
      REQUIRE(q == obeys("L·n stays", std::abs(top.L.dot(now) - top.L.dot(before)),
                         8 * rounding(top, t) * top.L.norm()));
      const Vec3 expected = reference::rotate(turn(t / top.A * top.L), before);
      REQUIRE(q == obeys("n goes round L at the rate |L|/A", (now - expected).norm(),
                         8 * rounding(top, t)));
    }
  }

  TEST_CASE("at every moment it turns at the ω that belongs to L: q̇ = ½⟨0, ω⟩q") {
    for (int n = 0; n < 10; ++n) {
      const Top top = n % 2 ? any_disc() : Top{};
      const double t = any_number(-3, 3), h = 0x1p-13;
      const auto q = ask(top, t), after = ask(top, t + h), before = ask(top, t - h);
      const Quaternion slope = (nearer(after, q) - nearer(before, q)) / (2 * h);
      const Quaternion expected = reference::quaternion_dot(q, top.omega(q));
      // A central difference misses h²/6 times the third derivative of two turns.
      const double speed = top.L.norm() * (1 / top.A + 1 / top.C);
      REQUIRE(q == obeys("q̇ = ½⟨0, ω⟩q", (slope - expected).norm(),
                         h * h / 6 * speed * speed * speed + 4 * rounding(top, t) / h));
    }
  }

  TEST_CASE("from here to there and on is one right flight: the clock may be set to 0 on the way") {
    for (int n = 0; n < 10; ++n) {
      Top top = n % 2 ? any_disc() : Top{};
      const double first = any_number(-3, 3), second = any_number(-3, 3);
      const auto at_once = ask(top, first + second);
      const double bound = 4 * (rounding(top, first) + rounding(top, second));
      top.q0 = ask(top, first);
      REQUIRE(ask(top, second) == same_rotation(at_once.value(), bound));
      REQUIRE(ask(top, second) == same_rotation(right(top, second), rounding(top, second)));
    }
  }

  TEST_CASE("a ball turns about L; with L along or across its axis a top does so too") {
    for (int n = 0; n < 10; ++n) {
      Top top = n % 2 ? any_disc() : Top{};
      const double t = any_number(-3, 3), size = any_number(-3, 3);
      const Vec3 axis = axis_of(top.q0);
      top.L = size * axis;
      Quaternion expected = reference::product(turn(t / top.C * top.L), top.q0);
      REQUIRE(ask(top, t) == same_rotation(expected, 2 * rounding(top, t)));
      top.L = any_direction().cross(axis);
      expected = reference::product(turn(t / top.A * top.L), top.q0);
      REQUIRE(ask(top, t) == same_rotation(expected, 2 * rounding(top, t)));
      top.C = top.A;
      top.L = any_vector(3);
      expected = reference::product(turn(t / top.A * top.L), top.q0);
      REQUIRE(ask(top, t) == same_rotation(expected, 2 * rounding(top, t)));
    }
  }

  TEST_CASE("at rest and at time 0 nothing has turned, and from −q0 the flight is right, too") {
    for (const double t : {0., 1., -1e6}) {
      Top top;
      REQUIRE(ask(top, 0) == same_rotation(top.q0, rounding(top, 0)));
      const Quaternion end = right(top, t);
      top.q0 = -top.q0;
      REQUIRE(ask(top, t) == same_rotation(end, rounding(top, t)));
      top.L.setZero();
      REQUIRE(ask(top, t) == same_rotation(top.q0, rounding(top, t)));
    }
  }

  TEST_CASE("a needle, nearly a ball, 10000 rad/s, a million seconds, specks of dust and planets") {
    for (const double ratio : {1e-6, 1 - 1e-9, 1 + 1e-9, 2.}) {
      Top top;
      top.C = ratio * top.A;
      const double t = any_number(-3, 3);
      REQUIRE(ask(top, t) == same_rotation(right(top, t), rounding(top, t)));
      REQUIRE(ask(top, 1e6) == same_rotation(right(top, 1e6), rounding(top, 1e6)));
      top.L *= 1e4;
      REQUIRE(ask(top, t) == same_rotation(right(top, t), rounding(top, t)));
    }
    for (const double size : {1e-40, 1e-8, 1e8, 1e40}) {
      Top top;
      const double t = any_number(-3, 3);
      const Quaternion expected = right(top, t);
      top.A *= size;
      top.C *= size;
      top.L *= size;
      REQUIRE(ask(top, t) == same_rotation(expected, 2 * rounding(top, t)));
    }
  }
}

const Misconceptions<decltype(only_what_a_scene_needs::free_symmetric_top)> misconceptions{
    TUMBLE_UNIT,
    {{"ω held fast",
      "You turned the body about the ω that it starts with. Nothing pushes, so L stays; but ω goes "
      "round with the body's axis.",
      "The free symmetric top",
      [](double A, double C, const Quaternion& q0, const Vec3& L, double t) {
        const Vec3 omega = L / A + own_rate(A, C, q0, L) * axis_of(q0);
        return reference::product(turn(t * omega), q0);
      }},
     {"only the turn about L",
      "You carried the body round L at the right rate, but it also turns about its own axis. Only "
      "a ball does not.",
      "The free symmetric top",
      [](double A, double, const Quaternion& q0, const Vec3& L, double t) {
        return reference::product(turn(t / A * L), q0);
      }},
     {"only the turn about the own axis",
      "Your body spins about its own axis, but that axis stands still. It goes round L.",
      "The free symmetric top",
      [](double A, double C, const Quaternion& q0, const Vec3& L, double t) {
        return reference::product(q0, turn(t * own_rate(A, C, q0, L) * z_axis));
      }},
     {"whole spin about the own axis",
      "You turned the body about its own axis at the full (L·n)/C. The turn about L already has a "
      "part along this axis, so you counted that part twice.",
      "The free symmetric top",
      [](double A, double C, const Quaternion& q0, const Vec3& L, double t) {
        const double rate = L.dot(axis_of(q0)) / C;
        return product(turn(t / A * L), q0, turn(t * rate * z_axis));
      }},
     {"own turn backwards",
      "Your turn about the own axis has the wrong sign: you took the difference of the two inverse "
      "moments the wrong way round.",
      "The free symmetric top",
      [](double A, double C, const Quaternion& q0, const Vec3& L, double t) {
        return product(turn(t / A * L), q0, turn(-t * own_rate(A, C, q0, L) * z_axis));
      }},
     {"moments swapped",
      "You swapped A and C, which makes a coin of a pencil and a pencil of a coin. C belongs to "
      "the axis of symmetry.",
      "The free symmetric top",
      [](double A, double C, const Quaternion& q0, const Vec3& L, double t) {
        return right(C, A, q0, L, t);
      }},
     {"turn about L at |L|/C",
      "Your axis goes round L at a rate that has C in it. All of ω that is not along the axis "
      "belongs to A, the moment perpendicular to it.",
      "The free symmetric top",
      [](double A, double C, const Quaternion& q0, const Vec3& L, double t) {
        return product(turn(t / C * L), q0, turn(t * own_rate(A, C, q0, L) * z_axis));
      }},
     {"difference of moments, not of their inverses",
      "You gave the turn about the own axis the rate of C − A. Rates are L over a moment, so it is "
      "the difference of the inverses that counts.",
      "The free symmetric top",
      [](double A, double C, const Quaternion& q0, const Vec3& L, double t) {
        const double rate = (A - C) * L.dot(axis_of(q0));
        return product(turn(t / A * L), q0, turn(t * rate * z_axis));
      }},
     {"factors swapped",
      "You put the turn about L on the right of q0 and the own turn on its left. What stays in the "
      "world is a factor on the left, what stays in the body one on the right.",
      "Frames of reference",
      [](double A, double C, const Quaternion& q0, const Vec3& L, double t) {
        return product(turn(t * own_rate(A, C, q0, L) * z_axis), q0, turn(t / A * L));
      }},
     {"own turn about the world's z axis",
      "You put both turns on the left of q0, so the second one is about the world's z axis. The "
      "axis of symmetry is painted on the body.",
      "Frames of reference",
      [](double A, double C, const Quaternion& q0, const Vec3& L, double t) {
        return product(turn(t / A * L), turn(t * own_rate(A, C, q0, L) * z_axis), q0);
      }},
     {"z of the world for the axis",
      "For the part of L along the axis you took L's z component. L is in world axes, and the "
      "body's z axis points elsewhere in the world.",
      "Frames of reference",
      [](double A, double C, const Quaternion& q0, const Vec3& L, double t) {
        const double rate = (1 / C - 1 / A) * L.z();
        return product(turn(t / A * L), q0, turn(t * rate * z_axis));
      }},
     {"angles not halved",
      "Your body turns twice as far as the true one. A quaternion holds half of the angle.",
      "One top by hand",
      [](double A, double C, const Quaternion& q0, const Vec3& L, double t) {
        return right(A, C, q0, L, 2 * t);
      }},
     {"backwards in time",
      "You found where the body was, not where it will be: all your turns have the wrong sense.",
      "The free symmetric top",
      [](double A, double C, const Quaternion& q0, const Vec3& L, double t) {
        return right(A, C, q0, L, -t);
      }},
     {"time without its sign",
      "For negative times your body goes on into the future. The closed form tells what was before "
      "as well.",
      "Nothing pushes, no steps",
      [](double A, double C, const Quaternion& q0, const Vec3& L, double t) {
        return right(A, C, q0, L, std::abs(t));
      }},
     {"zero over zero",
      "Where L is zero it has no direction, and you divide by its length. Nothing turns there.",
      "Nothing pushes, no steps",
      [](double A, double C, const Quaternion& q0, const Vec3& L, double t) {
        const Vec3 u = L / L.norm();
        return product(turn(t * L.norm() / A * u), q0, turn(t * own_rate(A, C, q0, L) * z_axis));
      }}}};
