// What README.md shows, from an installed prefix: a block of aluminium falls for
// a second, spinning.
#include <cmath>
#include <cstdio>
#include <tumble/tumble.hpp>

using namespace tumble;

const Vec3 spin(0, 0.02, 1e-5);  // angular momentum [kg m²/s]

RigidBodyState<> after_a_second() {
  const Box bar{{0.1, 0.2, 0.05}};                     // [m]
  const RigidBody<> body(mass_properties(bar, 2700));  // of aluminium [kg/m³]
  const RigidBodyRhs dydt(body, Weight{});             // and what pushes it
  RigidBodyState<> start;                              // at rest at the origin,
  start.L = spin;                                      // but spinning [kg m²/s]
  const auto y0 = pack(start);
  const auto end = integrate_adaptive<Dop853>(dydt, y0, 0.0, 1.0, {1e-9, 1e-9});
  return unpack<double>(end.y);
}

int main() {
  const RigidBodyState<> fallen = after_a_second();
  const double turned = angle_between(RigidBodyState<>{}.q, fallen.q);
  std::printf("height %.9f m, turned by %g rad\n", fallen.x.z(), turned);
  const bool on_the_parabola = std::abs(fallen.x.z() + 9.80665 / 2) < 1e-9;
  return on_the_parabola && fallen.L == spin && turned > 0.1 ? 0 : 1;
}
