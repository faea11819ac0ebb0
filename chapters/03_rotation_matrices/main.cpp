/// @file
/// Chapter 3: what the order of three turns does, how a rotation matrix drifts, and what each
/// repair costs and gives back.
#include <cmath>
#include <numbers>

#include "objects/objects.hpp"
#include "support/chapter.hpp"
#include "support/gallery.hpp"
#include "support/plot.hpp"
#include "support/stopwatch.hpp"
#include "tumble/ode.hpp"
#include "tumble/quaternion/convert.hpp"
#include "tumble/quaternion/exp_log.hpp"
#include "tumble/rotation.hpp"

namespace {

using namespace tumble;
using support::error_number;
using support::number;
using support::Table;

constexpr double degree = std::numbers::pi / 180;

/// How far apart two orientations are [rad].
double angle_apart(const Mat3& A, const Mat3& B) { return log_rotation(A.transpose() * B).norm(); }

// ── Three turns, in any order ──

const Vec3 three_angles = Vec3(30, 40, 50) * degree;

std::string three_numbers(const Vec3& v) {
  std::string text;
  for (const double x : v) {
    const std::string digits = support::svg_number(x, 3);
    text += (text.empty() ? "" : ", ") + digits;
  }
  return "(" + text + ")";
}

Table order_table() {
  const Mat3 first = euler_angles_to_matrix(three_angles, EulerSequence::xyz);
  Table table({"turns by 30°, 40°, 50° about", "the body's x axis ends at", "apart from x, y, z"});
  const auto add = [&](const std::string& name, const Mat3& R) {
    table.add({name, three_numbers(R.col(0)), number(angle_apart(first, R) / degree, 4) + "°"});
  };
  add("rotating x, y, z", first);
  add("rotating z, y, x", euler_angles_to_matrix(three_angles, EulerSequence::zyx));
  add("rotating z, x, z", euler_angles_to_matrix(three_angles, EulerSequence::zxz));
  add("fixed x, y, z", fixed_angles_to_matrix(three_angles, EulerSequence::xyz));
  return table;
}

/// From the viewer's side: the world's x to the right and a little down, y up, z towards the
/// viewer.
Mat3 viewer() { return axis_rotation(0, 0.35) * axis_rotation(1, -0.5); }

std::string order_figure() {
  const PolygonMesh mesh = objects::mug(1);
  const Vec3 quarter(90 * degree, 90 * degree, 0);
  return support::gallery(
      "a quarter turn about x and one about y, in both orders", mesh, 0.16,
      {{viewer(), "at the start"},
       {viewer() * fixed_angles_to_matrix({90 * degree, 0, 0}, EulerSequence::xyz), "about x"},
       {viewer() * fixed_angles_to_matrix(quarter, EulerSequence::xyz), "about x, then y"},
       {viewer() * fixed_angles_to_matrix(quarter, EulerSequence::yxz), "about y, then x"}});
}

// ── Drift ──

/// A steady turn, whose exact orientation is known: R(t) = exp(t [ω]×).
const Vec3 omega = 2 * Vec3(2, -1, 2).normalized();  // [rad/s]
constexpr double h = 1.0 / 60;                       // a frame of a game [s]

using Flat = Eigen::Matrix<double, 9, 1>;

Flat rate(double, const Flat& y) {
  const Mat3 R = y.reshaped(3, 3);
  return rotation::rotation_dot(R, omega).reshaped();
}

template <class Step>
Mat3 stepped(Step&& step, int steps) {
  Flat y = Mat3(Mat3::Identity()).reshaped();
  for (int i = 0; i < steps; ++i) y = step(rate, i * h, y, h);
  return y.reshaped(3, 3);
}

const auto euler = [](auto&& f, double t, const Flat& y, double step) {
  return runge_kutta::euler_step(f, t, y, step);
};
const auto midpoint = [](auto&& f, double t, const Flat& y, double step) {
  return runge_kutta::midpoint_step(f, t, y, step);
};
const auto rk4 = [](auto&& f, double t, const Flat& y, double step) {
  return runge_kutta::rk4_step(f, t, y, step);
};

Mat3 exact_orientation(int steps) { return exp_rotation(Vec3(omega * (h * steps))); }

Table drift_table() {
  Table table({"method", "after", "‖RᵀR − 1‖", "longest axis", "volume", "orientation off by"});
  const auto add = [&](const std::string& name, auto&& step, int seconds) {
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

std::string sheared_figure() {
  const PolygonMesh mesh = objects::mug(1);
  std::vector<support::Picture> pictures;
  for (const int seconds : {0, 10, 20, 30}) {
    const Mat3 R = stepped(euler, 60 * seconds);
    pictures.push_back(
        {viewer() * R, number(seconds) + " s: volume × " + number(R.determinant(), 3)});
  }
  return support::gallery("Euler steps of Ṙ = [ω]×R, nothing repaired", mesh, 0.42, pictures);
}

std::string drift_figure() {
  support::Plot plot{"drift of a rotation matrix",
                     {"time [s]", support::Scale::log},
                     {"‖RᵀR − 1‖", support::Scale::log},
                     {}};
  const auto add = [&](const std::string& name, auto&& step, auto&& repair) {
    support::Series series{name, {}, {}};
    Flat y = Mat3(Mat3::Identity()).reshaped();
    int next = 1;
    for (int i = 1; i <= 60 * 600; ++i) {
      y = step(rate, i * h, y, h);
      const Mat3 R = repair(Mat3(y.reshaped(3, 3)));
      y = R.reshaped();
      if (i != next) continue;
      next = std::max(next + 1, next * 3 / 2);
      series.x.push_back(i * h);
      series.y.push_back(rotation::orthonormality_error(R));
    }
    plot.series.push_back(series);
  };
  const auto none = [](const Mat3& R) { return R; };
  add("Euler", euler, none);
  add("midpoint", midpoint, none);
  add("RK4", rk4, none);
  add("Euler, one Newton step", euler, rotation::newton_rotation_step);
  add("Euler, Gram–Schmidt", euler, rotation::gram_schmidt);
  return support::to_svg(plot);
}

// ── Repair ──

struct Repair {
  std::string name;
  Mat3 (*apply)(const Mat3&);
};

const std::vector<Repair> repairs{{"Gram–Schmidt", rotation::gram_schmidt},
                                  {"one Newton step", rotation::newton_rotation_step},
                                  {"nearest rotation (SVD)", nearest_rotation}};

/// A drifted matrix: a rotation with every number off by at most `size`.
Mat3 drifted(double size) {
  Mat3 noise;
  noise << 0.8, -0.3, 0.5, -0.9, 0.1, 0.7, 0.2, -0.6, 0.4;
  return exp_rotation(Vec3(0.3, -1.1, 0.7)) + size * noise;
}

Table repair_table() {
  Table table({"drift", "repair", "‖RᵀR − 1‖ before", "after", "numbers changed by ‖R − M‖"});
  for (const double size : {1e-1, 1e-3, 1e-6}) {
    const Mat3 M = drifted(size);
    for (const Repair& repair : repairs) {
      const Mat3 R = repair.apply(M);
      table.add({error_number(size), repair.name, error_number(rotation::orthonormality_error(M)),
                 error_number(rotation::orthonormality_error(R)),
                 support::number((R - M).norm() / size, 4) + " × drift"});
    }
  }
  return table;
}

std::string repair_figure() {
  support::Plot plot{"what one repair leaves",
                     {"‖RᵀR − 1‖ before", support::Scale::log},
                     {"‖RᵀR − 1‖ after", support::Scale::log},
                     {}};
  for (const Repair& repair : repairs) {
    support::Series series{repair.name, {}, {}};
    for (double size = 0.3; size > 1e-9; size /= 3) {
      const Mat3 M = drifted(size);
      series.x.push_back(rotation::orthonormality_error(M));
      series.y.push_back(rotation::orthonormality_error(repair.apply(M)));
    }
    plot.series.push_back(series);
  }
  return support::to_svg(plot);
}

/// One minute of midpoint steps, the matrix repaired every so often.
Table schedule_table() {
  constexpr int steps = 60 * 60;
  Table table({"repair", "every", "‖RᵀR − 1‖ at worst", "orientation off by"});
  const auto add = [&](const Repair& repair, int every) {
    Flat y = Mat3(Mat3::Identity()).reshaped();
    double worst = 0;
    for (int i = 1; i <= steps; ++i) {
      y = midpoint(rate, i * h, y, h);
      const Mat3 R = y.reshaped(3, 3);
      worst = std::max(worst, rotation::orthonormality_error(R));
      if (i % every == 0) y = repair.apply(R).reshaped();
    }
    const Mat3 end = nearest_rotation(Mat3(y.reshaped(3, 3)));
    table.add({repair.name, every == 1 ? "step" : number(every) + " steps", error_number(worst),
               error_number(angle_apart(exact_orientation(steps), end)) + " rad"});
  };
  for (const Repair& repair : repairs)
    for (const int every : {1, 60}) add(repair, every);
  add({"none", [](const Mat3& R) { return R; }}, 1);
  return table;
}

Table times_table() {
  support::Stopwatch stopwatch;
  stopwatch.add("one midpoint step of Ṙ = [ω]×R", [y = Flat(drifted(1e-3).reshaped())]() mutable {
    support::keep(y = midpoint(rate, 0, y, h));
  });
  for (const Repair& repair : repairs)
    stopwatch.add(repair.name, [M = drifted(1e-3), &repair] {
      support::keep(M);
      support::keep(repair.apply(M));
    });
  const std::vector<support::Timing> timings = stopwatch.timings();
  Table table({"what", "time", "midpoint steps"});
  for (const support::Timing& each : timings)
    table.add({each.name, support::duration(each.seconds),
               number(each.seconds / timings[0].seconds, 2) + " ×"});
  return table;
}

}  // namespace

int main(int argc, char** argv) {
  support::Chapter chapter("03_rotation_matrices",
                           "Rotation matrices: the order of turns, drift, and what repairs it");
  chapter.table("order", "The same three angles in different orders", order_table);
  chapter.table("drift", "A steady turn of 2 rad/s in steps of 1/60 s", drift_table);
  chapter.table("repair", "One repair of a drifted matrix", repair_table);
  chapter.table("schedule", "A minute of midpoint steps, repaired now and then", schedule_table);
  chapter.measured("times", "What one repair takes", times_table);
  chapter.figure("order", order_figure);
  chapter.figure("sheared", sheared_figure);
  chapter.figure("drift", drift_figure);
  chapter.figure("repair", repair_figure);
  return chapter.run(argc, argv);
}
