#pragma once

#include "tumble/steady/lagrange_top.hpp"

#include "tumble/core/compiled.hpp"
#include "tumble/core/rounding.hpp"
#include "tumble/quaternion/between_directions.hpp"

namespace tumble::steady {

TUMBLE_BODY LagrangeTop::LagrangeTop(const detail::TopConstants& m, const Vec3& up,
                                     const Vec3& axis, double slip)
    : motion_(m),
      up_(up),
      axis_(axis),
      upright_(detail::between_directions(Vec3::UnitZ(), up)),
      frame_(detail::between_directions(axis, Vec3::UnitZ())),
      slip_(slip / 2),
      alpha_(series_for(m.modulus(), m.eta_a())),
      beta_(series_for(m.modulus(), m.eta_b())) {
  const elliptic::Modulus k = m.modulus();
  lambda_ = m.lambda();
  v0_ = detail::start_of(k, m.start.cn, m.start.sn);
  K_ = elliptic::complete_elliptic_k(std::sqrt(k.kc2));
  sign_a_ = std::copysign(1, m.L_along + m.L_axis);
  sign_b_ = std::copysign(1, m.excess);
  loss_ = std::max((m.w2 - m.w3) / m.w2, (2 - m.w3) / (2 - m.w1));
  const elliptic::Amplitude a = m.eta_a(), b = m.eta_b();
  const double dn_a = std::sqrt((2 - m.w2) / (2 - m.w3)), dn_b = std::sqrt(m.w1 / (m.w1 - m.w3));
  rate_a_ = lambda_ * (dn_a / (a.sn * a.cn) - zeta(alpha_));
  rate_b_ = lambda_ * (k.kc2 * b.sn * b.cn / dn_b - (zeta(beta_) - k.k2 * b.sn / (b.cn * dn_b)));
}

TUMBLE_BODY std::optional<LagrangeTop> LagrangeTop::from(const SteadyTorque& torque, const Quat& q,
                                                         const Vec3& L) {
  const Vec3& J = torque.axes().moments;
  const bool oblate = J[0] == J[1], symmetric = oblate || J[1] == J[2];
  if (!symmetric || J[0] == J[2] || torque.rank() != 1 || !torque.drag().isZero(0)) return {};
  const int z = oblate ? 2 : 0, x = (z + 1) % 3, y = (z + 2) % 3;
  const Vec3& arm = torque.arm(0);
  if (std::hypot(arm[x], arm[y]) > 4 * detail::unit_roundoff * std::abs(arm[z])) return {};

  // Away from the force: the torque is −μ n × e.
  const Vec3 up = arm[z] > 0 ? Vec3(-torque.direction(0)) : torque.direction(0);
  const auto into_top = [&](const Vec3& v) -> detail::Vec3dd {
    const detail::Vec3dd p = detail::principal_momentum(torque.axes(), q, v);
    return {p[x], p[y], p[z]};
  };
  const auto motion = detail::top_constants(J[x], std::abs(arm[z]), into_top(L), into_top(up));
  if (!motion) return {};
  const double slip = motion->L_axis * (J[x] - J[z]) / J[x] / J[z];
  LagrangeTop top(*motion, up, torque.axes().R.col(z), slip);
  const Quat raw = top.upright_.conjugate() * top.at(0).q * top.frame_.conjugate();
  const Quat wanted = top.upright_.conjugate() * q * top.frame_.conjugate();
  const auto direction = [](double re, double im) {
    const std::complex<double> c(re, im);
    return c / std::abs(c);
  };
  top.a0_ = direction(wanted.w(), wanted.z()) / direction(raw.w(), raw.z());
  top.b0_ = direction(wanted.x(), wanted.y()) / direction(raw.x(), raw.y());
  return top;
}

}  // namespace tumble::steady
