#pragma once
/// @file
/// One run of a body under any forces, by Dormand and Prince's method of order 8 or, where the
/// scene is stiff, by Radau IIA of order 5.
///
/// Time is counted from the start of the span: a late start costs no digits.

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <type_traits>
#include <vector>

#include "tumble/core/largest.hpp"
#include "tumble/core/step_at.hpp"
#include "tumble/core/step_budget.hpp"
#include "tumble/ode/counted_rhs.hpp"
#include "tumble/ode/dop853_dense.hpp"
#include "tumble/ode/radau5.hpp"
#include "tumble/simulate/scaled_rhs.hpp"
#include "tumble/simulate/stated_error.hpp"
#include "tumble/simulate/trajectory.hpp"

namespace tumble::detail {

/// How a run goes from one end of the span to the other.
struct RunSettings {
  double tolerance;            ///< of a step
  double longest;              ///< step [s]
  std::vector<double> breaks;  ///< times after t0 that no step goes across, ascending [s]
  std::vector<double> guide =
      {};                ///< the ends of another run's steps: what it has seen, see seen()
  bool moved = false;    ///< whether start and time are some roundings beside
  bool stiff = false;    ///< by Radau5
  bool watched = false;  ///< whether to stop where the scene turns out to be stiff
  double most_steps = 1e6;
};

/// Why a run ended.
enum class RunEnd { complete, stiff, too_many_steps };

/// The run.
/// @tparam Rhs a RigidBodyRhs<double, …>
template <class Rhs>
class GeneralTrajectory {
 public:
  static constexpr double error_exponent = 0.5, margin = 1;
  using Numbers = PackedState<double>;

  /// @throws std::runtime_error if a force is not finite, or no step is short enough
  GeneralTrajectory(const ScaledRhs<Rhs>& rhs, const RigidBodyState<>& start, double t0,
                    double span, const RunSettings& settings)
      : rhs_(rhs),
        t0_(t0),
        settings_(settings),
        tolerance_{settings.tolerance, rhs.squares(least_sizes(rhs.body(), span))},
        budget_(0, span, settings.most_steps) {
    constexpr double roundings = 4;
    const double part = settings.moved ? roundings * unit_roundoff : 0;
    late_ = part * std::max(std::abs(t0), std::abs(t0 + span));
    steps_.push_back({0, rhs_.numbers(settings.moved ? beside(start, part) : start)});
    tolerance_.grow(steps_.back().y);
    settings_.breaks.push_back(span);
    for (const double end : settings_.breaks)
      if (end_ == RunEnd::complete) settings.stiff ? follow<Radau5>(end) : follow<Dop853>(end);
  }

  RunEnd end() const { return end_; }
  int steps() const { return static_cast<int>(steps_.size()) - 1; }
  double predicted_steps() const { return budget_.predicted(); }
  double radians() const { return radians_; }

  /// The ends of the steps [s after t0].
  std::vector<double> ends() const {
    std::vector<double> ends;
    for (const Step& step : steps_) ends.push_back(step.s);
    return ends;
  }

  std::vector<double> times(double t1) const {
    std::vector<double> times;
    for (const Step& step : steps_) times.push_back(t0_ + step.s);
    times.back() = t1;
    return times;
  }

  RigidBodyState<> at(double t) const { return rhs_.state(numbers_at(t - t0_)); }

  /// The largest difference at the ends of another run's steps: the angle between orientations
  /// [rad], and all else a part of its largest size on the way.
  double difference(const GeneralTrajectory& other) const {
    const Eigen::Vector4d per_size =
        tolerance_.squares.cwiseMax(other.tolerance_.squares).cwiseSqrt().cwiseInverse();
    double most = 0;
    for (const Step& step : other.steps_)
      most = largest({most, difference(numbers_at(step.s), step.y, per_size)});
    return most;
  }

  /// Moments [s after t0] at which forces are not what the run thinks they are, by more than a part
  /// of its sizes. Wherever nobody has looked for a while, it is looked whether forces depend on
  /// the time; where they do, and now and then, whether the way between the steps' ends obeys them.
  std::vector<double> surprises(double part) const {
    constexpr double looks = 2048;
    constexpr int now_and_then = 16;
    const double per_second = looks / settings_.breaks.back();
    std::vector<double> moments;
    int all = 0;
    for (std::size_t i = 0; i < dense_.size(); ++i) {
      const double begin = steps_[i].s, h = steps_[i + 1].s - begin;
      const int count = static_cast<int>(h * per_second);
      if (count == 0) continue;
      const Timed f = timed(begin);
      const Derived<> there = rhs_.motion(steps_[i].y);
      const Wrench<> then = rhs_.net(f.time(begin), there);
      for (int k = 0; k < count; ++k) {
        // Nearly even, but in step with nothing.
        const double theta = (k + 0.45 + 0.1 * golden_fraction(++all)) / count;
        const double s = begin + theta * h;
        const Wrench<> now = rhs_.net(f.time(s), there);
        const bool same = now.force == then.force && now.torque == then.torque;
        if (same && all % now_and_then != 0) continue;
        const Numbers gap = h * f(s, dense_[i].at(theta)) - dense_[i].slope(theta);
        if (!(tolerance_.part(gap, tolerance_.squares) <= part)) moments.push_back(s);
      }
    }
    return moments;
  }

  void account(SimulationReport& report) const {
    ++report.runs;
    report.steps += steps();
    report.rejected += rejected_;
    report.evaluations += evaluations_;
  }

 private:
  struct Step {
    double s;  ///< [s] after t0
    Numbers y;
  };

  /// f(s, y), which before a break does not look behind it.
  struct Timed {
    const ScaledRhs<Rhs>& rhs;
    double t0, last;

    double time(double s) const { return std::min(t0 + s, last); }
    Numbers operator()(double s, const Numbers& y) const { return rhs(time(s), y); }
  };
  Timed timed(double s) const {
    const auto next = std::upper_bound(settings_.breaks.begin(), settings_.breaks.end() - 1, s);
    constexpr double never = std::numeric_limits<double>::infinity();
    const bool ends = next == settings_.breaks.end() - 1;
    return {rhs_, t0_ + late_, ends ? never : std::nextafter(t0_ + *next, -never)};
  }

  /// At most a few times as long as the guide's steps there: what one run has gone into, no other
  /// jumps over.
  double seen(double s, double h) {
    constexpr double few = 4;
    const std::vector<double>& guide = settings_.guide;
    while (guide_at_ + 2 < guide.size() && guide[guide_at_ + 1] <= s) ++guide_at_;
    for (std::size_t i = guide_at_; i + 1 < guide.size() && guide[i] < s + h; ++i)
      h = std::min(h, std::max(0.0, guide[i] - s) + few * (guide[i + 1] - guide[i]));
    return h;
  }

  static double golden_fraction(int i) {
    const double x = 0.6180339887498949 * i;
    return x - std::floor(x);
  }

  /// From where it is to a break, or to the end.
  template <class Method>
  void follow(double end) {
    double s = steps_.back().s;
    if (!(s < end)) return;
    Numbers y = steps_.back().y;
    const Timed clock = timed(s);
    const runge_kutta::CountedRhs<const Timed> f(clock, evaluations_);
    const Numbers dydt = f(s, y);
    if (!dydt.allFinite()) stop("a force is not finite", s, end - s);
    typename Method::template Stepper<Numbers, MotionTolerance> stepper(tolerance_, dydt);
    double h = initial_step_size(f, s, y, dydt, end - s, Method::error_order, tolerance_);
    while (s != end && end_ == RunEnd::complete) {
      const double shortest = 8 * 0x1p-52 * std::max(s, 0.01 * settings_.breaks.back());
      h = std::max(seen(s, std::min(h, settings_.longest)), shortest);
      const bool last = end - s <= 1.01 * h;
      if (last) h = end - s;
      const runge_kutta::Attempt<Numbers> attempt = stepper.attempt(f, s, y, h);
      if (attempt.accepted()) {
        const double next = last ? end : s + h;
        keep(attempt.y, next, h);
        look_at(stepper, f, s, y, attempt.y, h);
        stepper.tolerances().grow(attempt.y);
        s = next;
        y = attempt.y;
      } else {
        ++rejected_;
        if (h <= shortest)
          stop(attempt.error != attempt.error ? "a force is not finite" : "no step is short enough",
               s, h);
      }
      count_step(s);
      h = attempt.next_h;
    }
    tolerance_ = stepper.tolerances();
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
      if (dense_.size() < max_dense && !settings_.moved)
        dense_.emplace_back(f, s, y, y1, h, stepper.stages_of_step());
      if (settings_.watched && steps() > 100 && steps() % 4 == 0) watch(stepper, y, y1, h);
    }
  }

  /// Source: Hairer & Wanner, "Solving Ordinary Differential Equations II", IV.2; the numbers are
  /// those of Hairer's program dop853.
  template <class Stepper>
  void watch(const Stepper& stepper, const Numbers& y, const Numbers& y1, double h) {
    constexpr double limit_of_stability = 6.1, worth_it = 5000;
    if (stepper.stiffness(y, y1, h) > limit_of_stability) {
      if (++stiff_steps_ >= 15 && budget_.predicted() > worth_it) end_ = RunEnd::stiff;
    } else if (stiff_steps_ > 0) {
      --stiff_steps_;
    }
  }

  void count_step(double s) {
    budget_.count(s);
    if (!budget_.hopeless()) return;
    if (!settings_.stiff)
      refuse_hopeless("simulate", budget_, settings_.most_steps, t0_ + s,
                      "the body turns or swings too often; ask for a shorter time");
    end_ = RunEnd::too_many_steps;
  }

  [[noreturn]] void stop(const char* why, double s, double h) const {
    std::ostringstream text;
    text.precision(std::numeric_limits<double>::max_digits10);
    text << "simulate: " << why << " at t = " << t0_ + s << " with a step of h = " << h
         << ": the motion leaves what the forces are defined for; ask for a shorter time";
    throw_error<std::runtime_error>(text.str());
  }

  Numbers numbers_at(double s) const {
    if (s >= steps_.back().s) return steps_.back().y;
    const std::size_t i = step_at(steps_, s, [](const Step& step) { return step.s; });
    const Step& step = steps_[i];
    const double h = steps_[i + 1].s - step.s;
    if (s == step.s) return step.y;
    if (i < dense_.size()) return dense_[i].at((s - step.s) / h);
    const Timed f = timed(step.s);
    return settings_.stiff ? Radau5::step(f, step.s, step.y, s - step.s)
                           : Dop853::step(f, step.s, step.y, s - step.s);
  }

  static double difference(const Numbers& a, const Numbers& b, const Eigen::Vector4d& per_size) {
    const Eigen::Vector4d p = a.segment<4>(3).normalized(), q = b.segment<4>(3).normalized();
    const double angle =
        2 * (p.dot(q) < 0 ? Eigen::Vector4d(p + q) : Eigen::Vector4d(p - q)).norm();
    const Numbers off = a - b;
    return largest({angle, per_size[0] * off.head<3>().norm(),
                    per_size[2] * off.segment<3>(7).norm(),
                    per_size[3] * off.tail<3>().norm() + angle});
  }

  /// Steps whose way between is kept (42 MB); for later ones it is computed anew.
  static constexpr std::size_t max_dense = 50'000;

  ScaledRhs<Rhs> rhs_;
  double t0_, late_ = 0;
  RunSettings settings_;
  MotionTolerance tolerance_;
  StepBudget budget_;
  std::vector<Step> steps_;
  std::vector<Dop853Dense<Numbers>> dense_;
  double radians_ = 0;
  std::size_t guide_at_ = 0;
  int rejected_ = 0, evaluations_ = 0, stiff_steps_ = 0;
  RunEnd end_ = RunEnd::complete;
};

}  // namespace tumble::detail
