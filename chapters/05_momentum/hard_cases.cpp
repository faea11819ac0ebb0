/// @file
/// Where it goes wrong: a needle, a force in the wrong axes, an arm of yesterday, sums that cancel.

#include <algorithm>
#include <cmath>

#include "common.hpp"
#include "omega_from_L.hpp"
#include "parts.hpp"
#include "plank.hpp"
#include "support/plot.hpp"
#include "tumble/mass/transform.hpp"
#include "tumble/simd/double_double.hpp"

namespace momentum_chapter {

// ── A needle ──

namespace {

/// A body with moments 1/κ, 1, 1 in an orientation of its own.
Task<double> needle(double condition, const Mat3& R) {
  const Vec3 moments(1 / condition, 1, 1);
  return {RigidBody<>(1, moments.asDiagonal()), from_matrix(R), R, Vec3::Zero(), moments};
}

/// The same with its tensor in other body axes, turned by S.
Task<double> in_other_axes(const Task<double>& task, const Mat3& S) {
  Task<double> other = task;
  other.body = RigidBody<>(1, rotate_inertia(S, task.body.I_body()));
  other.R = task.R * S.transpose();
  return other;
}

/// ω in 32 digits: Σ n (n · L) / A over the three axes.
Vec3 exact_omega(const Task<double>& task) {
  Vector3<simd::DoubleDouble> omega = Vector3<simd::DoubleDouble>::Constant(0.0);
  for (int i = 0; i < 3; ++i) {
    simd::DoubleDouble along = 0.0;
    for (int k = 0; k < 3; ++k) along += simd::DoubleDouble(task.R(k, i)) * task.L[k];
    for (int k = 0; k < 3; ++k)
      omega[k] += along / simd::DoubleDouble(task.moments[i]) * task.R(k, i);
  }
  return omega.unaryExpr([](const simd::DoubleDouble& x) { return double(x); });
}

/// The worst relative error of ω for an L in any direction.
template <class Way>
double worst_of_any_L(double condition, const Way& way) {
  Random random(5);
  double worst = 0;
  for (int i = 0; i < 40; ++i) {
    const Mat3 R = exp_rotation(random.vector(3)), S = exp_rotation(random.vector(3));
    Task<double> task = needle(condition, R);
    task.L = R * random.vector(0.5, 1);
    const Vec3 omega = exact_omega(task);
    worst = std::max(worst, (way(task, S) - omega).norm() / omega.norm());
  }
  return worst;
}

/// The same for a needle that only tumbles: its L lies across it, as nearly as doubles can say.
double worst_of_tumbling(double condition) {
  Random random(5);
  double worst = 0;
  for (int i = 0; i < 40; ++i) {
    const Mat3 R = exp_rotation(random.vector(3));
    Task<double> task = needle(condition, R);
    const Vec3 omega = R * random.vector(0.5, 1).cwiseProduct(Vec3(0, 1, 1));
    task.L = angular_momentum(task.body, R, omega);
    worst = std::max(worst, (by_three_products(task) - omega).norm() / omega.norm());
  }
  return worst;
}

}  // namespace

std::string needle_figure() {
  support::Plot plot{"ω of a needle",
                     {"largest moment / smallest moment", support::Scale::log},
                     {"relative error of ω, at worst", support::Scale::log},
                     {}};
  const auto add = [&](const std::string& name, auto&& error) {
    support::Series series{name, {}, {}};
    for (int i = 0; i <= 12; ++i) {
      const double condition = std::pow(10.0, i);
      series.x.push_back(condition);
      series.y.push_back(error(condition));
    }
    plot.series.push_back(series);
  };
  const auto any_L = [](auto way) {
    return [way](double condition) { return worst_of_any_L(condition, way); };
  };
  // The uppermost curve first, with a colour that leaves the others theirs: names find their places
  // one after the other, and those of ends that lie close are in this order.
  add("L ⊥ needle", worst_of_tumbling);
  plot.series.back().colour = "c3";
  add("(R I_body Rᵀ)⁻¹ L",
      any_L([](const Task<double>& task, const Mat3&) { return by_inverting_in_world(task); }));
  add("axes not principal", any_L([](const Task<double>& task, const Mat3& S) {
        return by_three_products(in_other_axes(task, S));
      }));
  add("principal axes, any L",
      any_L([](const Task<double>& task, const Mat3&) { return by_three_products(task); }));
  return support::to_svg(plot);
}

// ── A force in the axes of the body ──

namespace {

constexpr double thrust = 10, satellite_mass = 100, satellite_spin = 0.5;  // [N], [kg], [rad/s]

/// A nozzle that is fixed in the body: its force turns with it.
auto nozzle() {
  return [](double, const RigidBody<>&, const Derived<>& now) -> Wrench<> {
    return {now.R * Vec3(thrust, 0, 0), Vec3::Zero()};
  };
}

/// The same without R: it pushes along the world's x axis for ever.
auto nozzle_not_turned() {
  return [](double, const RigidBody<>&, const Derived<>&) -> Wrench<> {
    return {Vec3(thrust, 0, 0), Vec3::Zero()};
  };
}

template <class Force>
std::string distance_after(double t, const Force& force) {
  const RigidBody<> body(satellite_mass, Mat3(20 * Mat3::Identity()));
  const RigidBodyRhs motion(body, force);
  const RigidBodyState<> start = state_of_motion<double>(body, Vec3::Zero(), Quat::Identity(),
                                                         Vec3::Zero(), Vec3(0, 0, satellite_spin));
  const auto end = integrate_adaptive<Dop853>(motion, pack(start), 0, t, {1e-10, 1e-10});
  const PackedState<double> y = end.y;
  return number(y.head<3>().norm()) + " m";
}

}  // namespace

Table nozzle_table() {
  Table table({"after", "F = R F_body", "F = F_body"});
  for (const double t : {1., 10., 60., 600.})
    table.add(
        {number(t) + " s", distance_after(t, nozzle()), distance_after(t, nozzle_not_turned())});
  return table;
}

// ── A point that has moved ──

namespace {

SpringToWorld rope_to(const Vec3& p_body) { return {p_body, Vec3(0.5, 0, 0.5), 60, 0.4}; }

/// The torque with an arm that was right when the step began.
struct ArmOfTheStart {
  SpringToWorld spring;
  Vec3 arm;

  Wrench<> operator()(double t, const RigidBody<>& body, const Derived<>& now) const {
    const Vec3 F = spring(t, body, now).force;
    return force_at_point<double>(F, arm, Vec3::Zero());
  }
};

const Vec3 hook(0.5, 0, 0);

PackedState<double> at_the_hook() { return pack(RigidBodyState<>{}); }

constexpr double swing_time = 1;

PackedState<double> exact_swing() {
  const RigidBodyRhs motion(plank(), Weight{}, rope_to(hook));
  return integrate_adaptive<Dop853>(motion, at_the_hook(), 0, swing_time, {1e-13, 1e-13}).y;
}

Vec3 free_end(const PackedState<double>& y) {
  return point_position<double>(derived(plank(), unpack<double>(y)), -hook);
}

template <class Method>
double fresh_arm_error(int steps) {
  const RigidBodyRhs motion(plank(), Weight{}, rope_to(hook));
  const auto y = integrate_fixed<Method>(motion, at_the_hook(), 0, swing_time, steps);
  return (free_end(y) - free_end(exact_swing())).norm();
}

template <class Method>
double old_arm_error(int steps) {
  PackedState<double> y = at_the_hook();
  for (int i = 0; i < steps; ++i) {
    const Vec3 arm = to_matrix(unpack<double>(y).q) * hook;
    const RigidBodyRhs motion(plank(), Weight{}, ArmOfTheStart{rope_to(hook), arm});
    y = Method::step(motion, 0., y, swing_time / steps);
  }
  return (free_end(y) - free_end(exact_swing())).norm();
}

}  // namespace

Table arm_table() {
  Table table({"the arm is taken", "64 steps", "128 steps", "256 steps", "order"});
  const auto add = [&](const std::string& name, double (*error)(int)) {
    std::vector<std::string> row{name};
    std::vector<double> h, errors;
    for (const int steps : {64, 128, 256}) {
      h.push_back(1. / steps);
      errors.push_back(error(steps));
      row.push_back(error_number(errors.back()) + " m");
    }
    row.push_back(number(runge_kutta::observed_order(h, errors), 2));
    table.add(row);
  };
  add("midpoint: at each evaluation", fresh_arm_error<runge_kutta::Midpoint>);
  add("midpoint: once per step", old_arm_error<runge_kutta::Midpoint>);
  add("RK4: at each evaluation", fresh_arm_error<Rk4>);
  add("RK4: once per step", old_arm_error<Rk4>);
  return table;
}

// ── Forces that cancel ──

namespace {

/// Forces of up to 1000 N along an axis, each with its opposite somewhere else in the list.
std::vector<double> cancelling(int pairs) {
  Random random(5);
  std::vector<double> list;
  for (int i = 0; i < pairs; ++i) {
    const double F = random.uniform(-1000, 1000);
    list.insert(list.end(), {F, -F});
  }
  for (std::size_t i = list.size() - 1; i > 0; --i)
    std::swap(list[i],
              list[static_cast<std::size_t>(random.uniform(0, static_cast<double>(i) + 1))]);
  return list;
}

/// The power of ten above a number: where rounding decides, its digits mean nothing.
std::string below(double value, const std::string& unit) {
  if (value == 0) return "0";
  return "< 1e" + number(std::ceil(std::log10(std::abs(value)))) + unit;
}

}  // namespace

Table cancel_table() {
  Table table({"pairs", "Σ |F|", "what is left of Σ F", "in double-double"});
  for (const int pairs : {100, 10000, 1000000}) {
    double sum = 0, size = 0;
    simd::DoubleDouble precise = 0.0;
    for (const double F : cancelling(pairs)) {
      sum += F;
      size += std::abs(F);
      precise += F;
    }
    table.add(
        {number(pairs, 7), number(size, 2) + " N", below(sum, " N"), below(double(precise), " N")});
  }
  return table;
}

}  // namespace momentum_chapter
