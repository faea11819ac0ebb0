// Dust and moons: bodies of any mass, in any units, anywhere.
#include <doctest/doctest.h>

#include "tumble/ode/integrate_fixed.hpp"
#include "tumble/ode/rk4.hpp"
#include "tumble/simulate/simulate.hpp"
#include "turning.hpp"

using namespace tumble;
using test::eps;

namespace {

PackedState<double> rk4(const RigidBody<>& body, const RigidBodyState<>& start, double duration,
                        int steps) {
  return integrate_fixed<Rk4>(RigidBodyRhs(body), pack(start), 0.0, duration, steps);
}

}  // namespace

TEST_CASE("units: they do not matter, to the last bit") {
  const Mat3 I = Vec3(1, 2, 2.5).asDiagonal();
  const RigidBodyState<> start{Vec3(1, 2, 3), exp_quaternion(Vec3(1, 2, 3)), Vec3(1, 0, 2),
                               Vec3(1, 2, 0.5)};
  const PackedState<double> y = rk4(RigidBody<>(1, I), start, 10, 100);
  for (const int exponent : {-200, -60, 60, 200}) {
    CAPTURE(exponent);
    const double scale = std::ldexp(1.0, exponent);  // a power of two: exact in every product
    RigidBodyState<> scaled = start;
    scaled.P *= scale;
    scaled.L *= scale;
    const PackedState<double> z = rk4(RigidBody<>(scale, Mat3(scale * I)), scaled, 10, 100);
    CHECK(z.head<7>() == y.head<7>());
    CHECK(z.tail<6>() / scale == y.tail<6>());
  }
}

TEST_CASE("units: 1e8 m from the origin a body turns the same, to the last bit") {
  const RigidBody<> body(1, Mat3(Vec3(1, 2, 2.5).asDiagonal()));
  const RigidBodyState<> near_start{Vec3::Zero(), exp_quaternion(Vec3(1, 2, 3)), Vec3(1, 0, 2),
                                    Vec3(1, 2, 0.5)};
  RigidBodyState<> far_start = near_start;
  far_start.x = Vec3(1e8, -1e8, 1e8);
  const RigidBodyState<> here = unpack<double>(rk4(body, near_start, 10, 100));
  const RigidBodyState<> there = unpack<double>(rk4(body, far_start, 10, 100));
  CHECK(there.q.coeffs() == here.q.coeffs());
  CHECK(there.L == here.L);
  // Each of 100 steps rounds x to a multiple of 1.5e-8 m; half a unit at most, several additions.
  CHECK((there.x - far_start.x - here.x).norm() <= 100 * 4 * eps * 1e8);
}

TEST_CASE("units: 1e-9 kg and 1e12 kg go where 1 kg goes, free, pulled at, and on a spring") {
  const Vec3 omega(1, 1, 2), J(1, 2, 3);
  const auto end = [&](double mass, const auto&... forces) {
    const RigidBodyState<> start = test::turning(mass * J, omega);
    const Trajectory motion =
        simulate(test::body_with(mass * J, mass), start, {0, 10, 1e-9}, forces...);
    CHECK(motion.report().reached());
    return motion.end();
  };
  const auto pull = [](double mass) {
    return ForceAtBodyPoint{mass * Vec3(0, 0, -5), Vec3(0.6, 0, 0.8)};
  };
  const auto spring = [](double mass) {
    return SpringToWorld{Vec3(0.6, 0, 0.8), Vec3(0, 0, 2), 10 * mass, 1};
  };
  const RigidBodyState<> start = test::turning(J, omega);
  const Quat free = reference::turned({J, start.q, start.L}, 10).q,
             pulled = reference::turned({J, start.q, start.L, pull(1).force, pull(1).p_body}, 10).q;
  const RigidBodyState<> sprung = end(1, spring(1));
  for (const double mass : {1e-9, 1e12}) {
    CAPTURE(mass);
    CHECK(angle_between(end(mass).q, free) <= 1e-13);
    CHECK(angle_between(end(mass, pull(mass)).q, pulled) <= 1e-9);
    CHECK(angle_between(end(mass, spring(mass)).q, sprung.q) <= 2e-9);
    CHECK((end(mass, spring(mass)).x - sprung.x).norm() <= 2e-9 * 10);
  }
}
