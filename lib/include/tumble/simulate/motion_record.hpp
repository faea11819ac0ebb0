#pragma once
/// @file
/// What a run has found: states at the ends of its steps, and what is between them.
///
/// Time is counted from the start of the span: a late start costs no digits.

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "tumble/core/largest.hpp"
#include "tumble/core/step_at.hpp"
#include "tumble/ode/dop853_dense.hpp"
#include "tumble/simulate/motion_difference.hpp"
#include "tumble/simulate/motion_tolerance.hpp"
#include "tumble/simulate/run_settings.hpp"
#include "tumble/simulate/stiff_step.hpp"

namespace tumble::detail {

/// The steps of a run.
/// @tparam Rhs a ScaledRhs or a ScaledSceneRhs
template <class Rhs>
class MotionRecord {
 public:
  using Numbers = typename Rhs::Numbers;
  using State = typename Rhs::State;

  int steps() const { return static_cast<int>(steps_.size()) - 1; }

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

  State at(double t) const { return rhs_.state(numbers_at(t - t0_)); }

  /// The largest difference at the ends of another run's steps: the angle between orientations
  /// [rad], and all else a part of its largest size on the way.
  double difference(const MotionRecord& other) const {
    return difference(other, tolerance_.squares.cwiseMax(other.tolerance_.squares));
  }

  /// The same, all of it a part of its own size however small that is; 0 if all that moves is large
  /// enough to matter, or so small that it is rounding.
  double difference_of_small(const MotionRecord& other) const {
    SquaredSizes<Numbers> own = squared_sizes(steps_.front().y);
    for (const Step& step : steps_) own = own.cwiseMax(squared_sizes(step.y));
    const SquaredSizes<Numbers> least = rhs_.least_squares(breaks_.back());
    own = (own.array() < least_motion * least_motion * least.array()).select(least, own);
    return (own.array() >= least.array()).all() ? 0 : difference(other, own);
  }

  /// Where forces are not what the run thinks they are, by more than a part of its sizes.
  struct Surprise {
    double s;       ///< [s after t0]
    double effect;  ///< until the next look, a part of the sizes
  };

  /// Wherever nobody has looked for a while, it is looked whether the way between the steps' ends
  /// obeys the forces. After many looks this is done now and then, and otherwise where they depend
  /// on the time, which costs less to see. In a step of Radau5's it is looked whether they depend
  /// on it otherwise than the method could see.
  /// @param looks how often in all, at least
  std::vector<Surprise> surprises(double part, double looks) const {
    constexpr double whole_looks = 0x1p15;
    const int now_and_then = static_cast<int>(std::fmax(1, looks / whole_looks));
    const double per_second = looks / breaks_.back();
    const double shift =
        golden_fraction(static_cast<int>(breaks_.size()) - 1, 0.5);  // not the same twice
    std::vector<Surprise> found;
    int all = 0;
    const std::size_t known = stiff_ ? steps_.size() - 1 : dense_.size();
    for (std::size_t i = 0; i < known; ++i) {
      const double begin = steps_[i].s, h = steps_[i + 1].s - begin;
      const int count = static_cast<int>(h * per_second);
      if (count == 0) continue;
      const Timed f = timed(begin);
      const auto there = rhs_.motion(steps_[i].y);
      const auto then = rhs_.net(f.time(begin), there);
      for (int k = 0; k < count; ++k) {
        // Nearly even, but in step with nothing.
        const double theta = (k + 0.9 * shift + 0.1 * golden_fraction(++all)) / count;
        const double s = begin + theta * h;
        const bool in_turn = !stiff_ && all % now_and_then == 0;
        if (!in_turn && rhs_.net(f.time(s), there) == then) continue;
        const Numbers gap = stiff_
                                ? Numbers(h * unexpected(f, begin, steps_[i].y, h, theta))
                                : Numbers(h * f(s, dense_[i].at(theta)) - dense_[i].slope(theta));
        const double size = MotionTolerance<Numbers>::part(gap, tolerance_.squares);
        if (!(size <= part)) found.push_back({s, size / count});
      }
    }
    return found;
  }

 protected:
  struct Step {
    double s;  ///< [s] after t0
    Numbers y;
  };

  /// f(s, y), which before a break does not look behind it.
  struct Timed {
    const Rhs& rhs;
    double t0, coarse, last;

    /// Rounded as coarsely as the run asks: `coarse` takes the last digits with it, and gives none
    /// of them back.
    double time(double s) const { return std::min(t0 + s + coarse - coarse, last); }
    Numbers operator()(double s, const Numbers& y) const { return rhs(time(s), y); }
  };
  Timed timed(double s) const {
    const auto next = std::upper_bound(breaks_.begin(), breaks_.end() - 1, s);
    constexpr double never = std::numeric_limits<double>::infinity();
    const bool ends = next == breaks_.end() - 1;
    return {rhs_, t0_ + asked_.late, asked_.coarse,
            ends ? never : std::nextafter(t0_ + *next, -never)};
  }

  MotionRecord(const Rhs& rhs, double t0, const AskedTimes& asked, const Numbers& start,
               double span, double tolerance, const std::vector<double>& breaks, bool stiff)
      : rhs_(rhs),
        t0_(t0),
        asked_(asked),
        breaks_(breaks),
        stiff_(stiff),
        tolerance_{tolerance, rhs.least_squares(span)},
        steps_{{0, start}} {
    tolerance_.grow(start);
    breaks_.push_back(span);
  }

  Rhs rhs_;
  double t0_;
  AskedTimes asked_;
  std::vector<double> breaks_;  ///< the end is the last [s after t0]
  bool stiff_;
  MotionTolerance<Numbers> tolerance_;
  std::vector<Step> steps_;
  std::vector<Dop853Dense<Numbers>> dense_;  ///< of the first steps

 private:
  /// What has no size has no difference either.
  double difference(const MotionRecord& other, const SquaredSizes<Numbers>& squares) const {
    const SquaredSizes<Numbers> per_size =
        squares.unaryExpr([](double square) { return square > 0 ? 1 / std::sqrt(square) : 0; });
    double most = 0;
    for (const Step& step : other.steps_)
      most = largest({most, motion_difference(numbers_at(step.s), step.y, per_size)});
    return most;
  }

  static double golden_fraction(int i, double first = 0) {
    const double x = first + 0.6180339887498949 * i;
    return x - std::floor(x);
  }

  Numbers numbers_at(double s) const {
    if (s >= steps_.back().s) return steps_.back().y;
    const std::size_t i = step_at(steps_, s, [](const Step& step) { return step.s; });
    const Step& step = steps_[i];
    const double h = steps_[i + 1].s - step.s;
    if (s == step.s) return step.y;
    if (i < dense_.size()) return dense_[i].at((s - step.s) / h);
    const Timed f = timed(step.s);
    return stiff_ ? inside_stiff_step(f, step.s, step.y, s, tolerance_)
                  : Dop853::step(f, step.s, step.y, s - step.s);
  }
};

}  // namespace tumble::detail
