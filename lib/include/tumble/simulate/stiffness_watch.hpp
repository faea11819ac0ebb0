#pragma once
/// @file
/// Whether a run by an explicit method has come to where stability makes its steps short, not
/// accuracy.

namespace tumble::detail {

/// Looks at some steps, and counts those that are as long as stability lets them be.
/// Source: Hairer & Wanner, "Solving Ordinary Differential Equations II", 2nd ed. (1996), IV.2; the
/// numbers are those of Hairer's program dop853.
class StiffnessWatch {
 public:
  /// Whether it looks at a step.
  static constexpr bool looks_at(int step) { return step > 100 && step % 4 == 0; }

  /// @param stiffness |h λ| of the step
  /// @return whether this has gone on for long enough to be sure
  bool is_stiff(double stiffness) {
    constexpr double limit_of_stability = 6.1;
    constexpr int enough = 15;
    if (stiffness > limit_of_stability) return ++stiff_steps_ >= enough;
    if (stiff_steps_ > 0) --stiff_steps_;
    return false;
  }

  /// Whether the last steps it has seen were such, be it a few.
  bool has_doubts() const { return stiff_steps_ > 0; }

 private:
  int stiff_steps_ = 0;
};

}  // namespace tumble::detail
