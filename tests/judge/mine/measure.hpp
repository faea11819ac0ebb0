#pragma once
/// @file
/// What an engine of a student's functions is worth: its curves, what it conserves, and what is not
/// as it should be.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "judge/mine/die.hpp"
#include "judge/mine/invariants.hpp"
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

/// A student's model as the library has it; nothing where the answer is none of the four.
constexpr std::optional<Model> model_of(only_what_a_scene_needs::Model model) {
  using enum only_what_a_scene_needs::Model;
  switch (model) {
    case particle:
      return Model::particle;
    case ball:
      return Model::ball;
    case symmetric_top:
      return Model::symmetric_top;
    case full_body:
      return Model::full_body;
  }
  return {};
}

struct Chosen {
  std::optional<only_what_a_scene_needs::Choice> choice;
  std::string failure;
  bool right = false;
};

struct ProblemResult {
  Problem problem;
  MassResult mass = {};
  Chosen chosen = {};
  std::vector<OwnCurve> own = {};
  std::optional<Curve> closed_form = {};  ///< by 10.2, if that was chosen
  std::string closed_form_failure = {};
  std::vector<Curve> library = {};
  std::optional<Invariants> laws = {};  ///< of the finest run of the best method
  std::optional<Turning> turning = {};  ///< by the best method

  /// The body as the student's mass properties have it, or as it is where they cannot be used.
  MassProperties body() const;
  Setting setting() const;
  RunQuestion question(Method method, int steps) const;
};

struct Measurement {
  std::vector<ProblemResult> problems;
  DriftResult drift;
  std::optional<DieResult> die = {};  ///< if there are functions to drop it
};

/// Asks everything.
/// @param progress is told what comes next
Measurement measure(const OwnEngine& engine,
                    const std::function<void(const std::string&)>& progress);

/// How many states of a run are looked at, beside its start.
inline constexpr int samples = 16;

/// Why no answer came, in words.
std::string text_of(const NoAnswer& why);
/// "Euler", …
std::string name_of(Method method);
/// The function that takes its steps: "1.3 euler_step", …
std::string unit_of(Method method);
std::string number_of(Method method);
inline constexpr const char* closed_form_unit = "10.2";
int order_of(Method method);

}  // namespace tumble::judge::mine
