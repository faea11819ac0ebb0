#pragma once
/// @file
/// The motion of a free body by coarse steps, by what the solver stores.

#include <vector>

#include "storages.hpp"
#include "tumble/ode/integrate_fixed.hpp"
#include "tumble/ode/midpoint.hpp"

namespace momentum_chapter {

/// A free body at one time.
struct Sample {
  Quat q;
  Vec3 omega, L;  ///< in world axes

  double energy() const { return L.dot(omega) / 2; }
};

/// The orientation in which a direction of the body points up.
inline Quat upright(const Vec3& direction) {
  const Vec3 up = direction.normalized(), right = up.unitOrthogonal();
  Mat3 rows;
  rows << right.transpose(), up.cross(right).transpose(), up.transpose();
  return from_matrix(rows);
}

/// The motion by the midpoint method, with L upright at the start: 2 · steps + 1 samples. Those in
/// the middle of a step are half a step; the solver doesn't go on from there.
/// @param omega_body at the start, along body axes [rad/s]
/// @param duration   [s]
inline std::vector<Sample> flown(const RigidBody<>& body, const Storage<double>& storage,
                                 const Vec3& omega_body, double duration, int steps) {
  using runge_kutta::Midpoint;
  const auto rate = [&](double, const Seven<double>& y) { return storage.rate(body, y); };
  const auto sample = [&](const Seven<double>& y) -> Sample {
    const Quat q = orientation_of(y);
    const Mat3 R = to_matrix(q);
    const Vec3 omega = storage.to_omega(body, R, y.tail<3>());
    return {q, omega, angular_momentum(body, R, omega)};
  };
  const Quat q = upright(body.I_body() * omega_body);
  const Mat3 R = to_matrix(q);
  const Seven<double> start = seven<double>(q, storage.from_omega(body, R, R * omega_body));
  std::vector<Sample> samples{sample(start)};
  Seven<double> before = start;
  integrate_fixed<Midpoint>(rate, start, 0, duration, steps, [&](double, const Seven<double>& y) {
    samples.push_back(sample(Midpoint::step(rate, 0., before, duration / (2 * steps))));
    samples.push_back(sample(y));
    before = y;
  });
  return samples;
}

}  // namespace momentum_chapter
