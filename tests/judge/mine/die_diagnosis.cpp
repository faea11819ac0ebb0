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
    text += " Broken: that it touches. At an impact its lowest corner is " +
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
  if (impact == 0 || impact > die.own->answer.impacts.size()) return {};
  const double left = die.energy_left(impact - 1), right = die.truth.energy_left[impact - 1];
  if (std::abs(left - right) <= right_energy) return {};
  return " Impact " + std::to_string(impact) + " leaves " + percent(left) +
         " of the energy at the start, where " + percent(right) + " are right.";
}

}  // namespace

void look_at_die(const DieResult& die, std::vector<std::string>& found) {
  const std::string start = "The die: ";
  if (!die.failure.empty()) found.push_back(start + die.failure + ".");
  if (die.right() || !die.own) return;
  const std::size_t first = *die.first_wrong();
  const std::string name = "impact " + std::to_string(first + 1);
  const std::string what = first >= die.own->answer.impacts.size()
                               ? name + " never comes."
                               : name + " comes " + error_number(std::abs(die.late(first))) +
                                     " s too " + (die.late(first) > 0 ? "late" : "early") +
                                     ", where an error of the tolerance has grown to " +
                                     error_number(die.truth.grown[first]) + " s.";
  found.push_back(start + what + sentence_about_energy(die, first) + sentence_about(die));
}

}  // namespace tumble::judge::mine
