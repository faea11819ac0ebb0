#include "tumble/body/many_bodies.hpp"

#include <doctest/doctest.h>

#include "project/harness/inputs.hpp"
#include "project/harness/refusal.hpp"
#include "tumble/body/dydt.hpp"
#include "tumble/ode/dop853.hpp"
#include "tumble/ode/integrate_adaptive.hpp"
#include "tumble/quaternion/exp_log.hpp"

using namespace tumble;
using test::eps;

namespace {

std::vector<RigidBody<double>> two_bodies() {
  return {RigidBody<>(2, Mat3(Vec3(1, 2, 2.5).asDiagonal())),
          RigidBody<>(3, Mat3(Vec3(2, 1, 1.5).asDiagonal()))};
}

std::vector<RigidBodyState<double>> two_states(test::Random& rng) {
  std::vector<RigidBodyState<double>> states;
  for (int i = 0; i < 2; ++i)
    states.push_back(
        {3 * rng.vector(), exp_quaternion<double>(3 * rng.vector()), rng.vector(), rng.vector()});
  return states;
}

/// A spring of 5 N/m without rest length between a corner of the first and one of the second body.
struct SpringBetween {
  Vec3 p0 = Vec3(0.5, 0, 0.2), p1 = Vec3(-0.1, 0.4, 0);
  void operator()(double, std::span<const RigidBody<double>>, std::span<const Derived<double>> now,
                  std::span<Wrench<double>> net) const {
    const Vec3 a = point_position(now[0], p0), b = point_position(now[1], p1);
    net[0] += force_at_point<double>(5 * (b - a), a, now[0].x);
    net[1] += force_at_point<double>(5 * (a - b), b, now[1].x);
  }
  double energy(const Derived<>& d0, const Derived<>& d1) const {
    return 2.5 * (point_position(d0, p0) - point_position(d1, p1)).squaredNorm();
  }
};

}  // namespace

static_assert(detail::SceneForce<SpringBetween, double> && !BodyForce<SpringBetween, double>);
static_assert(OdeRhs<SceneRhs<double, Weight, SpringBetween>, detail::PackedScene<double>>);

TEST_CASE("SceneRhs: bodies that do not meet move as if alone, bit for bit") {
  test::Random rng(151);
  const std::vector<RigidBodyState<>> states = two_states(rng);
  const SceneRhs scene(two_bodies(), Weight{});
  const detail::PackedScene<double> rate = scene(0, pack(states));
  REQUIRE(rate.size() == 26);
  for (std::size_t i = 0; i < 2; ++i) {
    const PackedState<double> alone = RigidBodyRhs(scene.bodies()[i], Weight{})(0, pack(states[i]));
    CHECK(PackedState<double>(rate.segment<13>(13 * static_cast<int>(i))) == alone);
  }
}

TEST_CASE(
    "SceneRhs: a spring between two bodies keeps total momentum, angular momentum and energy") {
  test::Random rng(152);
  const std::vector<RigidBodyState<>> start = two_states(rng);
  const SceneRhs scene(two_bodies(), SpringBetween{});
  const detail::PackedScene<double> y =
      integrate_adaptive<Dop853>(scene, pack(start), 0.0, 10.0, {1e-13, 1e-13}).y;
  const std::vector<RigidBodyState<>> end = unpack<double>(y);
  const auto total = [&](const std::vector<RigidBodyState<>>& s) {
    Eigen::Matrix<double, 7, 1> sum = Eigen::Matrix<double, 7, 1>::Zero();
    for (std::size_t i = 0; i < 2; ++i) {
      sum.head<3>() += s[i].P;
      sum.segment<3>(3) += s[i].L + s[i].x.cross(s[i].P);
      sum[6] += kinetic_energy(scene.bodies()[i], s[i]);
    }
    sum[6] +=
        SpringBetween{}.energy(derived(scene.bodies()[0], s[0]), derived(scene.bodies()[1], s[1]));
    return sum;
  };
  CHECK((end[0].P - start[0].P).norm() > 0.1);
  CHECK((total(end) - total(start)).norm() <= 1e-11 * total(start).norm());
}

TEST_CASE("SceneRhs: a state that does not fit is refused") {
  const SceneRhs scene(two_bodies());
  CHECK_REFUSED(scene(0, detail::PackedScene<double>::Zero(25)), "13", "25");
  CHECK_REFUSED(scene(0, detail::PackedScene<double>::Zero(39)), "2 bodies", "3");
}

TEST_CASE("SceneRhs: an empty scene has an empty rate") {
  CHECK(SceneRhs(std::vector<RigidBody<double>>{})(0, detail::PackedScene<double>(0)).size() == 0);
}
