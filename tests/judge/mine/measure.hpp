#pragma once
/// @file
/// What an engine of a student's functions is worth: its curves, what it conserves, and what is not
/// as it should be.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "judge/mine/own_engine.hpp"
#include "judge/mine/problem.hpp"

namespace tumble::judge::mine {

/// What 8.4 says of a mesh, and how wrong that is.
struct MassResult {
  std::optional<Timed<mirtich::MassProperties>> own;
  double error = 0;     ///< of mass, centre and inertia, the largest, each relative to its size
  std::string failure;  ///< why it is not used
};

/// A method of the student's on a problem.
struct OwnCurve {
  Method method;
  Curve curve;
  double order = 0;       ///< by which power of the step the error falls at last
  double twin_error = 0;  ///< of the library's method with as many steps as the last point
  std::string failure;    ///< why it ended early
  std::vector<Numbers> states = {};  ///< of the last point

  /// As good as the library's method with the same steps.
  bool right() const;
};

/// By how much at most the states of a run break what has to stay, as fractions.
struct Laws {
  double energy = 0, length = 0, momentum = 0;
};

struct Chosen {
  std::optional<only_what_a_scene_needs::Choice> choice;
  std::string failure;
  bool right = false;
};

struct ProblemResult {
  Problem problem;
  MassResult mass;
  Chosen chosen;
  std::vector<OwnCurve> own;
  std::optional<Curve> closed_form;  ///< by 10.2, if that was chosen
  std::string closed_form_failure;
  std::vector<Curve> library;
  std::optional<Laws> laws;  ///< of the finest run of the best method
};

struct DriftResult {
  std::optional<only_what_a_scene_needs::EnergyDrift> own;
  only_what_a_scene_needs::EnergyDrift right{};
  std::string failure;
};

struct Measurement {
  std::vector<ProblemResult> problems;
  DriftResult drift;
};

/// Asks everything.
/// @param progress is told what comes next
Measurement measure(const OwnEngine& engine,
                    const std::function<void(const std::string&)>& progress);

/// "Euler", …
std::string name_of(Method method);
/// The function that takes its steps: "1.3 euler_step", …
std::string unit_of(Method method);
int order_of(Method method);

}  // namespace tumble::judge::mine
