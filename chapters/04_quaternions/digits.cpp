/// @file
/// Places where a formula loses its digits.

#include "common.hpp"
#include "parts.hpp"

namespace quaternions_chapter {

namespace {

/// The formula with sines, as books have it; `straight` mixes linearly above that cosine.
Quat by_sines(const Quat& a, const Quat& b, double t, double straight) {
  const double cosine = a.dot(b);
  if (cosine > straight) return mix_four(a, b, t).normalized();
  const double angle = std::acos(std::min(cosine, 1.0));
  return Quat(
      Eigen::Vector4d((std::sin((1 - t) * angle) * a.coeffs() + std::sin(t * angle) * b.coeffs()) /
                      std::sin(angle)));
}

}  // namespace

Table small_angles_table() {
  Table table({"turn [rad]", "2 acos w: relative error", "2 atan2(|v|, w)"});
  for (const double angle : {1.0, 1e-2, 1e-4, 1e-6, 1e-7, 1e-8}) {
    const Quat q = from_axis_angle({2, -1, 2}, angle);
    const auto off = [&](double read) { return error_or_rounding(std::abs(read / angle - 1)); };
    table.add(
        {number(angle), off(2 * std::acos(q.w())), off(2 * std::atan2(q.vec().norm(), q.w()))});
  }
  return table;
}

Table near_table() {
  Table table(
      {"apart [rad]", "sines and acos: off by", "straight above cos = 0.9995", "a (a⁻¹ b)ᵗ"});
  const Vec3 axis = Vec3(2, -1, 2).normalized();
  for (const double angle : {1.0, 0.06, 1e-3, 1e-8, 0.0}) {
    const Quat a = exp_quaternion<double>(Vec3(0.3, -1.1, 0.7));
    const Quat b = exp_quaternion<double>(angle * axis) * a;
    const Quat exact = exp_quaternion<double>(0.25 * angle * axis) * a;
    const auto off = [&](const Quat& q) {
      return q.coeffs().hasNaN() ? "not a number" : error_or_rounding(angle_between(exact, q));
    };
    table.add({number(angle), off(by_sines(a, b, 0.25, 2)), off(by_sines(a, b, 0.25, 0.9995)),
               off(slerp(a, b, 0.25))});
  }
  return table;
}

}  // namespace quaternions_chapter
