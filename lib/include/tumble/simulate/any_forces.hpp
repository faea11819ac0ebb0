#pragma once
/// @file
/// A body, or several, under any forces, to an error over the whole span: two runs and more, see
/// stated_error.hpp, and a witness.
///
/// What acts for a short time may lie between all moments at which a run looks at it. So no step is
/// longer than a part of the span, or of a piece between breaks, another one for each of the two
/// runs, and none is much longer than those of the run before; and between the moments of the
/// better run a witness compares the forces with what it thinks they are. What that finds is a
/// break for new runs.

#include <algorithm>
#include <cmath>
#include <vector>

#include "tumble/simulate/computed_trajectory.hpp"
#include "tumble/simulate/general_trajectory.hpp"
#include "tumble/simulate/growth_of_errors.hpp"
#include "tumble/simulate/late_times.hpp"
#include "tumble/simulate/no_end.hpp"
#include "tumble/simulate/simulation_task.hpp"
#include "tumble/simulate/stated_error.hpp"

namespace tumble::detail {

/// The breaks inside the span, ascending [s after t0].
std::vector<double> breaks_within(const SimulationTask& task);

/// @throws std::invalid_argument if the longest step that is allowed makes too many of them
void require_longest_step(const SimulationTask& task);

/// How often to look for forces that no run has seen. After a surprise we look closer: what comes
/// and goes once may do so again.
double looks_after(int surprises);

/// Runs under any forces, rougher and finer.
/// @tparam Rhs a ScaledRhs or a ScaledSceneRhs
template <class Rhs>
class AnyForces {
 public:
  using Run = GeneralTrajectory<Rhs>;

  AnyForces(const Rhs& rhs, const typename Rhs::State& start, const SimulationTask& task)
      : rhs_(rhs),
        start_(start),
        task_(task),
        span_(task.t1 - task.t0),
        breaks_(breaks_within(task)) {
    require_longest_step(task);
    const double jumps = jumps_by_rounding(rhs, rhs.numbers(start), task, breaks_);
    require_moments(jumps, std::max(std::abs(task.t0), std::abs(task.t1)));
    constexpr double of_jumps = 0.01;
    coarse_ = std::min(of_jumps * jumps, 1e-3);
    lowest_ = std::max(lowest_, coarse_);
    epsilon_ = std::max(epsilon_, lowest_);
  }

  /// The fine run; it meets the tolerance unless rounding forbids.
  TrajectoryOf<typename Rhs::State> trajectory() {
    while (true) {
      const Run rough = run(epsilon_, Side::one);
      if (ends_early(rough)) continue;
      guide_ = rough.ends();
      Run fine = run(0.1 * epsilon_, Side::none);
      if (ends_early(fine)) continue;
      guide_ = fine.ends();
      rough.account(report_);
      fine.account(report_);
      if (is_surprised(fine)) continue;
      TwoRuns both = compared(fine, rough);
      state(both);
      if (rounding_decides(both)) state(without_luck(both, fine));
      growth_.learn(both);
      stiff_works_ = stiff_;
      if (report_.reached() || epsilon_ <= lowest_ || unseen_ > task_.tolerance) {
        if (fine.is_rough())
          report_.error_estimate = error_beside_jumps(report_.error_estimate, task_.tolerance);
        report_.method = stiff_ ? "Radau IIA 5" : "Dormand–Prince 8(5,3)";
        return trajectory_of(std::move(fine), task_, report_);
      }
      epsilon_ = next_epsilon(epsilon_, task_.tolerance, report_.error_estimate, lowest_);
    }
  }

 private:
  Run run(double tolerance, Side side) const {
    const double part = side == Side::none ? 23 : 16;
    RunSettings settings{.tolerance = tolerance,
                         .longest = std::min(task_.longest_step, span_ / part),
                         .breaks = breaks_,
                         .guide = guide_,
                         .side = side,
                         .stiff = stiff_,
                         .watched = !stiff_ && !stiff_in_vain_};
    // A step of Radau5 costs as much as ten.
    if (stiff_) settings.max_steps = std::min(explicit_steps_, most_steps) / 10;
    return Run(rhs_, start_, task_.t0, span_, settings);
  }

  static TwoRuns compared(const Run& fine, const Run& rough) {
    return {.difference = fine.difference(rough),
            .of_small = fine.difference_of_small(rough),
            .epsilon = rough.tolerance(),
            .tolerance = fine.tolerance(),
            .steps = fine.steps(),
            .radians = fine.radians()};
  }

  void state(const TwoRuns& runs) {
    state_errors<Run>(report_, runs, rhs_.lost_moments(), unseen_);
    report_.error_estimate =
        std::max({report_.error_estimate, growth_.of_least(runs.tolerance), rounding_of(runs)});
  }

  /// Whether the stated error is no larger than what rounding makes: of the state, where nothing
  /// finer is left or where errors grow as rougher runs have shown, or of late moments.
  bool rounding_decides(const TwoRuns& runs) const {
    constexpr double of_a_step = 4;           // it rounds a few times
    constexpr double of_late_moments = 1000;  // ten times what forces jump by, see coarse_
    return (!report_.reached() && epsilon_ <= lowest_) ||
           report_.error_estimate < growth_.of_least(of_a_step * rounding_of(runs)) ||
           report_.error_estimate < of_late_moments * coarse_;
  }

  /// Where rounding decides, two runs are now and then close to each other by luck, three seldom:
  /// the third begins at the other side of the start.
  TwoRuns without_luck(TwoRuns runs, const Run& fine) {
    const Run third = run(runs.epsilon, Side::other);
    third.account(report_);
    if (third.end() != RunEnd::complete) return runs;
    const TwoRuns others = compared(fine, third);
    runs.difference = std::max(runs.difference, others.difference);
    runs.of_small = std::max(runs.of_small, others.of_small);
    return runs;
  }

  /// Whether a run ended early; then the next goes another way.
  bool ends_early(const Run& run) {
    if (run.end() == RunEnd::complete) return false;
    run.account(report_);
    guide_.clear();
    if (run.end() == RunEnd::stiff) {
      stiff_ = true;
      explicit_steps_ = run.predicted_steps();
    } else if (stiff_ && !stiff_works_) {
      stiff_ = false;
      stiff_in_vain_ = true;
    } else {
      be_content_with_less(run);
    }
    return true;
  }

  /// Where rounding alone makes steps short, longer ones give the best that there is.
  void be_content_with_less(const Run& run) {
    constexpr double coarsest = 1e-7, coarser = 100;
    if (epsilon_ >= coarsest) run.refuse();
    epsilon_ = lowest_ = std::min(coarsest, coarser * epsilon_);
  }

  /// Whether there are forces that the run has not seen. Their moments become breaks; when that has
  /// been tried often enough, what they do is a part of the error.
  bool is_surprised(const Run& run) {
    constexpr int enough = 8;
    constexpr double least = 1e-11;  // below it, rounding surprises
    constexpr double above_jumps = 10;
    const double part = std::max({task_.tolerance, least, above_jumps * coarse_});
    const auto found = run.surprises(part, looks_after(rounds_ + run.has_jumped()));
    constexpr double doubt = 4;  // a sum of samples
    unseen_ = 0;
    for (const auto& surprise : found) unseen_ += doubt * surprise.effect;
    if (found.empty() || rounds_ == enough) return false;
    ++rounds_;
    for (const auto& surprise : found) breaks_.push_back(surprise.s);
    std::sort(breaks_.begin(), breaks_.end());
    return true;
  }

  Rhs rhs_;
  typename Rhs::State start_;
  SimulationTask task_;
  double span_;
  std::vector<double> breaks_, guide_;
  bool stiff_ = false, stiff_works_ = false, stiff_in_vain_ = false;
  double explicit_steps_ = 0;
  // On random scenes the error is then about a thirtieth of what was asked.
  double lowest_ = 2e-15, coarse_ = 0;
  double epsilon_ = std::clamp(1e-2 * task_.tolerance, lowest_, 1e-3);
  int rounds_ = 0;
  GrowthOfErrors growth_;
  double unseen_ = 0;  ///< what forces do that the fine run has not seen, a part of the sizes
  SimulationReport report_{
      .model = Model::full_body, .why = Rhs::why, .tolerance = task_.tolerance};
};

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/simulate/any_forces.inl"
#endif
