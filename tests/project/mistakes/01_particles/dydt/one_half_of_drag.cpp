// expect: wrong | named whole-number division
// The drag has a factor 1/2 from the textbook, which is 0 here.
#include "contract.hpp"

namespace particles {

namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

Vector3d position(const VectorXd& y, int particle) { return y.segment<3>(6 * particle); }
Vector3d velocity(const VectorXd& y, int particle) { return y.segment<3>(6 * particle + 3); }

/// The force of a spring on its end i; that on its end j is the opposite.
Vector3d pull(const Spring& spring, const VectorXd& y) {
  const Vector3d l = position(y, spring.i) - position(y, spring.j);
  const double length = l.norm();
  if (length == 0) return Vector3d::Zero();
  const Vector3d u = l / length;
  const double stretching = (velocity(y, spring.i) - velocity(y, spring.j)).dot(u);
  // F = −(k (|l| − r) + d l̇·u) u
  return -(spring.stiffness * (length - spring.rest_length) + spring.damping * stretching) * u;
}

}  // namespace

VectorXd dydt(const System& system, double /*t*/, const VectorXd& y) {
  const int count = static_cast<int>(system.masses.size());
  std::vector<Vector3d> forces;
  for (int n = 0; n < count; ++n) {
    const Vector3d v = velocity(y, n);
    // F = m g − k v − c |v| v
    forces.push_back(system.masses[n] * system.gravity - system.linear_drag * v -
                     1 / 2 * system.quadratic_drag * v.norm() * v);
  }
  for (const Spring& spring : system.springs) {
    const Vector3d F = pull(spring, y);
    forces[spring.i] += F;
    forces[spring.j] -= F;
  }

  VectorXd ydot(y.size());
  for (int n = 0; n < count; ++n) {
    // d/dt (x, v) = (v, F/m)
    ydot.segment<3>(6 * n) = velocity(y, n);
    ydot.segment<3>(6 * n + 3) = forces[n] / system.masses[n];
  }
  return ydot;
}

}  // namespace particles
