/// @file
/// A steady turn by steps of three methods: how its matrix drifts.

#include <algorithm>

#include "parts.hpp"
#include "steady_turn.hpp"
#include "support/plot.hpp"

namespace rotation_matrices_chapter {

Table drift_table() {
  Table table({"method", "after", "‖RᵀR − 1‖", "longest axis", "volume", "orientation off by"});
  const auto add = [&](const std::string& name, Step step, int seconds) {
    const int steps = 60 * seconds;
    const Mat3 R = stepped(step, steps);
    table.add({name, number(seconds) + " s", error_number(rotation::orthonormality_error(R)),
               number(R.colwise().norm().maxCoeff(), 6), number(R.determinant(), 6),
               error_number(angle_apart(exact_orientation(steps), nearest_rotation(R))) + " rad"});
  };
  for (const int seconds : {1, 10, 60}) add("Euler", euler, seconds);
  for (const int seconds : {10, 600}) add("midpoint", midpoint, seconds);
  for (const int seconds : {10, 600}) add("RK4", rk4, seconds);
  return table;
}

namespace {

/// (1 − h[ω]×) R_new = R: the tangent at the end of the step in place of that at its beginning.
Mat3 backward_euler(const Mat3& R) {
  const Mat3 A = Mat3::Identity() - h * rotation::skew(omega);
  return A.inverse() * R;
}

}  // namespace

Table backward_table() {
  Table table({"after 10 s", "an arrow perpendicular to ω", "volume", "turned by"});
  const Vec3 perpendicular = omega.cross(Vec3::UnitX()).normalized();
  for (const auto& [name, step] :
       {std::pair<const char*, Step>("Euler", euler), {"backward Euler", backward_euler}}) {
    const Mat3 R = stepped(step, 600);
    const double behind = angle_apart(exact_orientation(600), nearest_rotation(R));
    table.add({name, "× " + number((R * perpendicular).norm(), 4),
               "× " + number(R.determinant(), 4), number(20 - behind, 6) + " rad"});
  }
  return table;
}

namespace {

/// ‖RᵀR − 1‖ of a turn that is repaired after each step, at times that grow like powers.
support::Series drift_of(const std::string& name, Step step, Step repair) {
  support::Series series{name, {}, {}};
  Mat3 R = Mat3::Identity();
  int next = 1;
  for (int i = 1; i <= 60 * 600; ++i) {
    R = step(R);
    if (repair != nullptr) R = repair(R);
    if (i != next) continue;
    next = std::max(next + 1, next * 3 / 2);
    series.x.push_back(i * h);
    series.y.push_back(rotation::orthonormality_error(R));
  }
  return series;
}

}  // namespace

std::string drift_figure() {
  support::Plot plot{"drift of a rotation matrix",
                     {"time [s]", support::Scale::log},
                     {"‖RᵀR − 1‖", support::Scale::log},
                     {drift_of("Euler", euler, nullptr), drift_of("midpoint", midpoint, nullptr),
                      drift_of("RK4", rk4, nullptr),
                      drift_of("Euler, one Newton step", euler, rotation::newton_rotation_step),
                      drift_of("Euler, Gram–Schmidt", euler, rotation::gram_schmidt)}};
  return support::to_svg(plot);
}

}  // namespace rotation_matrices_chapter
