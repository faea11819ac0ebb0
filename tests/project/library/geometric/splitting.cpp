#include "tumble/geometric/splitting.hpp"

#include <doctest/doctest.h>

#include "project/harness/inputs.hpp"
#include "project/library/geometric/pulled.hpp"
#include "reference/double_double_motion.hpp"
#include "tumble/free_body/free_trajectory.hpp"

using namespace tumble;
using test::pull, test::start;

namespace {

const RigidBody<> top(1, Mat3(Vec3(1, 1, 0.5).asDiagonal()));
const RigidBody<> full(1, Mat3(Vec3(1, 1.3, 0.6).asDiagonal()));

/// Of the turning: what the fall of the centre has no part in.
double energy(const RigidBody<>& body, const RigidBodyState<>& s) {
  return s.L.dot(derived(body, s).omega) / 2 - pull.force.dot(s.q * pull.p_body);
}

template <class Scheme>
RigidBodyState<> after(const RigidBody<>& body, double t, int steps) {
  const RigidBodyRhs motion(body, pull);
  const geometric::Splitting<Scheme, ForceAtBodyPoint> splitting(motion);
  RigidBodyState<> s = start();
  for (int i = 0; i < steps; ++i) s = splitting.step(i * t / steps, s, t / steps);
  return s;
}

/// The orders seen when steps are halved, from two pairs of step sizes.
template <class Scheme>
void check_order(int steps) {
  for (const RigidBody<>& body : {top, full}) {
    const Vec3 J = body.I_body().diagonal();
    const Quat truth = reference::turned({J, start().q, start().L, pull.force, pull.p_body}, 2).q;
    const double rough = angle_between(after<Scheme>(body, 2, steps).q, truth);
    const double fine = angle_between(after<Scheme>(body, 2, 2 * steps).q, truth);
    CHECK(std::log2(rough / fine) > Scheme::order - 0.4);
    CHECK(std::log2(rough / fine) < Scheme::order + 1.6);
  }
}

template <class Scheme>
void check_geometry() {
  const RigidBodyRhs motion(full, pull);
  const geometric::Splitting<Scheme, ForceAtBodyPoint> splitting(motion);
  const RigidBodyState<> s = start(), there = splitting.step(0, s, 0.05);
  const RigidBodyState<> back = splitting.step(0.05, there, -0.05);
  CHECK(angle_between(back.q, s.q) < 1e-14);
  CHECK((pack(back) - pack(s)).norm() < 1e-13);

  const double at_start = energy(full, s);
  double early = 0, late = 0;
  RigidBodyState<> now = s;
  constexpr int steps = 4000;
  for (int i = 0; i < steps; ++i) {
    now = splitting.step(0, now, 0.05);
    double& worst = i < steps / 2 ? early : late;
    worst = std::max(worst, std::abs(energy(full, now) - at_start));
  }
  CHECK(std::abs(now.q.norm() - 1) < 1e-13);
  CHECK(late <= 1.5 * early);
}

}  // namespace

TEST_CASE("Splitting: each scheme has its order, for tops and for full bodies") {
  check_order<geometric::Strang>(40);
  check_order<geometric::BlanesMoan4>(80);
  check_order<geometric::BlanesMoan6>(20);
  check_order<geometric::KahanLi8>(20);
}

TEST_CASE("Splitting: goes back where it came from, keeps a unit quaternion and the energy") {
  check_geometry<geometric::Strang>();
  check_geometry<geometric::BlanesMoan4>();
  check_geometry<geometric::BlanesMoan6>();
  check_geometry<geometric::KahanLi8>();
}

TEST_CASE("Splitting: without forces one step is exact, L to the last bit") {
  const RigidBodyRhs motion(full);
  const geometric::Splitting<geometric::Strang> splitting(motion);
  const RigidBodyState<> s = splitting.step(0, start(), 10);
  CHECK(angle_between(s.q, FreeTrajectory(full, start()).at(10).q) < 1e-14);
  CHECK(s.L == start().L);
  CHECK(s.P == start().P);
}
