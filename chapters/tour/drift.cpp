// Ten minutes of a game: 60 steps of RK4 a second, and what becomes of the orientation's shape.
#include "support/plot.hpp"
#include "support/stopwatch.hpp"
#include "tour/tour.hpp"
#include "tumble/ode.hpp"
#include "tumble/quaternion.hpp"
#include "tumble/rotation.hpp"

namespace tumble::tour {
namespace {

constexpr double h = 1.0 / 60;  // [s]
constexpr int all_steps = 60 * 60 * 10;
constexpr Spin slow_spin{3.141592653589793, 0.5};  // half a turn a second, well off the axis

/// A run of one representation with one repair.
struct Run {
  std::vector<double> time, shape_error;  ///< at a few dozen moments
  Quat end;                               ///< the orientation that is read off at the end
  double seconds_per_step = 0;
};

bool is_sampled(int step) {
  // 1, 2, 3, 5, 8, … : evenly spread over a log axis.
  static const std::vector<int> moments = [] {
    std::vector<int> list{1};
    while (list.back() < all_steps) list.push_back(std::max(list.back() + 1, list.back() * 8 / 5));
    list.back() = all_steps;
    return list;
  }();
  return std::binary_search(moments.begin(), moments.end(), step);
}

/// Steps a state on; `repair` gives the state to go on with, `shape_error` how far it is
/// from a rotation.
template <class Rhs, class State, class Repair, class ShapeError>
State run(const Rhs& motion, State y, Repair&& repair, ShapeError&& shape_error, Run& result) {
  for (int step = 1; step <= all_steps; ++step) {
    y = repair(runge_kutta::rk4_step(motion, h * (step - 1), y, h));
    if (!is_sampled(step)) continue;
    result.time.push_back(h * step);
    result.shape_error.push_back(shape_error(y));
  }
  return y;
}

/// Times the bare steps, without the bookkeeping of run().
template <class Rhs, class State, class Repair>
double seconds_per_step(const Rhs& motion, const State& start, Repair&& repair) {
  constexpr int timed = 1000;
  const double seconds = support::shortest_run(0.02, [&] {
    State y = start;
    for (int step = 0; step < timed; ++step)
      y = repair(runge_kutta::rk4_step(motion, h * step, y, h));
    support::keep(y);
  });
  return seconds / timed;
}

template <class Repair>
Run run_matrix(const RigidBody<>& body, const RigidBodyState<>& start, Repair&& repair) {
  const rotation::MatrixStateRhs motion(body);
  const rotation::PackedMatrixState<double> y0 =
      pack(rotation::MatrixState<>{start.x, to_matrix(start.q), start.P, start.L});
  const auto repaired = [&](const rotation::PackedMatrixState<double>& y) {
    rotation::MatrixState<> state = rotation::unpack<double>(y);
    state.R = repair(state.R);
    return pack(state);
  };
  Run result;
  const rotation::PackedMatrixState<double> y = run(
      motion, y0, repaired,
      [](const rotation::PackedMatrixState<double>& z) {
        return rotation::orthonormality_error(rotation::unpack<double>(z).R);
      },
      result);
  result.end = from_matrix(nearest_rotation(rotation::unpack<double>(y).R));
  result.seconds_per_step = seconds_per_step(motion, y0, repaired);
  return result;
}

template <class Repair>
Run run_quaternion(const RigidBody<>& body, const RigidBodyState<>& start, Repair&& repair) {
  const RigidBodyRhs motion(body);
  const auto repaired = [&](const PackedState<double>& y) {
    RigidBodyState<> state = unpack<double>(y);
    state.q = repair(state.q);
    return pack(state);
  };
  // q p q* scales by |q|², so that the matrix it stands for is off by √3 | |q|⁴ − 1 |.
  const auto shape_error = [](const PackedState<double>& y) {
    const double n = unpack<double>(y).q.squaredNorm();
    return std::sqrt(3.0) * std::abs(n * n - 1);
  };
  Run result;
  const PackedState<double> y = run(motion, pack(start), repaired, shape_error, result);
  result.end = rotation::normalize(unpack<double>(y).q);
  result.seconds_per_step = seconds_per_step(motion, pack(start), repaired);
  return result;
}

}  // namespace

void show_drift(const Subject& subject, Output& output) {
  const RigidBody<> body(subject.exact);
  const RigidBodyState<> start = spinning(body, slow_spin);
  progress("reference orientation after " + std::to_string(all_steps) + " steps");
  const Quat exact = unpack<double>(integrate_adaptive<Dop853>(RigidBodyRhs(body), pack(start), 0.0,
                                                               h * all_steps, {1e-14, 1e-14})
                                        .y)
                         .q;

  support::Table table(
      {"orientation", "repair each step", "shape error", "orientation error [rad]", "time a step"});
  support::Plot plot{
      "drift of the orientation",
      {"time [s]", support::Scale::log},
      {"distance from a rotation, ‖RᵀR − 1‖ (0 drawn as 10⁻¹⁶)", support::Scale::log},
      {}};
  const auto add = [&](const std::string& kind, const std::string& repair, const Run& result) {
    table.add({kind, repair, support::error_number(result.shape_error.back()),
               support::error_number(angle_between(result.end, exact)),
               support::duration(result.seconds_per_step)});
    support::Series series{kind + ", " + repair, result.time, result.shape_error};
    for (double& error : series.y) error = std::max(error, 1e-16);
    plot.series.push_back(series);
  };
  progress("drift of the matrix and of the quaternion");
  add("matrix", "none", run_matrix(body, start, [](const Mat3& R) { return R; }));
  add("matrix", "Gram–Schmidt", run_matrix(body, start, rotation::gram_schmidt));
  add("matrix", "Newton step", run_matrix(body, start, rotation::newton_rotation_step));
  add("matrix", "polar by SVD", run_matrix(body, start, nearest_rotation));
  add("quaternion", "none", run_quaternion(body, start, [](const Quat& q) { return q; }));
  add("quaternion", "normalise", run_quaternion(body, start, rotation::normalize));
  output.show("Drift: ten minutes of RK4 at 60 steps a second, half a turn a second", table,
              "drift");
  output.write("drift.svg", support::to_svg(plot));
}

}  // namespace tumble::tour
