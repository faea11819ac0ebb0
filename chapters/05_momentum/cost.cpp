/// @file
/// From L to ω: what each way costs, and what is left of the digits for a long thin body.

#include "common.hpp"
#include "omega_from_L.hpp"
#include "parts.hpp"
#include "support/counted.hpp"
#include "support/stopwatch.hpp"
#include "tumble/mass/points.hpp"

namespace momentum_chapter {

namespace {

// ── Counts and times ──

template <class T>
Task<T> ordinary_task() {
  Mat3 I;
  I << 1.2, 0.1, -0.2, 0.1, 1.6, 0.3, -0.2, 0.3, 2.1;
  const Quat q = exp_quaternion<double>(Vec3(0.3, -1.1, 0.7));
  const Quaternion<T> q_T(T(q.w()), T(q.x()), T(q.y()), T(q.z()));
  const Vector3<T> L(T(0.4), T(-0.7), T(1.3));
  return {RigidBody<T>(1.5, I), q_T, to_matrix(q_T), L, Vector3<T>(T(1), T(1.6), T(2.2))};
}

constexpr int samples = 1000;

std::vector<PointMass> thousand_points() {
  Random random(5);
  std::vector<PointMass> points;
  for (int i = 0; i < samples; ++i) points.push_back({1.0 / samples, random.vector(1)});
  return points;
}

/// Σ m (rᵀr 1 − r rᵀ) of the points as the body has turned them: six different entries.
template <class T>
Vector3<T> by_summing_points(const Task<T>& task, const std::vector<PointMass>& points) {
  Matrix3<T> I = Matrix3<T>::Zero();
  for (const PointMass& point : points) {
    const Vector3<T> p = point.position.cast<T>();
    const Vector3<T> r = task.R * p;
    const Vector3<T> mr = T(point.mass) * r;
    const T xx = mr.x() * r.x(), yy = mr.y() * r.y(), zz = mr.z() * r.z();
    I(0, 0) += yy + zz;
    I(1, 1) += zz + xx;
    I(2, 2) += xx + yy;
    I(0, 1) -= mr.x() * r.y();
    I(1, 2) -= mr.y() * r.z();
    I(2, 0) -= mr.z() * r.x();
  }
  I(1, 0) = I(0, 1);
  I(2, 1) = I(1, 2);
  I(0, 2) = I(2, 0);
  return I.inverse() * task.L;
}

/// A way from L to ω, on doubles and on numbers that count.
struct WayToOmega {
  std::string name;
  Vec3 (*plain)(const Task<double>&);
  Vector3<support::Counted> (*counted)(const Task<support::Counted>&);
};

const std::vector<WayToOmega> ways_to_omega{
    {"R (I_body⁻¹ (Rᵀ L))", by_three_products, by_three_products},
    {"the same in principal axes", in_principal_axes, in_principal_axes},
    {"(R I_body⁻¹ Rᵀ) L", by_inverse_in_world, by_inverse_in_world},
    {"(R I_body Rᵀ)⁻¹ L", by_inverting_in_world, by_inverting_in_world}};

}  // namespace

Table counts_table() {
  Table table({"from L to ω", "operations"});
  const auto task = ordinary_task<support::Counted>();
  for (const WayToOmega& way : ways_to_omega)
    table.add(
        {way.name, support::text_of(support::count([&] { support::keep(way.counted(task)); }))});
  const std::vector<PointMass> points = thousand_points();
  table.add({"1000 points summed anew, inverted", support::text_of(support::count([&] {
               support::keep(by_summing_points(task, points));
             }))});
  table.add({"for comparison: R from q",
             support::text_of(support::count([&] { support::keep(to_matrix(task.q)); }))});
  return table;
}

Table times_table() {
  static Task<double> task = ordinary_task<double>();
  static const std::vector<PointMass> points = thousand_points();
  support::Stopwatch stopwatch;
  const auto add = [&](const std::string& name, auto&& action, int times = 1000) {
    const auto fresh = [action] {
      support::keep(task);
      support::keep(action());
    };
    stopwatch.add(name, fresh, times);
  };
  add(ways_to_omega[0].name, [] { return by_three_products(task); });
  add(ways_to_omega[1].name, [] { return in_principal_axes(task); });
  add(ways_to_omega[2].name, [] { return by_inverse_in_world(task); });
  add(ways_to_omega[3].name, [] { return by_inverting_in_world(task); });
  add(
      "1000 points summed anew, inverted", [] { return by_summing_points(task, points); }, 1);
  add("for comparison: R from q", [] { return to_matrix(task.q); });
  const std::vector<support::Timing> timings = stopwatch.timings();
  Table table({"from L to ω", "time", "as a ratio"});
  for (const support::Timing& each : timings)
    table.add({each.name, support::duration(each.seconds),
               support::times(each.seconds / timings[0].seconds)});
  return table;
}

}  // namespace momentum_chapter
