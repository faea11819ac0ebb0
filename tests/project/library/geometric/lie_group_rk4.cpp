#include "tumble/geometric/lie_group_rk4.hpp"

#include <doctest/doctest.h>

#include "project/library/geometric/pulled.hpp"
#include "reference/double_double_motion.hpp"
#include "tumble/ode/integrate_fixed.hpp"
#include "tumble/ode/rk4.hpp"

using namespace tumble;
using test::pull, test::start;

namespace {

const RigidBody<> heavy(2, Mat3(Vec3(1, 1.3, 0.6).asDiagonal()));

template <class... Forces>
RigidBodyState<> after(int steps, const Forces&... forces) {
  const RigidBodyRhs motion(heavy, forces...);
  RigidBodyState<> s = start();
  for (int i = 0; i < steps; ++i)
    s = geometric::LieGroupRk4::step(motion, i * 2.0 / steps, s, 2.0 / steps);
  return s;
}

}  // namespace

TEST_CASE("LieGroupRk4: order 4, with a quaternion that stays a unit one by itself") {
  const Vec3 J = heavy.I_body().diagonal();
  const Quat truth = reference::turned({J, start().q, start().L, pull.force, pull.p_body}, 2).q;
  const RigidBodyState<> rough = after(50, pull), fine = after(100, pull);
  const double order = std::log2(angle_between(rough.q, truth) / angle_between(fine.q, truth));
  CHECK(order > 3.7);
  CHECK(order < 4.6);
  CHECK(std::abs(fine.q.norm() - 1) < 1e-14);
}

TEST_CASE("LieGroupRk4: what does not turn goes as in RK4, forces in time too") {
  const auto push = [](double t, const RigidBody<>&, const Derived<>& now) -> Wrench<> {
    return {Vec3(std::sin(3 * t), 1, 0) - 0.3 * now.v, Vec3::Zero()};
  };
  const RigidBodyRhs motion(heavy, push);
  const RigidBodyState<> found = geometric::LieGroupRk4::step(motion, 1.0, start(), 0.3);
  const auto classic =
      unpack<double>(PackedState<double>(integrate_fixed<Rk4>(motion, pack(start()), 1.0, 1.3, 1)));
  CHECK((found.x - classic.x).norm() < 1e-15);
  CHECK((found.P - classic.P).norm() < 1e-15);
}
