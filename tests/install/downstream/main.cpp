// What README.md shows, from an installed prefix: a block of aluminium falls for
// a second, spinning.
#include <cstdio>
#include <tumble/tumble.hpp>
using namespace tumble;

int main() {
  const RigidBody<> body(
      mass_properties(Box{{0.1, 0.2, 0.05}}, 2700));  // 10 × 20 × 5 cm of aluminium
  const RigidBodyMotion motion(body, Weight{});       // and what pushes it
  RigidBodyState<> state;                             // at rest in the origin
  state.L = {0, 0.02, 1e-5};                          // angular momentum, kg m²/s
  const auto later = integrate_adaptive<Dop853>(motion, pack(state), 0.0, 1.0, {1e-9, 1e-9});
  const RigidBodyState<> fallen = unpack<double>(later.y);

  std::printf("mass %g kg, height %.9f m, turned by %g rad\n", body.mass(), fallen.x.z(),
              angle_between(state.q, fallen.q));
  const bool on_the_parabola = std::abs(fallen.x.z() + 9.80665 / 2) < 1e-9;
  return on_the_parabola && fallen.L == state.L && angle_between(state.q, fallen.q) > 0.1 ? 0 : 1;
}
