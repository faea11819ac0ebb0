/// @file
/// A body far from the origin of the world: which digits of an arm survive.

#include <algorithm>
#include <cmath>
#include <limits>

#include "common.hpp"
#include "parts.hpp"
#include "support/plot.hpp"
#include "tumble/simd/double_double.hpp"

namespace momentum_chapter {

namespace {

/// The gap between a number and the next one of its type.
template <class T>
double gap(double x) {
  const T value = static_cast<T>(x);
  return static_cast<double>(std::nextafter(value, std::numeric_limits<T>::max()) - value);
}

/// A force at a point of a body.
struct Lever {
  Vec3 p_body, force, direction;
  Mat3 R;
};

std::vector<Lever> levers() {
  Random random(5);
  std::vector<Lever> list;
  for (int i = 0; i < 60; ++i) {
    const Vec3 p_body = random.vector(1), force = random.vector(10);
    const Vec3 direction = random.vector(1).normalized();
    list.push_back({p_body, force, direction, exp_rotation(random.vector(3))});
  }
  return list;
}

using Long = Vector3<simd::DoubleDouble>;

Vec3 rounded(const Long& v) {
  return v.unaryExpr([](const simd::DoubleDouble& x) { return double(x); });
}

/// r × F in 32 digits.
Vec3 exact_torque(const Long& r, const Vec3& F) {
  Long tau;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    tau[i] = r[j] * F[k] - r[k] * F[j];
  }
  return rounded(tau);
}

/// R p_body in 32 digits.
Long exact_arm(const Lever& lever) {
  Long r;
  for (int i = 0; i < 3; ++i)
    r[i] = simd::DoubleDouble(lever.R(i, 0)) * lever.p_body[0] +
           simd::DoubleDouble(lever.R(i, 1)) * lever.p_body[1] +
           simd::DoubleDouble(lever.R(i, 2)) * lever.p_body[2];
  return r;
}

/// The worst error of a torque, relative to arm times force. `make(lever, x)` gives what was
/// computed and what is exact.
template <class Make>
double worst_error(const Make& make, double far) {
  double worst = 0;
  for (const Lever& lever : levers()) {
    const auto [computed, exact] = make(lever, Vec3(far * lever.direction));
    const double size = lever.p_body.norm() * lever.force.norm();
    worst = std::max(worst, (computed - exact).norm() / size);
  }
  return worst;
}

struct Compared {
  Vec3 computed, exact;
};

/// The point is given in body coordinates, and the arm found by way of the world.
template <class T>
Compared through_the_world(const Lever& lever, const Vec3& centre) {
  const Vector3<T> x = centre.cast<T>(), F = lever.force.cast<T>();
  const Vector3<T> p = x + lever.R.cast<T>() * lever.p_body.cast<T>();
  const Wrench<T> wrench = force_at_point<T>(F, p, x);
  return {wrench.torque.template cast<double>(), exact_torque(exact_arm(lever), lever.force)};
}

/// The same, and the arm is only turned.
Compared only_turned(const Lever& lever, const Vec3&) {
  const Vec3 arm = lever.R * lever.p_body;
  return {force_at_point<double>(lever.force, arm, Vec3::Zero()).torque,
          exact_torque(exact_arm(lever), lever.force)};
}

/// The point is given in the world, as it is: then p − x is known to all digits.
Compared given_in_the_world(const Lever& lever, const Vec3& x, bool subtract_first) {
  const Vec3 p = x + lever.R * lever.p_body;
  const Long arm = p.cast<simd::DoubleDouble>() - x.cast<simd::DoubleDouble>();
  const Vec3 late = p.cross(lever.force) - x.cross(lever.force);
  return {subtract_first ? force_at_point<double>(lever.force, p, x).torque : late,
          exact_torque(arm, lever.force)};
}

}  // namespace

Table gaps_table() {
  Table table({"from the origin", "distance [m]", "next double [m]", "next float [m]"});
  const auto add = [&](const std::string& name, double x) {
    table.add({name, number(x), number(gap<double>(x), 2), number(gap<float>(x), 2)});
  };
  add("on the table", 1);
  add("at the end of the village", 1e3);
  add("at the end of the country", 1e6);
  add("four Earth radii from its centre", 2.55e7);
  add("at the Moon", 3.844e8);
  add("at the Sun", 1.496e11);
  return table;
}

std::string far_figure() {
  support::Plot plot{"torque of a force, arm of 1 m",
                     {"distance from the origin [m]", support::Scale::log},
                     {"error, relative to arm × force, at worst", support::Scale::log},
                     {}};
  const auto add = [&](const std::string& name, auto&& torque) {
    support::Series series{name, {}, {}};
    for (int i = 0; i <= 20; ++i) {
      const double far = std::pow(4.0, i);
      const double error = worst_error(torque, far);
      if (error > 0.3) break;
      series.x.push_back(far);
      series.y.push_back(error);
    }
    plot.series.push_back(series);
  };
  add("by way of p", through_the_world<double>);  // its name has the first choice of a place
  plot.series.back().colour = "c2";
  add("p × F − x × F",
      [](const Lever& l, const Vec3& x) { return given_in_the_world(l, x, false); });
  add("(p − x) × F", [](const Lever& l, const Vec3& x) { return given_in_the_world(l, x, true); });
  add("(R p_body) × F", only_turned);
  add("by way of p, in float", through_the_world<float>);
  return support::to_svg(plot);
}

}  // namespace momentum_chapter
