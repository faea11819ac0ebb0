#pragma once
/// @file
/// One run of a body, or of several, under any forces, by Dormand and Prince's method of order 8
/// or, where the scene is stiff, by Radau IIA of order 5.

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <vector>

#include "tumble/core/step_budget.hpp"
#include "tumble/ode/counted_rhs.hpp"
#include "tumble/simulate/motion_record.hpp"
#include "tumble/simulate/no_end.hpp"
#include "tumble/simulate/stated_error.hpp"
#include "tumble/simulate/stiffness_watch.hpp"
#include "tumble/simulate/trajectory.hpp"

namespace tumble::detail {

/// The run of a ScaledRhs or a ScaledSceneRhs.
template <class Rhs>
class GeneralTrajectory : public MotionRecord<Rhs> {
  using Record = MotionRecord<Rhs>;

 public:
  static constexpr double margin = 1;  ///< steps are as long as the tolerance lets them be
  /// Where forces are rough a smaller tolerance promises nothing: all of the difference counts.
  static constexpr double careful = std::numeric_limits<double>::infinity();
  using typename Record::Numbers, typename Record::State;

  /// @throws std::runtime_error if a force is not finite, or no step is short enough
  GeneralTrajectory(const Rhs& rhs, const State& start, double t0, double span,
                    const RunSettings& settings)
      : Record(rhs, t0,
               AskedTimes::beside(settings.side, std::max(std::abs(t0), std::abs(t0 + span))),
               rhs.numbers(settings.side != Side::none ? beside(start, shift(settings)) : start),
               span, settings.tolerance, settings.breaks, settings.stiff),
        settings_(settings),
        guide_(std::move(settings_.guide)),
        budget_(0, span, settings.max_steps) {
    for (const double end : breaks_)
      while (end_ == RunEnd::complete && steps_.back().s < end)
        settings.stiff ? follow<Radau5>(end) : follow<Dop853>(end);
  }

  RunEnd end() const { return end_; }
  double tolerance() const { return settings_.tolerance; }  ///< of a step
  double predicted_steps() const { return budget_.predicted(); }
  double radians() const { return radians_; }
  bool has_jumped() const { return after_jump_ >= 0; }  ///< the forces
  bool is_rough() const { return rough_; }  ///< whether they jump or bend, as far as steps tell

  /// @throws std::runtime_error that says how many steps it would take
  [[noreturn]] void refuse() const {
    refuse_hopeless("simulate", budget_, settings_.max_steps, t0_ + steps_.back().s,
                    why_so_many(breaks_.size(), budget_, t0_, steps_.back().s, !settings_.watched));
  }

  void account(SimulationReport& report) const {
    ++report.runs;
    report.steps += this->steps();
    report.rejected += rejected_;
    report.evaluations += evaluations_;
  }

 private:
  using Record::breaks_, Record::dense_, Record::rhs_, Record::steps_, Record::t0_,
      Record::tolerance_;

  /// The part of themselves by which numbers are moved.
  static double shift(const RunSettings& settings) {
    return static_cast<int>(settings.side) * 4 * unit_roundoff;
  }

  /// Of the first step behind a break and of the longest, which another run takes as a whole: with
  /// the same steps two runs would make the same errors, and not differ.
  double own_part() const { return settings_.side == Side::none ? 0.6 : 1; }

  /// From where it is to a break, to the end, or across a jump of the forces.
  template <class Method>
  void follow(double end) {
    double s = steps_.back().s;
    Numbers y = steps_.back().y;
    const auto clock = this->timed(s);
    const runge_kutta::CountedRhs<const typename Record::Timed> f(clock, evaluations_);
    const Numbers dydt = f(s, y);
    if (!dydt.allFinite()) stop("a force is not finite", s, end - s);
    typename Method::template Stepper<Numbers, MotionTolerance<Numbers>> stepper(tolerance_, dydt);
    const double longest = std::min(settings_.longest, own_part() * (end - s));
    double h =
        own_part() * initial_step_size(f, s, y, dydt, end - s, Method::error_order, tolerance_);
    int in_vain = 0;  // attempts in turn
    while (s != end && end_ == RunEnd::complete) {
      const double shortest = 16 * unit_roundoff * std::max(s, 0.01 * breaks_.back());
      const double wanted = std::max(guide_.longest(s, std::min(h, longest)), shortest);
      const double next = end - s <= 1.01 * wanted ? end : s + wanted;
      h = next - s;  // as far as the rounded time leads
      const runge_kutta::Attempt<Numbers> attempt = stepper.attempt(f, s, y, h);
      if (attempt.accepted()) {
        keep(attempt.y, next, h);
        look_at(stepper, f, s, y, attempt.y, h);
        stepper.tolerances().grow(attempt.y);
        require_range(stepper.tolerances().squares.maxCoeff(), t0_ + next);
        s = next;
        y = attempt.y;
        in_vain = 0;
      } else {
        ++rejected_;
        rough_ |= ++in_vain >= 3;
        if (wanted <= shortest) {
          cross_jump(stepper, f, attempt, s, next, h);
          break;
        }
      }
      count_step(s);
      h = attempt.next_h;
    }
    tolerance_ = stepper.tolerances();
  }

  /// Across a jump of the forces no step is short enough, but the shortest makes an error no larger
  /// than the rounding of the time makes. Behind it the forces are smooth again: where they are
  /// not, or the step leads away, they grow without bound.
  template <class Stepper, class F>
  void cross_jump(Stepper& stepper, const F& f, const runge_kutta::Attempt<Numbers>& attempt,
                  double s, double next, double h) {
    if (attempt.error != attempt.error) stop("a force is not finite", s, h);
    constexpr double far = 0.01;
    const Numbers y = steps_.back().y;
    const double way = MotionTolerance<Numbers>::part(attempt.y - y, stepper.tolerances().squares);
    if (!std::isfinite(attempt.error) || !(way < far) || this->steps() == after_jump_)
      stop("no step is short enough", s, h);
    keep(attempt.y, next, h);
    if constexpr (requires { stepper.stages_of_step(); }) {
      auto stages = stepper.stages_of_step();
      stages.back() = f(next, attempt.y);
      remember_way(f, s, y, attempt.y, h, stages);
    }
    stepper.tolerances().grow(attempt.y);
    after_jump_ = this->steps();
  }

  void keep(const Numbers& y, double s, double h) {
    steps_.push_back({s, y});
    radians_ += h * rhs_.omega(y);
  }

  /// What DOP853's stages tell beside where the step leads: the way between, and stiffness.
  template <class Stepper, class F>
  void look_at(const Stepper& stepper, const F& f, double s, const Numbers& y, const Numbers& y1,
               double h) {
    if constexpr (requires { stepper.stages_of_step(); }) {
      remember_way(f, s, y, y1, h, stepper.stages_of_step());
      constexpr double worth_it = 5000;  // steps
      if (settings_.watched && StiffnessWatch::looks_at(this->steps()) &&
          watch_.is_stiff(stepper.stiffness(y, y1, h)) && budget_.predicted() > worth_it)
        end_ = RunEnd::stiff;
    }
  }

  /// The way between the ends of the last step; of the rough run, nobody asks for it.
  template <class F, class Stages>
  void remember_way(const F& f, double s, const Numbers& y, const Numbers& y1, double h,
                    const Stages& stages) {
    if (dense_.size() < max_dense && settings_.side == Side::none)
      dense_.emplace_back(f, s, y, y1, h, stages);
  }

  void count_step(double s) {
    budget_.count(s);
    // The first steps of a stiff scene are far shorter than the others: they foretell nothing.
    const bool hopeless =
        settings_.stiff ? budget_.steps() >= settings_.max_steps : budget_.hopeless();
    if (hopeless) end_ = watch_.has_doubts() ? RunEnd::stiff : RunEnd::too_many_steps;
  }

  [[noreturn]] void stop(const char* why, double s, double h) const {
    throw_error<std::runtime_error>(
        std::setprecision(std::numeric_limits<double>::max_digits10), "simulate: ", why,
        " at t = ", t0_ + s, " with a step of h = ", h,
        ": the forces are not defined where the motion leads; ask for a shorter time");
  }

  /// Steps whose way between is kept (42 MB); for later ones it is computed anew.
  static constexpr std::size_t max_dense = 50'000;

  RunSettings settings_;
  StepGuide guide_;
  StepBudget budget_;
  StiffnessWatch watch_;
  double radians_ = 0;
  int rejected_ = 0, evaluations_ = 0;
  bool rough_ = false;
  int after_jump_ = -1;  ///< how many steps there were behind the last jump
  RunEnd end_ = RunEnd::complete;
};

}  // namespace tumble::detail
