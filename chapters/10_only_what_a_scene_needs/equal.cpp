/// @file
/// How equal is equal enough: how wrong a rung too low is.

#include "common.hpp"
#include "named_bodies.hpp"
#include "parts.hpp"

namespace scene_chapter {

namespace {

/// The largest angle between two free motions on the way to T [rad].
double largest_angle(const FreeTrajectory& a, const FreeTrajectory& b, double T) {
  constexpr int moments = 400;
  double largest = 0;
  for (int i = 1; i <= moments; ++i) {
    const double t = i * T / moments;
    largest = std::max(largest, angle_between(a.at(t).q, b.at(t).q));
  }
  return largest;
}

/// A body taken for a simpler one, spun about some axis of its own.
struct Stretched {
  std::string name;
  Vec3 moments, simpler, about;
  double difference;  ///< of the moments that are taken for equal, by the larger one
};

std::vector<Stretched> stretched() {
  const double d = 1e-4;
  const Vec3 askew(1, 2, 3);
  return {
      {"ball, spun askew", {1 - d, 1 - d / 2, 1}, Vec3::Constant(1 - d / 2), askew, d},
      {"ball, about its largest", {1 - d, 1 - d / 2, 1}, Vec3::Constant(1 - d / 2), {0, 0, 1}, d},
      {"top, spun askew", {1 - d, 1, 0.5}, {1 - d / 2, 1 - d / 2, 0.5}, askew, d},
      {"top, along its axis", {1 - d, 1, 0.5}, {1 - d / 2, 1 - d / 2, 0.5}, {0.1, 0.1, 1}, d},
      {"top, ⊥ its axis", {1 - d, 1, 0.5}, {1 - d / 2, 1 - d / 2, 0.5}, {1, 1, 0}, d}};
}

/// Spun at 1 rad/s, so that ωT is T.
double true_error(const Stretched& s, double T) {
  const RigidBody<> body(1, s.moments.asDiagonal()), simple(1, s.simpler.asDiagonal());
  const RigidBodyState<> start = turning_state(body, Quat::Identity(), s.about.normalized());
  return largest_angle(FreeTrajectory(body, start), FreeTrajectory(simple, start), T);
}

/// The wing nut with the mean of its two larger moments for both: a symmetric top.
RigidBody<> nut_as_a_top() {
  const PrincipalAxes axes = principal_axes(fine_nut().I_body());
  const double mean = (axes.moments[1] + axes.moments[2]) / 2;
  const Vec3 moments(axes.moments[0], mean, mean);
  return {fine_nut().mass(), axes.R * moments.asDiagonal() * axes.R.transpose()};
}

}  // namespace

Table nut_table() {
  Table table({"after", "the rule says", "the top is off by"});
  const RigidBodyState<> start = spinning(fine_nut(), nut_rate, nut_tilt);
  const RigidBody<> simple = nut_as_a_top();
  const FreeTrajectory truth(fine_nut(), start), top(simple, start);
  const double part = nearest_symmetric_top(fine_nut()).asymmetry;
  for (const double T : {0.01, 0.1, 0.2, 0.5, 1.0})
    table.add({number(T) + " s", number(part * nut_rate * T, 2) + " rad",
               number(largest_angle(truth, top, T), 2) + " rad"});
  return table;
}

Table equal_table() {
  Table table({"taken for a", "ωT = 10 rad", "100 rad", "1000 rad", "true ÷ rule"});
  std::vector<std::string> rule{"the rule, ωT · 1e-4"};
  for (const double T : {10., 100., 1000.}) rule.push_back(error_number(1e-4 * T) + " rad");
  rule.emplace_back("");
  table.add(rule);
  for (const Stretched& s : stretched()) {
    std::vector<std::string> row{s.name};
    std::string ratios;
    for (const double T : {10., 100., 1000.}) {
      const double error = true_error(s, T);
      row.push_back(error_number(error) + " rad");
      ratios += (ratios.empty() ? "" : ", ") + number(error / (s.difference * T), 2);
    }
    row.push_back(ratios);
    table.add(row);
  }
  return table;
}

}  // namespace scene_chapter
