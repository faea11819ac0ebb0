// The whole library from an installed prefix: a free body keeps its angular momentum.
#include <cstdio>
#include <tumble/tumble.hpp>

int main() {
  const tumble::RigidBody<> body(1, tumble::Mat3(tumble::Vec3(1, 2, 2.5).asDiagonal()));
  tumble::RigidBodyState<> start;
  start.L = tumble::Vec3(0.01, 2, 0.01);
  const tumble::PackedState<double> y =
      tumble::integrate_adaptive<tumble::Dop853>(tumble::RigidBodyMotion(body), tumble::pack(start), 0.0, 10.0,
                                                 tumble::Tolerances{1e-10, 1e-10})
          .y;
  const tumble::Vec3 L = tumble::unpack<double>(y).L;
  std::printf("L = %g %g %g\n", L.x(), L.y(), L.z());
  return L == start.L && y != tumble::pack(start) ? 0 : 1;
}
