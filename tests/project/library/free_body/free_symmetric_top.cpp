#include "tumble/free_body/free_symmetric_top.hpp"

#include <doctest/doctest.h>

#include "project/harness/inputs.hpp"
#include "project/harness/refusal.hpp"
#include "project/harness/relative_error.hpp"
#include "tumble/body/derived.hpp"
#include "tumble/body/dydt.hpp"
#include "tumble/ode/dop853.hpp"
#include "tumble/ode/integrate_adaptive.hpp"
#include "tumble/rotation/exp.hpp"

using namespace tumble;
using test::eps;

namespace {

RigidBodyState<> random_state(test::Random& rng) {
  return {rng.vector(), exp_quaternion<double>(3 * rng.vector()), rng.vector(), rng.vector()};
}

/// A top with its axis of symmetry anywhere in the body.
RigidBody<> top(double A, double C, test::Random& rng) {
  const Mat3 R = exp_rotation<double>(3 * rng.vector());
  const Mat3 I = R * Vec3(A, A, C).asDiagonal() * R.transpose();
  return RigidBody<>(2, Mat3((I + I.transpose()) / 2));
}

}  // namespace

TEST_CASE("model_of_moments: by how many moments are equal, and to what tolerance") {
  const auto model = [](double a, double b, double c, double tolerance) {
    return model_of_moments(RigidBody<>(1, Mat3(Vec3(a, b, c).asDiagonal())), tolerance).model;
  };
  CHECK(model(1, 1, 1, 0) == Model::ball);
  CHECK(model(1, 1, 1.5, 0) == Model::symmetric_top);
  CHECK(model(1.5, 1, 1.5, 0) == Model::symmetric_top);
  CHECK(model(1, 1.2, 1.5, 0) == Model::full_body);
  CHECK(model(1, 1.001, 1.5, 1e-4) == Model::full_body);
  CHECK(model(1, 1.001, 1.5, 1e-2) == Model::symmetric_top);
  CHECK(model(1, 1.001, 1.002, 1e-2) == Model::ball);
  CHECK_REFUSED(model(1, 1, 1, -1), "tolerance", "-1");
  CHECK_REFUSED(model(1, 1, 1, NAN), "tolerance", "nan");
}

TEST_CASE("free_symmetric_top: is where the equation of motion goes") {
  test::Random rng(161);
  for (const double C : {0.2, 0.9999, 1.0, 1.9}) {
    CAPTURE(C);
    const RigidBody<> body = top(1, C, rng);
    const RigidBodyState<> start = random_state(rng);
    const auto solution =
        integrate_adaptive<Dop853>(RigidBodyRhs(body), pack(start), 0.0, 10.0, {1e-13, 1e-13});
    const RigidBodyState<> end = free_symmetric_top(body, start, 10);
    CHECK(angle_between(end.q, unpack<double>(solution.y).q) <= solution.steps * 1e-13 * 10);
    CHECK((end.x - unpack<double>(solution.y).x).norm() <= solution.steps * 1e-13 * 10);
    CHECK(end.P == start.P);
    CHECK(end.L == start.L);
  }
}

TEST_CASE("free_symmetric_top: two times after one another are their sum, however long") {
  test::Random rng(162);
  for (const double t : {1e-3, 1.0, 1e3, 1e6}) {
    CAPTURE(t);
    const RigidBody<> body = top(1, 0.5, rng);
    const RigidBodyState<> start = random_state(rng);
    const RigidBodyState<> twice = free_symmetric_top(body, free_symmetric_top(body, start, t), t);
    // Angles of size t are rounded to eps t; the axis found in the body and L·n once each as well.
    CHECK(angle_between(twice.q, free_symmetric_top(body, start, 2 * t).q) <= 64 * eps * (1 + t));
    CHECK(test::relative_error(kinetic_energy(body, twice), kinetic_energy(body, start)) <=
          64 * eps * (1 + t));
  }
}

TEST_CASE("free_symmetric_top: a body without symmetry is refused") {
  const RigidBody<> body(1, Mat3(Vec3(1, 1.1, 1.5).asDiagonal()));
  CHECK_REFUSED(free_symmetric_top(body, RigidBodyState<>{}, 1), "no two principal moments",
                "0.0909091");
}
