#pragma once
/// @file
/// Time against error of several ways to one answer, over their settings from coarse to fine. Plain
/// enough for a peer that is no C++20.

#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace tumble::bench {

/// How much time may be spent.
struct Budget {
  double longest_run;        ///< [s]: settings that take longer are not tried
  double longest_of_others;  ///< the same for other software, which has nothing to prove
  int repetitions;
  double seconds;  ///< of each repetition, at least
};

/// Whether a method is told how exact to be, or how many steps to take.
enum class Knob { tolerance, steps };

/// A way to the answer at one setting: what is not part of it has been done.
struct Attempt {
  std::function<double()> run;    ///< what is timed: a number that depends on all that it computes
  std::function<double()> error;  ///< runs once more, and says how far the answer is off
};

/// A method on one problem.
struct Entrant {
  std::string software, name;
  Knob knob;
  double coarsest;  ///< the setting to begin with
  std::function<Attempt(double setting)> prepare;
  double promised = std::numeric_limits<double>::infinity();  ///< the best error, at most
};

/// A setting of a method.
struct Point {
  double setting;
  double error;
  double seconds;  ///< of the processor, the least of all repetitions
};

/// The settings of a method that are more exact than all coarser ones.
struct Curve {
  std::string software, name;
  Knob knob;
  double promised;
  std::vector<Point> points = {};

  bool is_ours() const { return software == "tumble"; }
  std::string full_name() const { return software + ", " + name; }
  double best_error() const;                    ///< ∞ if there is no point
  double seconds_to_reach(double error) const;  ///< the least, ∞ if no point is so exact
};

/// The errors that times are told for.
inline constexpr double marks[] = {1e-3, 1e-6, 1e-9, 1e-12};

/// A curve for each method.
/// @param problem its name, to say what is going on
std::vector<Curve> speed_against_error(const std::string& problem,
                                       const std::vector<Entrant>& entrants, const Budget& budget);

/// Whether each of ours came as close to the truth as it promises.
/// @param quantity what the errors are, and their unit
/// @throws std::invalid_argument that names those that did not
void check_promises(const std::string& problem, const std::string& quantity,
                    const std::vector<Curve>& curves);

}  // namespace tumble::bench
