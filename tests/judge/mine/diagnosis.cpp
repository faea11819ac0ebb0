#include "judge/mine/diagnosis.hpp"

#include <algorithm>
#include <cmath>

#include "support/table.hpp"

namespace tumble::judge::mine {

namespace {

using support::error_number;
using support::number;

constexpr double right_mass = 1e-10;  // of its size: rounding, and a thousand faces
constexpr double right_angle = 1e-9;  // [rad], of a closed form
constexpr double same_drift = 1e-6;   // as a fraction of the drift
constexpr double steady = 1e-6;       // a law that is kept, in thousands of steps of RK4

// ── What the engine is made of ──

void look_at_mass(const ProblemResult& result, std::vector<std::string>& found) {
  if (!result.mass.failure.empty())
    found.push_back(
        "8.4 mass_properties, or what it calls (8.1 to 8.3), on this mesh: " + result.mass.failure +
        ". The motion was computed with the true mass properties.");
  else if (result.mass.error > right_mass)
    found.push_back("8.4 mass_properties, or what it calls (8.1 to 8.3), is wrong by " +
                    percent(result.mass.error) +
                    " here. So the engine moves another body, and its error does not go away with "
                    "smaller steps.");
}

std::string name_of_choice(std::optional<Model> model, bool steps) {
  const std::string name = model ? tumble::name_of(*model) : "no model";
  return name + (steps ? ", in steps" : ", without steps");
}

void look_at_choice(const ProblemResult& result, std::vector<std::string>& found) {
  const Problem& problem = result.problem;
  if (!result.chosen.failure.empty()) {
    found.push_back("10.1 choose_model: " + result.chosen.failure + ".");
  } else if (!result.chosen.right) {
    const only_what_a_scene_needs::Choice& choice = *result.chosen.choice;
    found.push_back("10.1 choose_model says “" +
                    name_of_choice(model_of(choice.model), choice.steps) + "”; it is “" +
                    name_of_choice(problem.model, problem.pull.has_value()) + "”.");
  }
}

void look_at_closed_form(const ProblemResult& result, std::vector<std::string>& found) {
  if (!result.closed_form_failure.empty())
    found.push_back("10.2 free_symmetric_top: " + result.closed_form_failure + ".");
  if (!result.closed_form || result.mass.error > right_mass) return;
  const double error = result.closed_form->points.front().error;
  if (!(error <= right_angle))
    found.push_back("10.2 free_symmetric_top is off by " + error_number(error) +
                    " rad at the end, and has no steps to blame.");
}

void look_at_drift(const DriftResult& drift, std::vector<std::string>& found) {
  if (!drift.failure.empty()) {
    found.push_back("10.3 energy_drift: " + drift.failure + ".");
    return;
  }
  const auto same = [&](double own, double right) {
    return std::abs(own - right) <= same_drift * drift.right.largest;
  };
  if (!same(drift.own->largest, drift.right.largest) || !same(drift.own->trend, drift.right.trend))
    found.push_back("10.3 energy_drift finds " + error_number(drift.own->largest) + " and " +
                    error_number(drift.own->trend) + " /s where " +
                    error_number(drift.right.largest) + " and " + error_number(drift.right.trend) +
                    " /s are right.");
}

// ── The curves ──

/// Which laws the finest run breaks, and what that means.
std::string sentence_about(const Invariants& laws) {
  std::string text;
  if (!(laws.momentum <= steady))
    text +=
        " Broken: the angular momentum, by " + percent(laws.momentum) +
        ", although nothing turns the body: the last three numbers of dydt (9.4) are the torque.";
  if (!(laws.length <= steady))
    text += " Broken: |q| = 1, by " + error_number(laws.length) +
            ": q̇ = ½⟨0, ω⟩q turns q and does not stretch it (4.8 quaternion_dot).";
  if (!(laws.energy <= steady)) text += " Broken: the energy, by " + percent(laws.energy) + ".";
  return text;
}

/// With what q turns instead of ω.
std::string sentence_about(const Turning& turning) {
  if (turning.right()) return {};
  const Vec3 &measured = turning.measured, &omega = turning.omega;
  const double close = 0.02 * measured.norm(), factor = measured.dot(omega) / omega.squaredNorm();
  std::string instead = "another way";
  if ((measured - factor * omega).norm() <= close)
    instead = "with " + number(factor, 2) + " ω";
  else if ((measured - turning.R * omega).norm() <= close)
    instead = "as if ω were in body axes";
  return " Broken: q turns with ω. Your q turns " + instead +
         " (4.8 quaternion_dot, 4.1 product; and ω is R I⁻¹Rᵀ L: 5.5, 9.3).";
}

std::string sentence_about_motion(const ProblemResult& result) {
  std::string text = (result.laws ? sentence_about(*result.laws) : "") +
                     (result.turning ? sentence_about(*result.turning) : "");
  if (!text.empty() || !result.laws) return text;
  return result.problem.pull
             ? " Energy and |q| = 1 are kept, and q turns with ω."
             : " Energy, angular momentum and |q| = 1 are kept, and q turns with ω.";
}

std::string sentence_about(const OwnCurve& own) {
  const std::string unit = unit_of(own.method);
  if (!own.failure.empty()) return unit + ", or what it steps: " + own.failure + ".";
  const Point& last = own.curve.points.back();
  std::string text = unit + " is off by " + error_number(last.error) + " rad after " +
                     std::to_string(last.steps) + " steps, where the method is off by " +
                     error_number(own.twin_error) + ".";
  const int order = order_of(own.method);
  if (std::isfinite(own.order) && own.order > 0.5 && own.order < order - 0.5)
    text += " Its error falls with h to the power of " + number(own.order, 2) + ", not of " +
            std::to_string(order) + ".";
  return text;
}

std::string sentence_about_all(const ProblemResult& result, bool first) {
  return (first ? "No method converges to the true motion with smaller steps: "
                  "dydt (9.4), or a function that it calls, is wrong."
                : "In free flight the methods are right, and here they are not: check the forces, "
                  "5.4 net_wrench "
                  "and 5.3 torque, and where 9.4 dydt puts them.") +
         sentence_about_motion(result);
}

using OwnCurves = std::vector<const OwnCurve*>;

void look_at_failures(const OwnCurves& failed, std::size_t methods,
                      std::vector<std::string>& found) {
  const auto same = [&](const OwnCurve* own) { return own->failure == failed.front()->failure; };
  if (failed.size() == methods && methods > 1 && std::all_of(failed.begin(), failed.end(), same))
    found.push_back("All methods fail alike: " + failed.front()->failure +
                    ". So dydt (9.4), or a function that it calls, is wrong.");
  else
    for (const OwnCurve* own : failed) found.push_back(sentence_about(*own));
}

/// Whether none of the methods is right, but for Euler's, in whose error others can hide.
bool all_good_methods(const OwnCurves& wrong, const OwnCurves& failed,
                      const ProblemResult& result) {
  const auto is_euler = [](const OwnCurve* own) { return own->method == Method::euler; };
  const bool euler = std::none_of(wrong.begin(), wrong.end(), is_euler) &&
                     std::none_of(failed.begin(), failed.end(), is_euler);
  return wrong.size() + failed.size() + (euler ? 1u : 0u) == result.own.size();
}

/// @return whether all curves are right
bool look_at_curves(const ProblemResult& result, bool first, std::vector<std::string>& found) {
  OwnCurves wrong, failed;
  for (const OwnCurve& own : result.own) {
    if (!own.failure.empty())
      failed.push_back(&own);
    else if (!own.right())
      wrong.push_back(&own);
  }
  look_at_failures(failed, result.own.size(), found);
  const bool other_body = result.mass.failure.empty() && result.mass.error > right_mass;
  const bool lawful = result.laws && result.laws->energy <= steady;
  if (other_body && lawful) return wrong.empty() && failed.empty();  // that is why
  if (wrong.size() > 1 && all_good_methods(wrong, failed, result))
    found.push_back(sentence_about_all(result, first));
  else
    for (const OwnCurve* own : wrong) found.push_back(sentence_about(*own));
  return wrong.empty() && failed.empty();
}

}  // namespace

std::vector<std::string> diagnose(const Measurement& measurement) {
  std::vector<std::string> found, said;
  bool right_so_far = true;
  for (const ProblemResult& result : measurement.problems) {
    std::vector<std::string> here;
    look_at_mass(result, here);
    look_at_choice(result, here);
    // Code that fails the first problem fails the others for the same reason.
    if (right_so_far)
      right_so_far = look_at_curves(result, &result == &measurement.problems.front(), here);
    look_at_closed_form(result, here);
    for (const std::string& sentence : here) {
      if (std::find(said.begin(), said.end(), sentence) != said.end()) continue;
      said.push_back(sentence);
      found.push_back(result.problem.title + ": " + sentence);
    }
  }
  look_at_drift(measurement.drift, found);
  if (measurement.die) look_at_die(*measurement.die, found);
  return found;
}

std::string percent(double fraction) {
  return std::isfinite(fraction) ? number(100 * fraction, 3) + " %" : "more than can be said";
}

}  // namespace tumble::judge::mine
