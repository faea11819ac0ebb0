#pragma once
/// @file
/// Motions in closed form, over a span: they cost the same for any span.

#include <algorithm>
#include <cmath>

#include "tumble/core/largest.hpp"
#include "tumble/free_body/free_flow.hpp"
#include "tumble/simulate/no_end.hpp"
#include "tumble/simulate/simulation_task.hpp"
#include "tumble/simulate/trajectory.hpp"
#include "tumble/steady/lagrange_top.hpp"
#include "tumble/steady/steady_path.hpp"

namespace tumble::detail {

/// A path in closed form, and a turning that goes with it.
/// @tparam Turning has at(time since t0) → {q, L}
template <class Turning>
class ClosedFormTrajectory final : public AnyTrajectory<RigidBodyState<>> {
 public:
  /// @param omega about how fast it turns [rad/s]
  ClosedFormTrajectory(const Turning& turning, const steady::SteadyPath& path, double t0, double t1,
                       double omega)
      : turning_(turning), path_(path), t0_(t0), t1_(t1), omega_(omega) {}

  RigidBodyState<> at(double t) const override {
    const auto turned = turning_.at(t - t0_);
    return {path_.x(t - t0_), turned.q, path_.P(t - t0_), turned.L};
  }

  /// Moments between which it does not turn by more than a quarter of a radian.
  std::vector<double> times() const override {
    constexpr double max_parts = 1e6;
    const double parts = std::clamp(std::ceil(4 * omega_ * (t1_ - t0_)), 8.0, max_parts);
    std::vector<double> times;
    times.reserve(static_cast<std::size_t>(parts) + 1);
    for (int i = 0; i < static_cast<int>(parts); ++i)
      times.push_back(t0_ + i * ((t1_ - t0_) / parts));
    times.push_back(t1_);
    return times;
  }

 private:
  Turning turning_;
  steady::SteadyPath path_;
  double t0_, t1_, omega_;
};

/// A closed form of the turning, put over the path.
/// @param report of the turning
/// @throws std::runtime_error if the path leaves the range of doubles on the way
template <class Turning>
Trajectory closed_trajectory(const Turning& turning, const steady::SteadyPath& path, double omega,
                             const SimulationTask& task, SimulationReport report) {
  const double span = task.t1 - task.t0;
  report.error_estimate = largest({report.error_estimate, path.error_bound(span)});
  const auto& turned = turning.at(span);
  require_finite({path.x(span), turned.q, path.P(span), turned.L}, report.error_estimate, task.t1);
  return {
      std::make_shared<const ClosedFormTrajectory<Turning>>(turning, path, task.t0, task.t1, omega),
      task.t0, task.t1, report};
}

/// What nothing turns.
struct FreeTurning {
  FreeRotation rotation;
  Vec3 L;

  steady::LagrangeTop::State at(double t) const { return {orientation_at(rotation, t), L}; }

  const char* name() const {
    constexpr const char* names[] = {"closed form: uniform rotation",
                                     "closed form: free symmetric top",
                                     "closed form: free asymmetric top (elliptic functions)"};
    return names[rotation.index()];
  }
};

/// What nobody asks the turning of.
struct NoTurning {
  steady::LagrangeTop::State start;

  const steady::LagrangeTop::State& at(double) const { return start; }
};

/// What a free turning loses because the moments of a tensor in turned axes are rounded, and the
/// axes with them [rad].
/// @param lost see rounding_of_moments()
double lost_by_turning(const FreeRotation& rotation, double lost, double radians, double span);

Trajectory free_trajectory(const RigidBody<>& body, const PrincipalAxes& axes,
                           const RigidBodyState<>& start, const steady::SteadyPath& path,
                           const SimulationTask& task);

Trajectory particle_trajectory(const RigidBodyState<>& start, const steady::SteadyPath& path,
                               const SimulationTask& task);

Trajectory top_trajectory(const steady::LagrangeTop& top, const RigidBody<>& body,
                          const PrincipalAxes& axes, const RigidBodyState<>& start,
                          const steady::SteadyPath& path, const SimulationTask& task);

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/simulate/closed_trajectories.inl"
#endif
