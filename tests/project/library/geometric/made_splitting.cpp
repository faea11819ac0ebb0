#include <doctest/doctest.h>

#include "pulled.hpp"
#include "tumble/geometric/splitting.hpp"

using namespace tumble;

TEST_CASE("splitting: made of a motion, whatever its forces are called") {
  const auto held = [](double t, const RigidBody<>& body, const Derived<>& now) -> Wrench<> {
    return {.torque = test::pull(t, body, now).torque};
  };
  const RigidBody<> body(1, Mat3(Vec3(1, 2, 2.5).asDiagonal()));
  const auto steps = geometric::splitting<geometric::BlanesMoan4>(RigidBodyRhs(body, held));
  const auto named =
      geometric::Splitting<geometric::BlanesMoan4, decltype(held)>(RigidBodyRhs(body, held));
  CHECK(pack(steps.step(0, test::start(), 0.01)) == pack(named.step(0, test::start(), 0.01)));
  CHECK(steps.order == 4);
}
