// What single precision costs, and what it does not.
#include <doctest/doctest.h>

#include "tumble/ode/integrate_fixed.hpp"
#include "tumble/ode/rk4.hpp"
#include "turning.hpp"

using namespace tumble;

namespace {

/// Orientation error after 60 s by RK4 in steps of 1/rate, computed in T.
template <class T>
double error_in(int rate) {
  const Vec3 J(1, 2, 3);
  const RigidBodyState<> start = test::turning(J, Vec3(0.5, 1, 0.7));
  const RigidBodyRhs motion(RigidBody<T>(MassProperties{1, Vec3::Zero(), Mat3(J.asDiagonal())}));
  const PackedState<T> y = pack(start).cast<T>();
  const RigidBodyState<T> end = unpack<T>(integrate_fixed<Rk4>(motion, y, T(0), T(60), 60 * rate));
  return angle_between(Quat(end.q.template cast<double>().normalized()),
                       test::truth_of(J, start).at(60).q);
}

}  // namespace

TEST_CASE("float or double: with steps of 1/20 s it makes no difference") {
  const double exact = error_in<double>(20);
  CHECK(std::abs(error_in<float>(20) - exact) <= 0.3 * exact);
}

TEST_CASE("float or double: with short steps rounding is all that is left of the error") {
  constexpr double float_eps = 0x1p-24;
  for (const int rate : {240, 1000}) {
    const double steps = 60 * rate;
    CHECK(error_in<float>(rate) > 100 * error_in<double>(rate));
    CHECK(error_in<float>(rate) <= 4 * float_eps * steps);  // each step rounds q once or twice
  }
}
