#pragma once
/// @file
/// The equation of motion as one who knows the problem would write it by hand for a solver: seven
/// plain numbers (q, ω_body) along the principal axes, so that no tensor has to be turned.
///
///   q̇ = ½ q ⟨0, ω⟩,   I ω̇ = (I ω) × ω + p × Rᵀ F

#include <array>

#include "project/bench/dynamics/contest.hpp"

namespace tumble::bench {

/// q (w, x, y, z) and ω (body coordinates).
using PlainState = std::array<double, 7>;
using Plain3 = std::array<double, 3>;

inline PlainState plain_state(const Spin& spin) {
  const auto& [q, w] = spin;
  return {q.w(), q.x(), q.y(), q.z(), w.x(), w.y(), w.z()};
}

inline Spin plain_spin(const PlainState& y) {
  return {Quat(y[0], y[1], y[2], y[3]), Vec3(y[4], y[5], y[6])};
}

/// Nothing pushes.
struct PlainNothing {
  explicit PlainNothing(const Push&) {}
  Plain3 operator()(const double*) const { return {0, 0, 0}; }
};

/// A constant world force F at the point p of the body: p × Rᵀ F.
struct PlainForce {
  double F[3], p[3];

  explicit PlainForce(const Push& push) {
    for (int i = 0; i < 3; ++i) {
      F[i] = push.force[i];
      p[i] = push.p_body[i];
    }
  }
  Plain3 operator()(const double* q) const {
    const double w = q[0], x = q[1], y = q[2], z = q[3];
    // Rᵀ F = F − 2w (v × F) + 2 v × (v × F), v the vector part of q
    const double cx = 2 * (y * F[2] - z * F[1]), cy = 2 * (z * F[0] - x * F[2]),
                 cz = 2 * (x * F[1] - y * F[0]);
    const double fx = F[0] - w * cx + (y * cz - z * cy), fy = F[1] - w * cy + (z * cx - x * cz),
                 fz = F[2] - w * cz + (x * cy - y * cx);
    return {p[1] * fz - p[2] * fy, p[2] * fx - p[0] * fz, p[0] * fy - p[1] * fx};
  }
};

/// @tparam Torque PlainNothing or PlainForce
template <class Torque>
class PlainRhs {
 public:
  PlainRhs(const Body& body, const Push& push) : torque_(push) {
    const Vec3& I = body.moments;
    for (int i = 0; i < 3; ++i) {
      inverse_[i] = 1 / I[i];
      euler_[i] = (I[(i + 1) % 3] - I[(i + 2) % 3]) / I[i];
    }
  }

  /// dy/dt of the seven numbers at y.
  void operator()(const double* y, double* dydt) const {
    const double w = y[0] / 2, x = y[1] / 2, q = y[2] / 2, z = y[3] / 2;
    const double a = y[4], b = y[5], c = y[6];
    dydt[0] = -(x * a + q * b + z * c);
    dydt[1] = w * a + q * c - z * b;
    dydt[2] = w * b + z * a - x * c;
    dydt[3] = w * c + x * b - q * a;
    const Plain3 torque = torque_(y);
    dydt[4] = euler_[0] * (b * c) + inverse_[0] * torque[0];
    dydt[5] = euler_[1] * (c * a) + inverse_[1] * torque[1];
    dydt[6] = euler_[2] * (a * b) + inverse_[2] * torque[2];
  }

  /// The same as Boost.odeint calls it.
  void operator()(const PlainState& y, PlainState& dydt, double) const {
    (*this)(y.data(), dydt.data());
  }

 private:
  Torque torque_;
  double inverse_[3], euler_[3];
};

/// Calls use with the type of the motion that a scene needs.
template <class Use>
auto with_plain_rhs(const Scene& scene, const Use& use) {
  if (scene.free()) return use.template operator()<PlainRhs<PlainNothing>>();
  return use.template operator()<PlainRhs<PlainForce>>();
}

}  // namespace tumble::bench
