#include "tumble/contact/flight.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "project/harness/inputs.hpp"
#include "tumble/free_body/free_trajectory.hpp"

using namespace tumble;

TEST_CASE("Flight: the free body's turning over a parabola, and bounds that hold and are near") {
  test::Random rng(1141);
  double loosest = 0;
  for (int i = 0; i < 300; ++i) {
    const double a = std::pow(10, rng.uniform(-2, 0)), b = rng.uniform(0.1, 1);
    const Vec3 squares = i % 4 ? Vec3(a * a, b * b, rng.uniform(0.1, 1)) : Vec3(a * a, 1, 1);
    const Mat3 turned = rng.rotation().toRotationMatrix();
    const Vec3 moments = Vec3::Constant(squares.sum()) - squares;
    const RigidBody<> body(2, Mat3(turned * moments.asDiagonal() * turned.transpose()));
    Vec3 omega = 5 * rng.vector();
    if (i % 5 == 0) omega = turned * (Vec3::UnitY() + 1e-6 * rng.vector());  // near an axis
    const auto start =
        state_of_motion<double>(body, rng.vector(), Quat::Identity(), rng.vector(), omega);
    const Vec3 g(0, 1, -9);
    const contact::Flight flight(body, start, g, 2);
    const FreeTrajectory free(body, start);
    double spin = 0, faster = 0;
    for (int k = 0; k < 300; ++k) {
      const double t = 2 + 0.1 * k, s = t - 2;
      const Derived<> now = flight.at(t);
      CHECK((now.x - free.at(s).x - s * s / 2 * g).norm() < 1e-12 * (1 + s * s));
      CHECK((now.R - to_matrix(free.at(s).q)).norm() < 1e-13 * (1 + 100 * s));
      CHECK((derived(body, flight.state(t)).omega - now.omega).norm() < 1e-11);
      const Vec3 w = now.R.transpose() * now.omega;
      const Vec3 acceleration = body.I_body_inv() * (body.I_body() * w).cross(w);
      spin = std::max(spin, w.norm());
      faster = std::max(faster, acceleration.norm());
    }
    CHECK(flight.most_spin() >= spin);
    CHECK(flight.most_angular_acceleration() >= faster);
    loosest = std::max(loosest, (flight.most_spin() * spin + flight.most_angular_acceleration()) /
                                    (spin * spin + faster));
  }
  CHECK(loosest < 10);
}

TEST_CASE("Flight: a body that does not turn has no bound to turn by") {
  const RigidBody<> body(1, Mat3(Vec3(1, 2, 2.5).asDiagonal()));
  const contact::Flight flight(body, {}, Vec3::Zero(), 0);
  CHECK(flight.most_spin() == 0);
  CHECK(flight.most_angular_acceleration() == 0);
  CHECK(flight.at(7).x.isZero(0));
}
