/// @file
/// What each repair leaves, moves and costs, on average over many matrices that have drifted.

#include <algorithm>
#include <limits>
#include <string>

#include "parts.hpp"
#include "steady_turn.hpp"
#include "support/plot.hpp"
#include "support/random.hpp"
#include "support/stopwatch.hpp"

namespace rotation_matrices_chapter {

namespace {

/// A drifted matrix: any rotation, with every number off by at most `size`.
Mat3 drifted(double size, support::Random& random) {
  const Mat3 R = random.rotation().toRotationMatrix();
  Mat3 noise;
  for (double& each : noise.reshaped()) each = random.uniform();
  return R + size * noise;
}

/// What one repair has done to many matrices of the same drift.
struct Outcome {
  double before = 0, after = 0;  // mean ‖RᵀR − 1‖
  std::vector<double> moved;  // ‖R − M‖ against what the nearest rotation needs, in rising order
};

Outcome outcome(const Repair& repair, double size, int matrices) {
  support::Random random(1);
  Outcome sum;
  for (int i = 0; i < matrices; ++i) {
    const Mat3 M = drifted(size, random), R = repair.apply(M);
    sum.before += rotation::orthonormality_error(M) / matrices;
    sum.after += rotation::orthonormality_error(R) / matrices;
    sum.moved.push_back((R - M).norm() / (nearest_rotation(M) - M).norm());
  }
  std::sort(sum.moved.begin(), sum.moved.end());
  return sum;
}

std::string times_text(double ratio) { return support::svg_number(ratio, 2) + " ×"; }

}  // namespace

Table repair_table() {
  constexpr int matrices = 10'000;
  Table table({"drift", "repair", "‖MᵀM − 1‖", "‖RᵀR − 1‖", "moves by", "at most"});
  for (const double size : {1e-1, 1e-3, 1e-6}) {
    for (const Repair& repair : repairs) {
      const Outcome mean = outcome(repair, size, matrices);
      double moved = 0;
      for (const double each : mean.moved) moved += each / matrices;
      table.add({error_number(size), repair.name, error_number(mean.before),
                 support::error_or_rounding(mean.after), times_text(moved),
                 times_text(mean.moved.back())});
    }
  }
  return table;
}

std::string repair_figure() {
  support::Plot plot{"what one repair leaves",
                     {"‖MᵀM − 1‖ before", support::Scale::log},
                     {"‖RᵀR − 1‖ after", support::Scale::log},
                     {}};
  for (const Repair& repair : repairs) {
    support::Series series{repair.name, {}, {}};
    double size = 1e-9;
    for (int i = 0; i < 18; ++i, size *= 3) {
      const Outcome mean = outcome(repair, size, 100);
      series.x.push_back(mean.before);
      series.y.push_back(mean.after);
    }
    plot.series.push_back(series);
  }
  return support::to_svg(plot);
}

namespace {

constexpr int never = std::numeric_limits<int>::max();

std::string every_text(int every) {
  if (every == never) return "never";
  return every == 1 ? "step" : number(every) + " steps";
}

/// One minute of midpoint steps, the matrix repaired every so often.
void add_schedule(Table& table, const Repair& repair, int every) {
  constexpr int steps = 60 * 60;
  Mat3 R = Mat3::Identity();
  double worst = 0;
  for (int i = 1; i <= steps; ++i) {
    R = midpoint(R);
    worst = std::max(worst, rotation::orthonormality_error(R));
    if (i % every == 0) R = repair.apply(R);
  }
  table.add({repair.name, every_text(every), error_number(worst),
             error_number(angle_apart(exact_orientation(steps), nearest_rotation(R))) + " rad"});
}

}  // namespace

Table schedule_table() {
  Table table({"repair", "every", "‖RᵀR − 1‖ at worst", "orientation off by"});
  for (const Repair& repair : repairs)
    for (const int every : {1, 60}) add_schedule(table, repair, every);
  add_schedule(table, {"none", [](const Mat3& R) { return R; }}, never);
  return table;
}

Table times_table() {
  support::Random random(1);
  support::Stopwatch stopwatch;
  const Mat3 start = drifted(1e-3, random);
  stopwatch.add("one midpoint step of Ṙ = [ω]×R", [y = Flat(start.reshaped())]() mutable {
    support::keep(y = runge_kutta::midpoint_step(rate, 0, y, h));
  });
  for (const Repair& repair : repairs)
    stopwatch.add(repair.name, [M = start, &repair] {
      support::keep(M);
      support::keep(repair.apply(M));
    });
  const std::vector<support::Timing> timings = stopwatch.timings();
  Table table({"what", "time", "midpoint steps"});
  for (const support::Timing& each : timings)
    table.add({each.name, support::duration(each.seconds),
               support::times(each.seconds / timings[0].seconds)});
  return table;
}

}  // namespace rotation_matrices_chapter
