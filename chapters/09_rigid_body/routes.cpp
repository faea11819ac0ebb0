/// @file
/// Two routes to the same motion: nine numbers or four for the orientation; a tensor from faces or
/// from points.

#include "as_matrix_state.hpp"
#include "common.hpp"
#include "mug_end.hpp"
#include "parts.hpp"
#include "support/counted.hpp"
#include "tumble/body/matrix_state.hpp"
#include "tumble/mass/point_sampling.hpp"
#include "tumble/mass/random_points.hpp"
#include "tumble/mesh/mesh_solid.hpp"

namespace rigid_body_chapter {

// ── R or q ──

namespace {

template <class Rhs>
rotation::MatrixState<> stepped_by_matrix(const Rhs& motion, const rotation::MatrixState<>& start,
                                          double duration, int steps) {
  return rotation::unpack<double>(integrate_fixed<Rk4>(motion, pack(start), 0, duration, steps));
}

double angle_of(const Mat3& A, const Mat3& B) {
  return log_rotation(Mat3(A.transpose() * B)).norm();
}

/// The orientation by four numbers and by nine, with the same RK4 steps.
struct TwoWays {
  Mat3 by_q, by_R;
};

template <class... Forces>
TwoWays both_ways(const RigidBody<>& body, const RigidBodyState<>& start, double duration,
                  int steps, const Forces&... forces) {
  return {to_matrix(stepped<Rk4>(RigidBodyRhs(body, forces...), start, duration, steps).q),
          stepped_by_matrix(rotation::MatrixStateRhs(body, forces...), as_matrix_state(start),
                            duration, steps)
              .R};
}

void add_ways(Table& table, const std::string& scene, int rate, const TwoWays& ways,
              const Mat3& exact) {
  const Mat3 repaired = nearest_rotation(ways.by_R);
  table.add({scene, std::to_string(rate), error_number(angle_of(ways.by_q, exact)) + " rad",
             error_number(angle_of(repaired, exact)) + " rad",
             error_number(angle_of(ways.by_q, repaired)) + " rad",
             error_number(rotation::orthonormality_error(ways.by_R))});
}

}  // namespace

Table matrix_table() {
  Table table({"scene", "steps per second", "by q: off", "by R: off", "apart", "‖RᵀR − 1‖"});
  const Mat3 handle_end = to_matrix(FreeTrajectory(handle(), handle_start()).at(10).q);
  for (const int rate : {60, 240, 960})
    add_ways(table, "free handle, 10 s", rate, both_ways(handle(), handle_start(), 10, 10 * rate),
             handle_end);
  for (const int rate : {60, 240, 960})
    add_ways(table, "mug, 0.5 s", rate,
             both_ways(mug(), mug_start(), mug_time, rate / 2, weight, spring, drag),
             to_matrix(mug_end().q));
  return table;
}

// ── From faces or from points ──

namespace {

/// The free handle with a tensor that is not quite its own: how far it is off after the time t.
double off_with(const Mat3& I_body, double t) {
  const RigidBody<> body(handle().mass(), I_body);
  RigidBodyState<> start = handle_start();
  const Vec3 omega = derived(handle(), start).omega;
  start.L = angular_momentum(body, to_matrix(start.q), omega);
  return turned_apart(FreeTrajectory(body, start).at(t),
                      FreeTrajectory(handle(), handle_start()).at(t));
}

double moment_error(const Mat3& I) {
  const Mat3& exact = handle().I_body();
  return ((I - exact).diagonal().array() / exact.diagonal().array()).abs().maxCoeff();
}

/// Root mean squares over some sets of random points.
void add_sampled(Table& table, int n) {
  static const MeshSolid solid(handle_object.mesh(handle_object.for_drawings));
  constexpr unsigned sets = 8;
  std::array<double, 3> squares{};
  for (unsigned seed = 1; seed <= sets; ++seed) {
    const Mat3 I = sampling::sample_mass_properties(solid, handle_object.density,
                                                    sampling::RandomPoints(n, seed))
                       .inertia;
    const std::array<double, 3> errors{moment_error(I), off_with(I, 1), off_with(I, 10)};
    for (std::size_t i = 0; i < 3; ++i) squares[i] += errors[i] * errors[i] / sets;
  }
  table.add({std::to_string(n) + " points", error_number(std::sqrt(squares[0])),
             error_number(std::sqrt(squares[1])) + " rad",
             error_number(std::sqrt(squares[2])) + " rad"});
}

}  // namespace

Table sampled_table() {
  Table table({"tensor from", "a moment off by", "orientation after 1 s", "10 s"});
  for (const int n : {1000, 10000, 100000}) add_sampled(table, n);
  MassOptions textbook;
  textbook.accuracy = Accuracy::textbook;
  const Mat3 I = mesh_mass_properties(handle_object.mesh(handle_object.for_drawings),
                                      handle_object.density, textbook)
                     .inertia;
  const auto small = [](double angle) {
    return angle < 1e-12 ? std::string("< 1e-12 rad") : error_number(angle) + " rad";
  };
  table.add({"faces, Mirtich's way", error_or_rounding(moment_error(I)), small(off_with(I, 1)),
             small(off_with(I, 10))});
  return table;
}

}  // namespace rigid_body_chapter
