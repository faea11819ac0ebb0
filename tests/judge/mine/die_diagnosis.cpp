#include <cmath>

#include "judge/mine/diagnosis.hpp"
#include "support/table.hpp"

namespace tumble::judge::mine {

namespace {

using support::error_number;

constexpr double right_height = 4;       // tolerances, of a corner that touches
constexpr double right_sideways = 1e-9;  // a dozen impulses, each rounded
constexpr double right_energy = 1e-6;    // as a part of that at the start

/// Which laws its impacts break.
std::string sentence_about(const DieResult& die) {
  const DieLaws laws = die.laws();
  std::string text;
  if (!(laws.height <= right_height * die.question.tolerance))
    text += " Broken: that a corner touches. At an impact the lowest one is " +
            error_number(laws.height) +
            " m from the table: 11.2 separation gives the gap, 11.3 first_contact the time.";
  if (!(laws.sideways <= right_sideways))
    text += " Broken: P along the table and L about its normal, by " + percent(laws.sideways) +
            ": without friction the impulse is along the normal (11.5 collide, 11.2 separation).";
  if (!(laws.energy <= right_energy))
    text += " Broken: the energy, which rises by " + percent(laws.energy) +
            " in an impact: 11.4 contact_matrix, 11.5 collide.";
  return text;
}

/// Whether the impact before left too much, or too little.
std::string sentence_about_energy(const DieResult& die, std::size_t impact) {
  if (impact == 0 || impact > die.common()) return {};
  const TrueImpact& before = die.truth.impacts[impact - 1];
  const std::string left = percent(die.energy_left(impact - 1)),
                    right = percent(before.energy_left);
  const double off = std::abs(die.energy_left(impact - 1) - before.energy_left);
  if (left == right || off <= 100 * before.energy_grown) return {};
  return " Impact " + std::to_string(impact) + " leaves " + left +
         " of the energy that it had at the start, where " + right + " is right.";
}

std::string sentence_about_time(const DieResult& die, std::size_t impact) {
  const std::string name = "impact " + std::to_string(impact + 1);
  if (impact >= die.common()) return name + " never comes.";
  const double late = die.late(impact);
  return name + " comes " + error_number(std::abs(late)) + " s too " +
         (late > 0 ? "late" : "early") + ", where an error of the tolerance has grown to " +
         error_number(die.truth.impacts[impact].grown) + " s.";
}

}  // namespace

void look_at_die(const DieResult& die, std::vector<std::string>& found) {
  const std::string start = "The die: ";
  if (!die.failure.empty()) found.push_back(start + die.failure + ".");
  if (die.right() || !die.own) return;
  const std::size_t first = *die.first_wrong();
  found.push_back(start + sentence_about_time(die, first) + sentence_about_energy(die, first) +
                  sentence_about(die));
}

}  // namespace tumble::judge::mine
