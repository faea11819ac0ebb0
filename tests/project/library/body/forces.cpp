#include "tumble/body/forces.hpp"

#include <doctest/doctest.h>

#include "project/harness/refusal.hpp"
#include "project/harness/relative_error.hpp"
#include "project/library/body/random_state.hpp"
#include "tumble/body/dydt.hpp"
#include "tumble/quaternion/exp_log.hpp"

using namespace tumble;
using test::body, test::eps;

namespace {

Derived<> random_motion(test::Random& rng) { return derived(body, test::random_state(rng)); }

}  // namespace

static_assert(BodyForce<Weight, double> && BodyForce<ForceAtBodyPoint, double> &&
              BodyForce<BodyDrag, double> && BodyForce<SpringToWorld, double>);
static_assert(BodyForce<Weight, float> && BodyForce<SpringToWorld, float>);
static_assert(!BodyForce<int, double>);

TEST_CASE("force_at_point: a worked number, pushing up at arm's length turns about −y") {
  const Wrench<> w = force_at_point<double>(Vec3(0, 0, 3), Vec3(3, 0, 0), Vec3(1, 0, 0));
  CHECK(w.force == Vec3(0, 0, 3));
  CHECK(w.torque == Vec3(0, -6, 0));
}

TEST_CASE("force_at_point: a force through the centre has no torque, along its line it may slide") {
  test::Random rng(131);
  for (int i = 0; i < 50; ++i) {
    const Vec3 F = rng.vector(), p = rng.vector(), x = rng.vector();
    CHECK(force_at_point<double>(p - x, p, x).torque.norm() <= 4 * eps);
    const Vec3 torque = force_at_point<double>(F, p, x).torque;
    CHECK((force_at_point<double>(F, p + 2 * F, x).torque - torque).norm() <= 16 * eps);
    CHECK(std::abs(torque.dot(F)) <= 16 * eps);
    CHECK(std::abs(torque.dot(p - x)) <= 16 * eps);
  }
}

TEST_CASE(
    "force_at_point: a pair of opposite forces is a pure torque, the same about every point") {
  const Vec3 F(0, 1, 0), p(1, 0, 0), far(100, 200, 300);
  const Wrench<> pair = force_at_point<double>(F, p, far) + force_at_point<double>(-F, -p, far);
  CHECK(pair.force == Vec3::Zero());
  CHECK(pair.torque == Vec3(0, 0, 2));
}

TEST_CASE("Weight: is m g at the centre") {
  test::Random rng(132);
  const Wrench<> w = Weight{}(0.0, body, random_motion(rng));
  CHECK((w.force - Vec3(0, 0, -2 * 9.80665)).norm() == 0);
  CHECK(w.torque == Vec3::Zero());
}

TEST_CASE("ForceAtBodyPoint: acts where the point of the body is now") {
  test::Random rng(133);
  for (int i = 0; i < 20; ++i) {
    const Derived<> now = random_motion(rng);
    const Vec3 F = rng.vector(), p_body = rng.vector();
    const Wrench<> w = ForceAtBodyPoint{F, p_body}(0.0, body, now);
    CHECK(w.force == F);
    CHECK((w.torque - Vec3(now.R * p_body).cross(F)).norm() <= 16 * eps);
  }
}

TEST_CASE("BodyDrag: always takes energy out") {
  test::Random rng(134);
  for (int i = 0; i < 20; ++i) {
    const Derived<> now = random_motion(rng);
    const Wrench<> w = BodyDrag{0.3, 0.2}(0.0, body, now);
    const double power = w.force.dot(now.v) + w.torque.dot(now.omega);
    const double expected = -0.3 * now.v.squaredNorm() - 0.2 * now.omega.squaredNorm();
    CHECK(test::relative_error(power, expected) <= 8 * eps);
  }
}

TEST_CASE(
    "SpringToWorld: pulls towards its anchor when long, pushes when short, nothing at zero "
    "length") {
  const Derived<> now = derived(body, RigidBodyState<>{});
  const Vec3 corner(1, 0, 0);
  CHECK(SpringToWorld{corner, Vec3(4, 0, 0), 10, 2}(0.0, body, now).force == Vec3(10, 0, 0));
  CHECK(SpringToWorld{corner, Vec3(2, 0, 0), 10, 2}(0.0, body, now).force == Vec3(-10, 0, 0));
  CHECK(SpringToWorld{corner, corner, 10, 2}(0.0, body, now).force == Vec3::Zero());
  CHECK(SpringToWorld{corner, Vec3(1, 3, 0), 10, 2}(0.0, body, now).torque == Vec3(0, 0, 10));
}

TEST_CASE("net_wrench: adds all forces, a user's own lambda among them") {
  const Derived<> now = derived(body, RigidBodyState<>{});
  const auto wind = [](double t, const RigidBody<>&, const Derived<>&) {
    return Wrench<>{Vec3(t, 0, 0), Vec3::Zero()};
  };
  CHECK(net_wrench(7.0, body, now, std::tuple<>{}).force == Vec3::Zero());
  CHECK(net_wrench(7.0, body, now, std::tuple(Weight{Vec3(0, 0, -10)}, wind)).force ==
        Vec3(7, 0, -20));
}

TEST_CASE("RigidBodyRhs: a force that makes no sense is refused") {
  CHECK_REFUSED(RigidBodyRhs(body, Weight{Vec3(0, 0, NAN)}), "weight", "nan");
  CHECK_REFUSED(RigidBodyRhs(body, ForceAtBodyPoint{Vec3(INFINITY, 0, 0), Vec3::Zero()}), "force",
                "inf");
  CHECK_REFUSED(RigidBodyRhs(body, Weight{}, BodyDrag{-0.5, 0}), "drag", "-0.5");
  CHECK_REFUSED(RigidBodyRhs(body, SpringToWorld{Vec3::Zero(), Vec3::Zero(), -2, 0}), "spring",
                "-2");
  CHECK_REFUSED(RigidBodyRhs(body, SpringToWorld{Vec3::Zero(), Vec3(NAN, 0, 0), 1, 0}), "spring",
                "nan");
}
