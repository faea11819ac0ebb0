#pragma once
/// @file
/// Tells early that an integration would never end: from the pace of the steps so far follows how
/// many it would take.

#include <iomanip>
#include <limits>
#include <stdexcept>
#include <string>

#include "tumble/core/require.hpp"

namespace tumble::detail {

/// Counts the steps from t0 to t1, and foretells their number.
class StepBudget {
 public:
  /// @param most that may be taken
  StepBudget(double t0, double t1, double most) : t1_(t1), most_(most), then_(t0) {}

  /// Counts a step that was tried, and led to t.
  void count(double t) {
    if (++steps_ == next_check_) look_ahead(t);
  }

  int steps() const { return steps_; }
  /// How many steps it takes in all, as far as their pace shows.
  double predicted() const { return predicted_; }
  /// How far a step led lately.
  double pace() const { return pace_; }
  /// Whether that is too many: the more have been taken, the more the pace is believed.
  bool hopeless() const {
    const double believed = 0x1p14 / steps_;
    return steps_ >= most_ || predicted_ > most_ * (1 + believed * believed);
  }

 private:
  void look_ahead(double t) {
    pace_ = (t - then_) / (steps_ - before_);
    predicted_ = steps_ + (t1_ - t) / pace_;
    then_ = t;
    before_ = steps_;
    next_check_ *= 2;
  }

  double t1_, most_, then_, predicted_ = 0;
  double pace_ = std::numeric_limits<double>::infinity();
  int steps_ = 0, before_ = 0, next_check_ = 256;
};

/// An integration would not end: programs have advice of their own.
struct TooManySteps : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Ends an integration that would not end.
/// @param who    the function that was asked
/// @param advice what to do
/// @throws TooManySteps that says how many steps it would take, and where it was
[[noreturn]] inline void refuse_hopeless(const char* who, const StepBudget& budget, double most,
                                         double t, const std::string& advice) {
  throw_error<TooManySteps>(
      std::setprecision(3), who, ": too many steps: it would take about ",
      budget.predicted() > budget.steps() ? budget.predicted() : budget.steps(), ", and at most ",
      most, " are taken; stopped at t = ", std::setprecision(9), t, ": ", advice);
}

}  // namespace tumble::detail
