/// @file
/// 11.4 contact_matrix: its laws, and what goes wrong.
#include "tumble/contact/contact_matrix.hpp"

#include <cmath>
#include <limits>

#include "11_when_bodies_meet/contract.hpp"
#include "judge/spec/shared/impacts.hpp"
#include "judge/spec/spec.hpp"

using namespace impacts;

namespace student {
const Function<decltype(when_bodies_meet::contact_matrix)> contact_matrix{TUMBLE_UNIT};
}

namespace {

/// What a question consists of. The arm has a length of 0.3 m or more.
struct Place {
  Body body = any_body();
  State state = any_unit_state();
  double length = any_number(0.3, 2);
  Vec3 point = state.x + length * any_direction();

  Vec3 arm() const { return point - state.x; }
};

Answer<Mat3> ask(const Place& p) { return student::contact_matrix(p.body, p.state, p.point); }
Mat3 right(const Place& p) { return contact_matrix(p.body, p.state, p.point); }

/// R as a matrix is off by up to 66 eps, so I⁻¹ in the world by some 140 and K by some 150 of the
/// largest that its turning part can be; the length of q adds 16. On either side.
double rounding(const Place& p) {
  return eps * (8 / p.body.mass + 400 * p.body.I_body_inv.norm() * p.arm().squaredNorm());
}

Place at_rest() {
  Place place;
  place.state.P.setZero();
  place.state.L.setZero();
  return place;
}

/// The right K, but for what `law` makes of I⁻¹ in the world.
template <class Law>
auto with_inverse(Law law) {
  return [law](const Body& body, const State& state, const Vec3& point) -> Mat3 {
    return contact_matrix(body.mass, law(body, reference::to_matrix(state.q)), point - state.x);
  };
}

/// The right K, but for what `law` makes of its turning part.
template <class Law>
auto with_turning(Law law) {
  return [law](const Body& body, const State& state, const Vec3& point) -> Mat3 {
    const Mat3 straight = Mat3::Identity() / body.mass;
    return straight + law(Mat3(contact_matrix(body, state, point) - straight), body);
  };
}

}  // namespace

TEST_SUITE(TUMBLE_UNIT) {
  TEST_CASE("any body, turned and moving somehow, hit at any point") {
    for (int n = 0; n < 30; ++n) {
      const Place place;
      REQUIRE(ask(place) == close_to(right(place), rounding(place)));
    }
  }

  TEST_CASE(
      "its columns are the velocities that unit impulses give to the point of a body at rest") {
    for (int n = 0; n < 10; ++n) {
      const Place place = at_rest();
      const auto K = ask(place);
      REQUIRE(K == close_to(right(place), rounding(place)));
      for (int k = 0; k < 3; ++k) {
        const State after = after_impulse(place.state, Vec3::Unit(k), place.point);
        const Vec3 change = velocity_at(place.body, after, place.point);
        REQUIRE(K == obeys("column k is the change of velocity that an impulse along axis k makes",
                           (K->col(k) - change).norm(), 4 * rounding(place)));
      }
    }
  }

  TEST_CASE("as the library has it, which inverts the tensor by itself") {
    for (int n = 0; n < 10; ++n) {
      const Place place;
      const tumble::RigidBody<> body(place.body.mass, place.body.I_body);
      const Mat3 R = reference::to_matrix(place.state.q);
      const tumble::Derived<> now{place.state.x, R, Vec3::Zero(), Vec3::Zero()};
      REQUIRE(ask(place) == close_to(tumble::contact::contact_matrix(body, now, place.point),
                                     2 * rounding(place)));
    }
  }

  TEST_CASE("the right K, symmetric to the last bit; an impulse never pulls its own point back") {
    for (int n = 0; n < 20; ++n) {
      const Place place;
      const auto K = ask(place);
      REQUIRE(K == close_to(right(place), rounding(place)));
      REQUIRE(K == obeys("K is symmetric to the last bit",
                         (K.value() - K.value().transpose()).cwiseAbs().maxCoeff(), 0));
      const Vec3 d = any_direction();
      REQUIRE(K == obeys("d·K d is at least 1/m, in every direction d of length 1",
                         1 / place.body.mass - d.dot(K.value() * d), 4 * rounding(place)));
    }
  }

  TEST_CASE("the right K; an impulse at the centre, or along the arm, doesn't turn the body") {
    for (int n = 0; n < 5; ++n) {
      Place place;
      const auto K = ask(place);
      REQUIRE(K == close_to(right(place), rounding(place)));
      const Vec3 along = place.arm().normalized();
      REQUIRE(K == obeys("K r = r/m, with r the arm",
                         (K.value() * along - along / place.body.mass).norm(),
                         4 * rounding(place)));
      place.point = place.state.x;
      REQUIRE(ask(place) == close_to(right(place), 4 * eps / place.body.mass));
    }
  }

  TEST_CASE("the right K at any velocity, and wherever in the world body and point are") {
    for (const double distance : {1., 1e4, 1e8}) {
      Place place;
      const auto K = ask(place);
      REQUIRE(K == close_to(right(place), rounding(place)));
      place.state.P = any_vector(100);
      place.state.L = any_vector(100);
      const Vec3 arm = place.arm();
      place.state.x = distance * any_direction();
      place.point = place.state.x + arm;  // rounded; what counts is the arm that is left
      REQUIRE(ask(place) == close_to(right(place), rounding(place)));
    }
  }

  TEST_CASE("body, point and world turned together turn K, and it is the right one") {
    for (int n = 0; n < 5; ++n) {
      Place place;
      const auto K = ask(place);
      const Quaternion turn = any_unit_quaternion();
      const Mat3 T = reference::to_matrix(turn);
      const Mat3 expected = T * K.value() * T.transpose();
      place.point = T * place.point;
      place.state.x = T * place.state.x;
      place.state.q = reference::product(turn, place.state.q);
      // The turned places are rounded.
      const double places = 16 * eps * place.body.I_body_inv.norm() * place.arm().norm() *
                            (place.point.norm() + place.state.x.norm());
      REQUIRE(ask(place) == close_to(expected, 4 * rounding(place) + 4 * places));
      REQUIRE(ask(place) == close_to(right(place), rounding(place)));
    }
  }

  TEST_CASE("nothing moves a wall: its K is zero") {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    for (int n = 0; n < 3; ++n) {
      Place wall = at_rest();
      wall.body.mass = infinite;
      wall.body.I_body.setZero();
      wall.body.I_body.diagonal().setConstant(infinite);
      wall.body.I_body_inv.setZero();
      REQUIRE(ask(wall) == close_to(Mat3(Mat3::Zero()), 0));
    }
  }

  TEST_CASE("specks of dust and planets") {
    for (const double mass : {1e-18, 1e24})
      for (const double length : {1e-12, 1e-6, 1e7}) {
        Place place;
        place.body.mass *= mass;
        place.body.I_body *= mass * length * length;
        place.body.I_body_inv /= mass * length * length;
        place.state.x *= length;
        place.point *= length;
        REQUIRE(ask(place) == close_to(right(place), rounding(place)));
      }
  }
}

const Misconceptions<decltype(when_bodies_meet::contact_matrix)> misconceptions{
    TUMBLE_UNIT,
    {{"turning subtracted",
      "Your impulse pulls the point back by turning the body. The turn that it makes always helps "
      "the point along: look at the sign of one of your cross products.",
      "How a point responds to an impulse",
      with_turning([](const Mat3& turning, const Body&) -> Mat3 { return -turning; })},
     {"turning forgotten",
      "You treated the body as a particle. An impulse beside the centre of mass turns the body as "
      "well, and the turn moves the point.",
      "How a point responds to an impulse",
      with_turning([](const Mat3&, const Body&) -> Mat3 { return Mat3::Zero(); })},
     {"turning counted twice",
      "Your turning part is twice too large. A sum with the transpose is "
      "symmetric, but only half of it is the mean.",
      "How a point responds to an impulse",
      with_turning([](const Mat3& turning, const Body&) -> Mat3 { return 2 * turning; })},
     {"1/m everywhere",
      "You have added 1/m to all nine numbers. An impulse moves the centre of mass along itself "
      "only: 1/m belongs on the diagonal.",
      "How a point responds to an impulse",
      with_turning([](const Mat3& turning, const Body& body) -> Mat3 {
        const Mat3 everywhere = Mat3::Constant(1 / body.mass);
        return turning + everywhere - Mat3(everywhere.diagonal().asDiagonal());
      })},
     {"turning divided by the mass",
      "You have divided all of K by the mass. The inverse tensor has the mass in it already.",
      "How a point responds to an impulse",
      with_turning(
          [](const Mat3& turning, const Body& body) -> Mat3 { return turning / body.mass; })},
     {"only the turning",
      "You left out that the impulse moves the centre of mass, too. Your body turns as if it were "
      "nailed to the world there.",
      "How a point responds to an impulse",
      with_turning([](const Mat3& turning, const Body& body) -> Mat3 {
        return turning - Mat3::Identity() / body.mass;
      })},
     {"multiplied by the mass",
      "You multiplied by the mass where you have to divide by it: a heavier body answers less.",
      "How a point responds to an impulse",
      with_turning([](const Mat3& turning, const Body& body) -> Mat3 {
        return turning + Mat3::Identity() * (body.mass - 1 / body.mass);
      })},
     {"not symmetric to the last bit",
      "Your K is right up to rounding, but two numbers that mirror each other differ in their last "
      "bits. Make both from the same mean. If you write that in place, K = (K + K.transpose()) / "
      "2, Eigen overwrites numbers that it still needs: evaluate the right side first.",
      "How a point responds to an impulse",
      [](const Body& body, const State& state, const Vec3& point) -> Mat3 {
        Mat3 K = contact_matrix(body, state, point);
        K(0, 1) *= 1 + 2 * eps;
        return K;
      }},
     {"arm from the origin",
      "You took the arm from the origin of the world. A body turns about its centre of mass, so "
      "the arm goes from there to the point.",
      "How a point responds to an impulse",
      [](const Body& body, const State& state, const Vec3& point) -> Mat3 {
        return contact_matrix(body.mass, inverse_in_world(body, state), point);
      }},
     {"body tensor used in the world",
      "You used the inverse tensor as the body has it. The arm is in world axes, so the tensor "
      "must be, too.",
      "How a point responds to an impulse",
      with_inverse([](const Body& body, const Mat3&) -> Mat3 { return body.I_body_inv; })},
     {"turned the wrong way",
      "You turned the inverse tensor from the world into the body. It is in body axes, and you "
      "need it in those of the world: swap R and its transpose.",
      "How a point responds to an impulse",
      with_inverse([](const Body& body, const Mat3& R) -> Mat3 {
        return R.transpose() * body.I_body_inv * R;
      })},
     {"turned twice the same way",
      "R is on both sides of your tensor. What turns a vector into body axes has to undo what "
      "turns it out of them.",
      "How a point responds to an impulse",
      with_inverse(
          [](const Body& body, const Mat3& R) -> Mat3 { return R * body.I_body_inv * R; })},
     {"arm in body axes",
      "You have turned the arm into body axes, and the inverse tensor into those of the world. A "
      "product needs both in the same frame.",
      "How a point responds to an impulse",
      [](const Body& body, const State& state, const Vec3& point) -> Mat3 {
        const Vec3 arm = reference::to_matrix(state.q).transpose() * (point - state.x);
        return contact_matrix(body.mass, inverse_in_world(body, state), arm);
      }},
     {"tensor for its inverse",
      "You used the inertia tensor where its inverse belongs. The harder a body is to turn, the "
      "less its point moves.",
      "How a point responds to an impulse",
      with_inverse(
          [](const Body& body, const Mat3& R) -> Mat3 { return R * body.I_body * R.transpose(); })},
     {"diagonal only",
      "You used only the diagonal of the inverse tensor. The body's axes need not be its principal "
      "axes.",
      "How a point responds to an impulse",
      with_inverse([](const Body& body, const Mat3& R) -> Mat3 {
        return R * body.I_body_inv.diagonal().asDiagonal() * R.transpose();
      })},
     {"left in body axes",
      "Your K is in the body's axes. Impulses and velocities are in those of the world.",
      "How a point responds to an impulse",
      [](const Body& body, const State& state, const Vec3& point) -> Mat3 {
        const Mat3 R = reference::to_matrix(state.q);
        return contact_matrix(body.mass, body.I_body_inv, R.transpose() * (point - state.x));
      }},
     {"square of the arm's length",
      "You multiplied the inverse tensor by the square of the arm's length. That is right at best "
      "for a ball, and an impulse perpendicular to the arm: take the two cross products.",
      "How a point responds to an impulse",
      [](const Body& body, const State& state, const Vec3& point) -> Mat3 {
        return Mat3::Identity() / body.mass +
               (point - state.x).squaredNorm() * inverse_in_world(body, state);
      }},
     {"one cross product",
      "You found how the impulse turns the body, but not yet how this moves the point. That takes "
      "a second cross product with the arm.",
      "How a point responds to an impulse",
      [](const Body& body, const State& state, const Vec3& point) -> Mat3 {
        const Mat3 cross = tumble::rotation::skew<double>(point - state.x);
        return Mat3::Identity() / body.mass + inverse_in_world(body, state) * cross;
      }}}};
